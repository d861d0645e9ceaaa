// Numbers the trials of each participant, and calls the family `learning` for times and for correct responses.

#include "app/findings/shared/learning.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tests/learning.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/reading_table.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_findings.h"

namespace asperity {

namespace {

bool scores_items(std::string_view kind) {
  const StudyAnalysis* const analysis = find_analysis(kind);
  return analysis != nullptr && analysis->scores_items;
}

constexpr const char* kLearningFamily = "learning";

/// The number of each response among those of its participant, from 1, in the order of the plan.
std::vector<std::size_t> trial_numbers(const GatheredAnswers& gathered) {
  std::vector<std::size_t> last(gathered.people.size());
  std::vector<std::size_t> numbers{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!answer.continues_trial) ++last[answer.person];
    numbers.push_back(last[answer.person]);
  }
  return numbers;
}

NumberColumn column_of_counts(const std::vector<std::size_t>& counts) {
  NumberColumn column{};
  for (const std::size_t count : counts) column.push_back(static_cast<double>(count));
  return column;
}

TidyInput input_of(std::vector<TidyTable::Column> columns) {
  TidyInput input{};
  input.tables.emplace_back(std::move(columns), "the trials");
  return input;
}

TidyInput times_by_trial(const GatheredAnswers& gathered, const std::vector<std::size_t>& numbers) {
  return input_of({{"subject", column_of_people(gathered)},
                   {"trial", column_of_counts(numbers)},
                   {"time_s", column_of_times(gathered)}});
}

/// Nothing where responses are neither correct nor incorrect.
std::optional<TidyInput> correct_by_trial(const GatheredAnswers& gathered,
                                          const std::vector<std::size_t>& numbers) {
  std::vector<std::size_t> correct{};
  std::vector<std::size_t> items{};
  for (const GatheredAnswer& answer : gathered.answers) {
    const auto replies = gathered.replies_of(answer);
    std::size_t hits = 0;
    for (const GatheredReply& reply : replies) {
      if (!reply.correct) return std::nullopt;
      hits += *reply.correct ? 1 : 0;
    }
    correct.push_back(hits);
    items.push_back(replies.size());
  }
  return input_of({{"subject", column_of_people(gathered)},
                   {"trial", column_of_counts(numbers)},
                   {"correct", column_of_counts(correct)},
                   {"items", column_of_counts(items)}});
}

struct Change {
  const char* measure = "";  ///< display text: cell_words.h
  const char* quantity = "";
  bool has_halves = true;
};

void add_change(const Change& change, const FoundNumbers& found, Table& table) {
  const Finding* finding = found.find(change.quantity);
  if (finding == nullptr) return;
  const auto half = [&](const char* quantity) {
    return change.has_halves ? found.cell(quantity) : Cell{};
  };
  const auto [low, high] = found.interval(change.quantity);
  table.rows.push_back({std::string(change.measure), static_cast<std::int64_t>(finding->n),
                        half("half.first"), half("half.second"), cell_of(finding->value), low,
                        high});
}

/// "1–4" of the key "1-4".
std::string range_text(std::string block) {
  const std::size_t dash = block.find('-');
  if (dash != std::string::npos) block.replace(dash, 1, "–");
  return block;
}

/// Blocks without a timed trial have no row.
void add_trial_blocks(const FoundNumbers& times, const FoundNumbers& correct, Table& table) {
  std::vector<const Finding*> blocks = correct.all("block");
  if (blocks.empty()) blocks = times.all("block");
  for (const Finding* block : blocks) {
    const auto [low_s, high_s] = times.interval("block", block->key);
    const auto [low, high] = correct.interval("block", block->key);
    table.rows.push_back({range_text(block->key), static_cast<std::int64_t>(block->n),
                          times.cell("block", block->key), low_s, high_s,
                          correct.cell("block", block->key), low, high});
  }
}

Phrase note_on_changes(const Table& changes, bool has_proportions) {
  Phrase note = phrase("Analysis",
                       "The results are exploratory: they are not tested and not adjusted for the "
                       "conditions of the trials. Each participant's counted trials are divided "
                       "into halves as numbered in the plan; the middle trial of an odd number is "
                       "left out, and a repeated trial keeps its planned place. Times: "
                       "geometric means, and ratio of the second to the first half.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  const bool has_slope = std::any_of(
      changes.rows.begin(), changes.rows.end(),
      [](const std::vector<Cell>& row) { return row.front() == Cell{"time_per_10_trials"}; });
  if (has_slope) {
    add(phrase("Analysis",
               "Ratio per 10 trials: from each participant's least-squares regression of log "
               "response time on trial number."));
  }
  if (has_proportions) add(phrase("Analysis", "Proportions: second minus first half."));
  if (!has_cells(changes, "change_low")) return note;
  add(phrase("Analysis",
             "95 % CI: t-based over participants, for times on the logarithmic scale; in "
             "simulations with 2 to 20 participants, its coverage was at least 92 %."));
  const bool has_cut =
      std::any_of(changes.rows.begin(), changes.rows.end(), [](const std::vector<Cell>& row) {
        return (row.front() == Cell{"correct_of_halves"} ||
                row.front() == Cell{"items_of_halves"}) &&
               row[row.size() - 2] != Cell{};
      });
  if (has_cut)
    add(phrase("Analysis", "CIs of differences of proportions are truncated at −1 and 1."));
  return note;
}

Phrase note_on_course(const Table& course, const std::string& kind) {
  Phrase note =
      phrase("Analysis",
             "Means over the participants, by range of counted trials; trials are numbered in the "
             "planned order across each participant's sessions. Times: geometric means.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (has_cells(course, "share")) {
    add(scores_items(kind) ? phrase("Analysis", "Proportions refer to correctly matched items.")
                           : phrase("Analysis", "Proportions refer to correct responses."));
  }
  if (has_cells(course, "share_low")) {
    add(phrase(
        "Analysis",
        "95 % CI: t-based over participants, for times on the logarithmic and for proportions on "
        "the logit scale; in simulations with 2 to 20 participants and proportions of 5 to 98 %, "
        "its coverage was at least 90 %."));
  } else if (has_cells(course, "time_s_low")) {
    add(phrase("Analysis", "95 % CI: t-based over participants, on the logarithmic scale."));
  }
  return note;
}

}  // namespace

