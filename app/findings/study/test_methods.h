// The tests that studies report: the standard name of each, its statistic and its effect size.

#pragma once

#include <array>
#include <span>
#include <string_view>

#include "app/words/phrase.h"

namespace asperity {

/// What the n of a test counts where it is of participants.
inline constexpr std::string_view kUnitOfParticipants = "participants";

/// How a test is reported. Its numbers stand among the findings of one analysis under one key: that of
/// the p, with these quantities.
struct TestMethod {
  std::string_view p{};       ///< the quantity that is its p
  std::string_view code{};    ///< fixed, for programs: "one_sample_t"
  Phrase name{};              ///< as textbooks name it: "one-sample t test"
  std::string_view unit{};    ///< what its n counts: "participants", "answers"
  std::string_view symbol{};  ///< of the statistic: "t"
  Phrase symbol_name{};       ///< what it stands for; empty of those that need no explanation
  std::string_view statistic{};
  std::array<std::string_view, 2> degrees{};  ///< of freedom; empty where it has none
  std::string_view epsilon{};  ///< that corrects both degrees of freedom; empty where nothing does
  /// How many random permutations stand for all of them, 0 or absent where all were counted; empty
  /// where the test permutes nothing.
  std::string_view draws{};
  /// The smallest p that these data could give; empty where every p is possible.
  std::string_view smallest{};
  std::string_view effect_symbol{};  ///< "d"
  Phrase effect_name{};              ///< "Cohen's d"; empty where the symbol is a word
  std::string_view effect{};         ///< the effect size, whose finding has its interval
  bool effect_is_bounded = false;    ///< cannot exceed 1: printed as `reading_bounded`
  std::string_view estimate{};       ///< the proportion that is tested; empty where there is none
  std::string_view estimate_name{};  ///< "mean proportion correct"
  std::array<std::string_view, 2>
      sources{};  ///< keys of references.h, of the test and the effect size
  /// How often such intervals contained the true value in simulations (docs/analysis.md), where that is less than 93 %
  /// or more than 97 %; empty of others.
  Phrase coverage{};
};

/// All of them, by `p`.
std::span<const TestMethod> test_methods();

/// Null where no test has such a p.
const TestMethod* test_method(std::string_view p);

/// Whether the effect size with this symbol cannot exceed 1.
bool is_bounded_effect(std::string_view symbol);

/// The name of the test with this code; empty where there is none.
Phrase test_method_name(std::string_view code);

}  // namespace asperity
