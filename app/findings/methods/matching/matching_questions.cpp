// Answers the questions of a matching in sentences.

#include "app/findings/methods/matching/matching_questions.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "app/findings/methods/matching/matching_tables.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_sentences.h"

namespace asperity {

void ask_items(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome) {
  const Finding* mean = found.find("subj.mean");
  const StudyTests::Test* test = tests.find("items");
  if (mean == nullptr || !mean->value || test == nullptr || !test->p) return;
  const Phrase chance = percent(*test->chance);
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(
        percent(*mean->value), interval_text(*mean),
        test->chance_varies
            ? phrase("Analysis",
                     "%1 on average (1 divided by the number of items, which differs between "
                     "trials)")
                  .with(chance)
            : chance,
        p_text(*test));
  };
  const Phrase of_one = with_numbers(phrase(
      "Analysis",
      "For this participant only: %1 of the items were matched correctly (%2), compared with a "
      "chance level of %3; permutation test, %4. More participants are needed."));
  TestStatements statements = statements_of(
      *test,
      {.numbers = with_numbers(phrase(
           "Analysis",
           "on average %1 of a participant's items were matched correctly (%2), compared with "
           "a chance level of %3; permutation test over participants, %4.")),
       .not_significant = phrase("Analysis", "Not significantly above chance: %1"),
       .exploratory = {}});
  if (mean->n == 1) statements.claim = statements.told = of_one;
  add_question(
      outcome, "items", phrase("Analysis", "Are textures matched to their pictures above chance?"),
      said_of(*test, statements),
      phrase(
          "Analysis",
          "%1 The total of correctly matched items is compared with its exact permutation null "
          "distribution: the pictures are relabelled once per participant, in all trials alike, so "
          "that the test is also valid for participants who guess one assignment and keep it.")
          .with(averaged(
              phrase("Analysis", "Each participant's proportion of correctly matched items"),
              mean)),
      "items", mean);
}

void ask_whole(const FoundNumbers& found, const StudyTests& tests, AnalysisOutcome& outcome) {
  const StudyTests::Test* test = tests.find("whole");
  const Finding* hits = found.find("perfect.trials");
  const Finding* mean = found.find("perfect.subj.mean");
  if (test == nullptr || !test->p || hits == nullptr || mean == nullptr || !mean->value) return;
  Finding share = *mean;
  share.quantity = "perfect.share";
  const Phrase answer =
      phrase("Analysis",
             "Trials with all items correct: %1 of %2, on average %3 of a participant's trials "
             "(%4); permutation test over participants, %5.")
          .with(std::to_string(static_cast<std::size_t>(*hits->value)), std::to_string(hits->n),
                percent(*share.value), interval_text(share), p_text(*test));
  add_question(
      outcome, "whole", phrase("Analysis", "How often are all items of a trial correct?"),
      with_contradiction(answer, *test),
      phrase("Analysis",
             "%1 Exact permutation test: the pictures are relabelled once per participant, in all "
             "trials alike.")
          .with(averaged(
              phrase("Analysis", "Each participant's proportion of trials with all items correct"),
              mean)),
      "whole_permutations", &share);
}

void ask_confused_pairs(const AnalysisOutcome& made, std::size_t people, AnalysisOutcome& outcome) {
  const ResultTable* const table = table_named(made, kConfusedPairs);
  if (table == nullptr || table->rows.empty()) return;
  const RowReader worst(*table, table->rows.front());
  const std::int64_t times = confusions_of(*table, table->rows.front());
  const auto as_often =
      std::count_if(table->rows.begin(), table->rows.end(),
                    [&](const ResultRow& pair) { return confusions_of(*table, pair) == times; });
  constexpr std::size_t kMostNamed = 6;
  Phrase names{};
  for (const ResultRow& pair : table->rows) {
    if (confusions_of(*table, pair) != times) continue;
    const RowReader row(*table, pair);
    const Phrase one =
        phrase("Analysis", "%1 and %2").with(row.text(columns::kFelt), row.text(columns::kOther));
    names = names.empty() ? one : phrase("Analysis", "%1; %2").with(names, one);
  }
  Finding finding{};
  finding.quantity = "confusions";
  finding.key = {worst.text(columns::kFelt), worst.text(columns::kOther)};
  finding.value = static_cast<double>(times);
  finding.unit = "1";
  finding.method = "items of one texture that were assigned the picture of the other";
  finding.n = people;
  add_question(
      outcome, "confusions", phrase("Analysis", "Which textures are confused with each other?"),
      times == 0 ? phrase("Analysis", "No texture was confused with another.")
      : as_often > 1 && static_cast<std::size_t>(as_often) <= kMostNamed
          ? phrase(
                "Analysis",
                "The following pairs are confused equally often, and none more often: %1; number "
                "of confusions of each, counted in both directions: %2.")
                .with(names, std::to_string(times))
      : as_often > 1
          ? phrase("Analysis",
                   "%1 pairs are confused equally often, and none more often; number of "
                   "confusions, counted in both directions: %2.")
                .with(std::to_string(as_often), std::to_string(times))
          : phrase("Analysis",
                   "%1 and %2 are confused most often; number of confusions, counted in both "
                   "directions: %3.")
                .with(worst.text(columns::kFelt), worst.text(columns::kOther),
                      std::to_string(times)),
      phrase("Analysis", "Counts of all responses; a CI would require a model of the confusions."),
      kConfusedPairs, &finding, CountedUnit::participants);
}

}  // namespace asperity