void add_learning(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<std::size_t> numbers = trial_numbers(gathered);
  std::vector<Finding> of_times =
      analysis_of(kLearningOfTimes, kLearningFamily, times_by_trial(gathered, numbers));
  std::vector<Finding> of_correct{};
  // Over levels that a procedure chose, proportions correct depend on the procedure.
  const bool has_procedure =
      std::any_of(gathered.blocks.begin(), gathered.blocks.end(),
                  [](const auto& block) { return block.second.has_procedure; });
  std::optional<TidyInput> input =
      has_procedure ? std::nullopt : correct_by_trial(gathered, numbers);
  if (input) {
    of_correct = analysis_of(kLearningCorrect, kLearningFamily, std::move(*input));
  }
  const bool has_ten = std::any_of(numbers.begin(), numbers.end(),
                                   [](std::size_t number) { return number >= kTrialsOfSlope; });
  if (!has_ten) {
    std::erase_if(of_times, [](const Finding& finding) {
      return finding.quantity.find("slope.ratio") != std::string::npos;
    });
  }
  const FoundNumbers times(of_times);
  const FoundNumbers correct(of_correct);
  NamedTable changes{
      kLearning,
      phrase("Analysis", "Learning over the trials"),
      {{"measure", "persons", "first_half", "second_half", "change", "change_low", "change_high"},
       {}},
      {}};
  add_change({"time_of_halves", "half.ratio"}, times, changes.table);
  add_change({"time_per_10_trials", "slope.ratio", false}, times, changes.table);
  add_change(
      {scores_items(gathered.kind) ? "items_of_halves" : "correct_of_halves", "half.difference"},
      correct, changes.table);
  if (changes.table.rows.empty()) return;
  changes.note = note_on_changes(changes.table, !of_correct.empty());
  NamedTable course{kTrialCourse,
                    phrase("Analysis", "Trend over the trials"),
                    {{"trials", "persons", "time_s", "time_s_low", "time_s_high", "share",
                      "share_low", "share_high"},
                     {}},
                    {}};
  add_trial_blocks(times, correct, course.table);
  drop_empty_columns(course.table, 2);
  course.note = note_on_course(course.table, gathered.kind);
  keep_findings(of_times, outcome);
  keep_findings(of_correct, outcome);
  outcome.tables.push_back(std::move(changes));
  outcome.tables.push_back(std::move(course));
}

}  // namespace asperity
