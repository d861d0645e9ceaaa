// Calls the family `equivalence` with the declared margin, or states the margin that the data would support.

#include "app/findings/shared/group_equivalence.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

namespace {

/// The table for the family `equivalence`, with the declared bounds; nothing where a group is
/// empty.
std::optional<TidyInput> table_of_proportions(const ParticipantPair& pair,
                                              const GatheredAnswers& gathered,
                                              std::span<const std::optional<double>> proportions) {
  PairRows rows(gathered, pair);
  NumberColumn values{};
  for (std::size_t i = 0; i < gathered.people.size(); ++i) {
    if (proportions[i] && rows.add(i)) values.push_back(*proportions[i]);
  }
  std::optional<TidyInput> input = std::move(rows).take({{"value", std::move(values)}});
  if (!input) return std::nullopt;
  if (const std::optional<double> margin = gathered.declared.equivalence_margin) {
    input->options.set("lower", -*margin);
    input->options.set("upper", *margin);
  }
  return input;
}

/// Rounds up, so that the margin is never smaller than the one that the data support: 44.02 becomes
/// 44.1.
std::string points_rounded_up(double difference) {
  return display_points(std::ceil(1000.0 * difference - 1e-9) / 1000.0);
}

/// Names only the methods that were computed.
Phrase equivalence_method(const FoundNumbers& found) {
  if (!found.value("equivalence.margin")) return {};
  const Phrase bayes =
      phrase("Analysis",
             "Bayes factor of the pooled t with a Cauchy prior of scale √2/2 on the standardised "
             "difference; values below 1 favour no difference.");
  if (!found.value("tost.p")) {
    return phrase("Analysis",
                  "Welch's 90 % CI of the difference of the participants' proportions. %1")
        .with(bayes);
  }
  return phrase("Analysis",
                "Two one-sided Welch t tests of the participants' proportions, each at 5 %: they "
                "show equivalence where the 90 % CI lies within the margin. %1")
      .with(bayes);
}

Phrase equivalence_answer(const ParticipantPair& pair, const FoundNumbers& found,
                          const std::optional<double>& margin) {
  const std::optional<double> supported = found.value("equivalence.margin");
  if (!supported) {
    return phrase("Analysis",
                  "This cannot be assessed: a group has one participant, or all participants "
                  "of each group have the same value.");
  }
  const Finding& difference = *found.find("diff");
  const Phrase numbers =
      phrase("Analysis",
             "difference (%6 − %7) = %1 percentage points, 90 % CI [%2, %3], N = %4 "
             "participants; JZS Bayes factor for a difference BF₁₀ = %5")
          .with(display_points(*difference.value), display_points(*difference.low),
                display_points(*difference.high), std::to_string(difference.n),
                display_number(*found.value("jzs.bf10", "0.7071")), pair.first_name,
                pair.second_name);
  if (!margin && *supported >= 1.0) {  // Welch's interval is not bounded, but the difference is
    return phrase("Analysis",
                  "The protocol declares no equivalence margin, so equivalence is not assessed: "
                  "%1. The data would not support equivalence within any margin: the CI reaches "
                  "±100 percentage points, the largest possible difference.")
        .with(numbers);
  }
  if (!margin) {
    return phrase("Analysis",
                  "The protocol declares no equivalence margin, so equivalence is not assessed: "
                  "%1. The data would support equivalence within ±%2 percentage points.")
        .with(numbers, points_rounded_up(*supported));
  }
  const bool equivalent = found.find("equivalent")->word == "TRUE";
  return (equivalent
              ? phrase(
                    "Analysis",
                    "The 90 % CI lies within ±%1 percentage points: %2; two one-sided tests, %3, "
                    "uncorrected. This test is exploratory.")
              : phrase("Analysis",
                       "The 90 % CI does not lie within ±%1 percentage points: %2; two one-sided "
                       "tests, %3, uncorrected. This test is exploratory."))
      .with(display_points(*margin), numbers, display_p(*found.value("tost.p")));
}

}  // namespace

void ask_equivalence(const ParticipantPair& pair, const GatheredAnswers& gathered,
                     std::span<const std::optional<double>> proportions, AnalysisOutcome& outcome) {
  std::optional<TidyInput> table = table_of_proportions(pair, gathered, proportions);
  if (!table) return;
  const std::vector<Finding> findings =
      analysis_of(pair.equivalence.c_str(), "equivalence", std::move(*table));
  keep_findings(findings, outcome);
  const FoundNumbers found(findings);
  add_question(outcome, pair.equivalence.c_str(), pair.equivalence_question,
               equivalence_answer(pair, found, gathered.declared.equivalence_margin),
               equivalence_method(found), "", found.find("diff"));
}

}  // namespace asperity
