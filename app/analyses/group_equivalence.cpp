#include "app/analyses/group_equivalence.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/number_text.h"
#include "app/analyses/reading_number.h"
#include "app/analyses/study_findings.h"

namespace asperity {

namespace {

/// A table of the family `equivalence`, with the declared bounds; nothing where a group is empty.
std::optional<TidyInput> sexes_table(const GatheredAnswers& gathered,
                                     std::span<const std::optional<double>> proportions) {
  std::string text = "subject,group,value\n";
  std::set<std::string> groups{};
  for (std::size_t i = 0; i < gathered.people.size(); ++i) {
    const std::string sex = gathered.people[i].sex.value_or("");
    if ((sex != "F" && sex != "M") || !proportions[i]) continue;
    groups.insert(sex);
    text += gathered.people[i].label + ',' + sex + ',' + number_text(*proportions[i]) + '\n';
  }
  if (groups.size() < 2) return std::nullopt;
  TidyInput input{};
  input.tables.emplace_back(text, "the participants");
  input.options.add("groups", R"(["F", "M"])");
  if (const std::optional<double> margin = gathered.declared.equivalence_margin) {
    input.options.add("lower", number_text(-*margin));
    input.options.add("upper", number_text(*margin));
  }
  return input;
}

Phrase equivalence_answer(const FoundNumbers& found, const std::optional<double>& margin) {
  const std::optional<double> supported = found.value("equivalence.margin");
  if (!supported) {
    return phrase("Analysis",
                  "This cannot be assessed: a group has one participant, or all participants have "
                  "the same result.");
  }
  const Finding& difference = *found.find("diff");
  const Phrase numbers =
      phrase("Analysis",
             "difference (women − men) = %1 percentage points, 90 % CI [%2, %3], n = %4 "
             "participants; JZS Bayes factor for a difference BF₁₀ = %5")
          .with(reading_points(*difference.value), reading_points(*difference.low),
                reading_points(*difference.high), std::to_string(difference.n),
                reading_number(*found.value("jzs.bf10", "0.7071")));
  if (!margin) {
    return phrase(
               "Analysis",
               "The protocol declares no margin of equivalence, so that there is no verdict: %1. "
               "The data would support equivalence within ±%2 percentage points.")
        .with(numbers, reading_points(*supported));
  }
  const bool equivalent = found.find("equivalent")->word == "TRUE";
  return (equivalent
              ? phrase("Analysis",
                       "Yes, within ±%1 percentage points: %2; two one-sided tests, %3, "
                       "uncorrected.")
              : phrase("Analysis",
                       "Equivalence within ±%1 percentage points is not shown: %2; two one-sided "
                       "tests, %3, uncorrected."))
      .with(reading_points(*margin), numbers, reading_p(*found.value("tost.p")));
}

}  // namespace

void ask_equivalence_of_sexes(const GatheredAnswers& gathered,
                              std::span<const std::optional<double>> proportions,
                              AnalysisOutcome& outcome) {
  std::optional<TidyInput> table = sexes_table(gathered, proportions);
  if (!table) return;
  const std::vector<Finding> findings =
      analysis_of(kSexesEquivalence, "equivalence", std::move(*table));
  keep_findings(findings, outcome);
  const FoundNumbers found(findings);
  add_question(outcome, kSexesEquivalence, phrase("Analysis", "Are women and men equivalent?"),
               equivalence_answer(found, gathered.declared.equivalence_margin),
               phrase("Analysis",
                      "Two one-sided Welch t tests of the participants' proportions, each at 5 %: "
                      "equivalence is shown where the 90 % CI lies within the margin. Bayes factor "
                      "of the pooled t with a Cauchy prior of scale √2/2 on the standardised "
                      "difference; below 1 it favours no difference."),
               "", found.find("diff"));
}

}  // namespace asperity
