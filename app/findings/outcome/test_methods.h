// Lists the tests that studies report: the standard name of each, its statistic and its effect
// size.

#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "analysis/words/phrase.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// The unit of the n of a test of participants.
inline constexpr std::string_view kUnitOfParticipants = "participants";
/// Responses, of all participants together.
inline constexpr std::string_view kUnitOfAnswers = "answers";

/// The alternatives that a test considers.
enum class TestSides {
  undirected,  ///< any difference among several: an analysis of variance, a test of independence
  two_sided,
  one_sided,
};

/// How a test is reported. Its numbers are findings of one analysis under one key: the key of the
/// p, with these quantities.
struct TestMethod {
  QuantityName p{};         ///< the quantity that is its p
  std::string_view code{};  ///< fixed, for programs: "one_sample_t"
  TestSides sides = TestSides::undirected;
  Phrase name{};              ///< the textbook name: "one-sample t test"
  std::string_view unit{};    ///< the unit of its n: "participants", "answers"
  std::string_view symbol{};  ///< of the statistic: "t"
  Phrase symbol_name{};       ///< the meaning of the symbol; empty where it needs no explanation
  QuantityName statistic{};
  std::array<QuantityName, 2> degrees{};  ///< of freedom; empty where it has none
  /// The ε that corrects both degrees of freedom; empty without such a correction.
  QuantityName epsilon{};
  /// The number of permutations drawn at random, 0 or absent where all were enumerated; empty where
  /// the test permutes nothing.
  QuantityName draws{};
  /// The smallest attainable p; empty where every p is possible.
  QuantityName smallest{};
  /// The number of participants whose difference is not zero, in a test that permutes the signs of the participants'
  /// differences: with k of them the smallest p is 2^(1 − k). Empty for other tests.
  QuantityName differing{};
  std::string_view effect_symbol{};  ///< "d"
  Phrase effect_name{};              ///< "Cohen's d"; empty where the symbol is a word
  QuantityName effect{};             ///< the effect size, whose finding has its interval
  bool effect_is_bounded = false;    ///< cannot exceed 1: printed by `display_bounded`
  /// Its sign, and not that of the statistic, is the direction of a difference.
  bool direction_is_of_effect = false;
  QuantityName estimate{};           ///< the proportion that is tested; empty where there is none
  std::string_view estimate_name{};  ///< "mean proportion correct"
  std::array<std::string_view, 2>
      sources{};  ///< keys of references.h, for the test and the effect size
  /// The coverage of such intervals in simulations (docs/analysis.md), where it is less than 93 %
  /// or more than 97 %; otherwise empty.
  Phrase coverage{};
};

/// All methods, by `p`.
std::span<const TestMethod> test_methods();

/// Null where no test has such a p.
const TestMethod* test_method(std::string_view p);

/// Whether the effect size with this symbol cannot exceed 1.
bool is_bounded_effect(std::string_view symbol);

/// The name of the test with this code; empty where there is none.
Phrase test_method_name(std::string_view code);

/// The name in English with the sides of the test, "paired t test, two-sided", "Friedman test, non-directional".
std::string text_with_sides(const TestMethod& method);
/// The same of the test with this code; the code where there is none.
std::string text_with_sides(std::string_view code);

}  // namespace asperity
