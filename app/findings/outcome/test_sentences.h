// Reports the tests of a study in sentences for a paper.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/study_test.h"

namespace asperity {

/// "exact", or how many permutations were drawn; empty for a test that permutes nothing.
std::string permutations_text(const StudyTest& test);

/// "F(2, 38) = 5.17"; with an ε that corrects the degrees of freedom "F(1.54, 29.18) = 5.17, ε = .77".
std::string statistic_text(std::string_view symbol, std::span<const double> degrees, double value,
                           std::optional<double> epsilon = {});

/// "d = 2.74 [1.75, 3.71]"; without an interval where a limit is absent.
struct EffectInterval {
  std::optional<double> low{};
  std::optional<double> high{};
  std::string_view before = " ";  ///< between the value and the bracket
};
std::string effect_text(std::string_view symbol, double value, const EffectInterval& interval);

/// The result of a test of this kind of protocol, with its numbers: "The mean proportion correct
/// was significantly above the chance level: mean proportion correct = 89 %, 95 % CI [54 %, 97 %],
/// N = 6; one-sample t test, t(5) = 10.28, p < .001, Holm-corrected; Cohen’s d = 4.20, 95 % CI
/// [1.56, 6.83]." One that is not confirmatory claims no significance: "In an exploratory test, the
/// mean proportion correct was above the chance level: …". For a test that could not be made, that
/// fact and the reason. Where the test contradicts an interval: "It was not established that the mean proportion correct was above
/// the chance level: …".
TestSentence sentence_of_test(const StudyTest& test, std::string_view kind);

/// Adds to the sentence of a confirmatory test, before its full stop, the means that show the direction of its effect.
void state_means(AnalysisOutcome& outcome, std::string_view test, const std::string& means,
                 const TestSubject& about);

/// "p = .031, uncorrected"; for the family "p = .062, Holm-corrected", or "p = .062, the only
/// confirmatory test". Where no p of 5 % could be attained, with the smallest attainable one and, where it is known, the
/// number of participants with which it is below 5 %.
/// Without a declaration no test is confirmatory.
Phrase p_text(const StudyTest& test);
/// An answer, and after it the participants with a difference of zero: a signed-rank test leaves them out, so that its n is
/// smaller than the number of participants; they do not affect the p of a sign-flip test.
Phrase with_zero_differences(const Phrase& answer, const StudyTest& test);
/// "the 95 % CI of the mean contains the chance level"
Phrase chance_in_interval();
/// The estimate that a significant test contradicts, as a clause: "the 95 % CI of the difference contains 0"; empty where there
/// is none.
Phrase contradiction_text(const StudyTest& test);
/// An answer, and after it that nothing is established, where the test contradicts an interval.
Phrase with_contradiction(const Phrase& answer, const StudyTest& test);
/// The answers that a test that was made may give: `claim` if it is confirmatory and significant, `nothing` if it belongs
/// to a family and is not significant, and `told` for a test from which nothing is concluded, because it is exploratory, as the
/// sentence that is added to it states. `with_zero_differences` holds for all
/// of a signed-rank test.
struct TestStatements {
  Phrase claim{};
  Phrase nothing{};
  Phrase told{};

  /// Each of them with what `added` adds to an answer.
  template <typename Added>
  TestStatements with(const Added& added) const {
    return {added(claim), added(nothing), added(told)};
  }
};
/// The numbers of a test, stated in each of its answers, and how these begin: %1 is the numbers, %2 p.
struct StatedNumbers {
  /// A sentence without its beginning: "the mean rating is highest for wood. Friedman test: p = .020."
  Phrase numbers{};
  Phrase significant = phrase("Analysis", "Yes: %1");
  Phrase not_significant = phrase("Analysis", "Not significantly: %1");
  /// Where the test contradicts an estimate; %3 is `contradiction_text`.
  Phrase not_established = phrase("Analysis",
                                  "Not established: %1 The test is significant, but %3; more "
                                  "participants are needed.");
  Phrase exploratory =
      phrase("Analysis", "For these participants, %1");  ///< empty: the numbers alone
  bool compares = false;  ///< a result that is not significant could be taken for equality
  Phrase claim{};  ///< in place of the significant answer; states itself what is not established
};
TestStatements statements_of(const StudyTest& test, const StatedNumbers& stated);
Phrase said_of(const StudyTest& test, const TestStatements& statements);

}  // namespace asperity
