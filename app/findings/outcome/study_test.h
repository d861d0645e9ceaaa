// One test of a study.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/test_methods.h"

namespace asperity {

/// A test with its numbers and, once StudyTests has finished, its correction.
struct StudyTest {
  /// The level of significance.
  static constexpr double kLevel = 0.05;

  std::string name{};  ///< the name of a KindTest
  TestSubject about{};
  const TestMethod* made_by = nullptr;
  std::string method{};
  std::size_t n = 0;  ///< of the units that contributed
  std::string unit{kUnitOfParticipants};
  /// Participants who responded and do not contribute, because they have nothing that can be
  /// exchanged.
  std::size_t left_out = 0;
  /// Participants whose two values are equal, which a signed-rank test drops; n does not count them.
  std::size_t ties = 0;
  /// Participants whose difference is not zero, in a test that permutes the signs of the differences. The n of a sign-flip
  /// test also counts those with a difference of zero, who do not affect its p.
  std::optional<std::size_t> differing{};
  Phrase why_left_out{};  ///< a sentence without its end
  std::optional<double> p{};
  FindingName source{};  ///< the finding that has its p
  /// The smallest attainable p, Holm-corrected for a test of the family: above 5 %, significance
  /// is impossible.
  std::optional<double> smallest_p{};
  /// Where significance is impossible, the number of participants with a difference other than zero with which it would be
  /// possible; nothing where it is unknown.
  std::optional<std::size_t> required_n{};
  std::optional<double> statistic{};
  std::vector<double> degrees{};  ///< of freedom: none, one, or two of an F; uncorrected
  /// The ε that corrects them; nothing where they are not corrected.
  std::optional<double> epsilon{};
  std::optional<std::size_t> random_permutations{};  ///< 0: all were counted; nothing: not permuted
  /// Group labels are exchanged within the blocks in which the program assigned the groups.
  bool permutes_within_blocks = false;
  struct Effect {
    double value = 0.0;
    std::optional<double> low{};
    std::optional<double> high{};
    bool takes_trials_as_independent = false;  ///< in a test of participants
  };
  std::optional<Effect> effect{};
  std::optional<Effect> estimate{};  ///< the proportion that is tested
  std::optional<double> chance{};    ///< the chance level of that proportion
  bool chance_varies = false;        ///< between trials; `chance` is its mean over the participants
  std::optional<Effect>
      in_units{};  ///< the effect in the unit of the responses, where it was stated
  std::string_view name_in_units{};  ///< "ratio", "difference of proportions"
  /// What a stated estimate holds against the effect, as a clause: "the 95 % CI of the ratio contains 1"; empty: nothing.
  Phrase objection{};
  std::optional<double> adjusted{};  ///< within the family
  bool is_alone_in_family = false;   ///< the only test of its family, so that p is not corrected
  TestRole role = TestRole::exploratory;
  bool pools_participants = false;  ///< n counts responses of more than one participant
  std::string status = "ok";

  /// Participants with a difference of zero, counted in n or not.
  std::size_t zero_differences() const noexcept {
    return ties + (differing && *differing < n ? n - *differing : 0);
  }
  /// Whether it allows a conclusion: only a test of a family that the protocol declares does.
  bool shows() const noexcept { return role == TestRole::confirmatory && is_significant(); }
  /// For tests outside the family without correction.
  bool is_significant() const noexcept { return adjusted ? *adjusted < kLevel : p && *p < kLevel; }
  /// Negative where the second of two is the larger one, or the proportion is below the chance level.
  double direction() const noexcept {
    // A sum of ranks has no sign; its effect size has.
    return made_by != nullptr && made_by->direction_is_of_effect && effect
               ? effect->value
               : statistic.value_or(0.0);
  }
  /// Significant, although an estimate that is stated with it, which comes from a different method, does not show the effect:
  /// the interval of the tested proportion contains the chance level, or `objection`. Nothing is established.
  bool contradicts_interval() const noexcept {
    const bool has_chance_in_interval = chance && estimate && estimate->low && estimate->high &&
                                        *estimate->low <= *chance && *chance <= *estimate->high;
    return is_significant() && (!objection.empty() || has_chance_in_interval);
  }
  /// The smallest attainable p, if it exceeds the level.
  std::optional<double> unattainable_p() const noexcept {
    return smallest_p && *smallest_p > kLevel ? smallest_p : std::nullopt;
  }
};

}  // namespace asperity
