// Numbers the trials of each participant, and calls the family `learning` for times and for correct responses.

#include "app/findings/shared/learning.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tests/learning.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/figures/response_time_figures.h"
#include "protocols/design/block_factors.h"

namespace asperity {

namespace {

bool scores_items(std::string_view kind) {
  const StudyAnalysis* const analysis = find_analysis(kind);
  return analysis != nullptr && analysis->scores_items;
}

constexpr const char* kLearningFamily = "learning";

// Words of the column `measure`; display text: cell_words.h
constexpr const char* kTimeOfHalves = "time_of_halves";
constexpr const char* kTimePerTenTrials = "time_per_10_trials";
constexpr const char* kCorrectOfHalves = "correct_of_halves";
constexpr const char* kItemsOfHalves = "items_of_halves";

const ResultColumn kFirstHalf{.id = "first_half", .heading = phrase("AnalysisWords", "first half")};
const ResultColumn kSecondHalf{.id = "second_half",
                               .heading = phrase("AnalysisWords", "second half")};

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
  const char* measure = "";
  QuantityName quantity{};
  bool has_halves = true;
};

void add_change(const Change& change, const FoundNumbers& found, ResultTable& table) {
  const Finding* finding = found.find(change.quantity);
  if (finding == nullptr) return;
  const auto half = [&](QuantityName quantity) {
    return change.has_halves ? found.cell(quantity) : ResultCell{};
  };
  table.add({change.measure, count_cell(finding->n), half("half.first"), half("half.second"),
             cell_of(finding->value), found.interval(change.quantity)});
}

/// "1–4" of the key "1-4".
std::string range_text(std::string block) {
  const std::size_t dash = block.find('-');
  if (dash != std::string::npos) block.replace(dash, 1, "–");
  return block;
}

/// Blocks without a timed trial have no row.
void add_trial_blocks(const FoundNumbers& times, const FoundNumbers& correct, ResultTable& table) {
  std::vector<const Finding*> blocks = correct.all("block");
  if (blocks.empty()) blocks = times.all("block");
  for (const Finding* block : blocks) {
    table.add({range_text(block->key.last()), count_cell(block->n), times.cell("block", block->key),
               times.interval("block", block->key), correct.cell("block", block->key),
               correct.interval("block", block->key)});
  }
}

Phrase note_on_changes(const ResultTable& changes, bool has_proportions) {
  Phrase note = phrase("Analysis",
                       "The results are exploratory: they are not tested and not adjusted for the "
                       "conditions of the trials. Each participant's counted trials are divided "
                       "into halves as numbered in the plan; the middle trial of an odd number is "
                       "left out, and a repeated trial keeps its planned place. Times: "
                       "geometric means, and ratio of the second to the first half.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  const auto any_row = [&changes](const auto& is_meant) {
    return std::any_of(changes.rows.begin(), changes.rows.end(),
                       [&](const ResultRow& row) { return is_meant(RowReader(changes, row)); });
  };
  const bool has_slope = any_row(
      [](const RowReader& row) { return row.text(columns::kMeasure) == kTimePerTenTrials; });
  if (has_slope) {
    add(phrase("Analysis",
               "Ratio per 10 trials: from each participant's least-squares regression of log "
               "response time on trial number."));
  }
  if (has_proportions) add(phrase("Analysis", "Proportions: second minus first half."));
  if (!changes.has_values(interval_of(kChange))) return note;
  add(phrase("Analysis",
             "95 % CI: t-based over participants, for times on the logarithmic scale; in "
             "simulations with 2 to 20 participants, its coverage was at least 92 %."));
  const bool has_cut = any_row([](const RowReader& row) {
    const std::string measure = row.text(columns::kMeasure);
    return (measure == kCorrectOfHalves || measure == kItemsOfHalves) && row.interval(kChange).low;
  });
  if (has_cut)
    add(phrase("Analysis", "CIs of differences of proportions are truncated at −1 and 1."));
  return note;
}

Phrase note_on_course(const ResultTable& course, const std::string& kind) {
  Phrase note =
      phrase("Analysis",
             "Means over the participants, by range of counted trials; trials are numbered in the "
             "planned order across each participant's sessions. Times: geometric means.");
  const auto add = [&note](const Phrase& sentence) {
    note = phrase("Analysis", "%1 %2").with(note, sentence);
  };
  if (course.has_values(columns::kShare)) {
    add(scores_items(kind) ? phrase("Analysis", "Proportions refer to correctly matched items.")
                           : phrase("Analysis", "Proportions refer to correct responses."));
  }
  if (course.has_values(interval_of(columns::kShare))) {
    add(phrase(
        "Analysis",
        "95 % CI: t-based over participants, for times on the logarithmic and for proportions on "
        "the logit scale; in simulations with 2 to 20 participants and proportions of 5 to 98 %, "
        "its coverage was at least 90 %."));
  } else if (course.has_values(interval_of(columns::kTime))) {
    add(phrase("Analysis", "95 % CI: t-based over participants, on the logarithmic scale."));
  }
  return note;
}

/// Of times and of correct responses, where there are any.
std::vector<Figure> figures_of_course(const ResultTable&, const AnalysisOutcome& outcome) {
  std::vector<Figure> figures{};
  const FoundNumbers times(outcome.findings, kLearningOfTimes);
  if (!times.all("block").empty()) figures.push_back(times_over_trials_figure(times));
  const FoundNumbers correct(outcome.findings, kLearningCorrect);
  if (!correct.all("block").empty()) figures.push_back(correct_over_trials_figure(correct));
  return figures;
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
                  [](const auto& block) { return chooses_levels_from_answers(block.second); });
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
  using namespace columns;
  ResultTable changes{kLearning,
                      phrase("Analysis", "Learning over the trials"),
                      {kMeasure, kPersons, kFirstHalf, kSecondHalf, kChange, interval_of(kChange)},
                      {}};
  add_change({kTimeOfHalves, "half.ratio"}, times, changes);
  add_change({kTimePerTenTrials, "slope.ratio", false}, times, changes);
  add_change({scores_items(gathered.kind) ? kItemsOfHalves : kCorrectOfHalves, "half.difference"},
             correct, changes);
  if (changes.rows.empty()) return;
  changes.note = note_on_changes(changes, !of_correct.empty());
  ResultTable course{kTrialCourse,
                     phrase("Analysis", "Trend over the trials"),
                     {kTrials, kPersons, kTime, interval_of(kTime), kShare, interval_of(kShare)},
                     {}};
  add_trial_blocks(times, correct, course);
  course.drop_empty_columns(2);
  course.note = note_on_course(course, gathered.kind);
  course.figures = figures_of_course;
  keep_findings(of_times, outcome);
  keep_findings(of_correct, outcome);
  outcome.tables.push_back(std::move(changes));
  outcome.tables.push_back(std::move(course));
}

}  // namespace asperity
