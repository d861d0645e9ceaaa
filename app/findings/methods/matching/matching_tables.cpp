// Makes the tables of a matching.

#include "app/findings/methods/matching/matching_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/figures/confusion_figure.h"
#include "app/findings/shared/figures/forest_figures.h"

namespace asperity {

namespace {

const ResultColumn kUnderGuessing =
    interval_of(columns::kChance, phrase("AnalysisWords", "95 % interval under guessing"));
const ResultColumn kMatchingTrials{.id = "goes", .heading = phrase("AnalysisWords", "trials")};
const ResultColumn kByChance{.id = "by_chance",
                             .heading = phrase("AnalysisWords", "expected under guessing")};

/// A row of the table of items: the number correct, tested against one relabelling of the pictures
/// per participant.
void add_item_row(const GatheredAnswers& gathered, const std::string& column,
                  const std::string& person, MatchedTrials assignments, ResultTable& table,
                  AnalysisOutcome& outcome) {
  std::set<std::uint32_t> persons{};
  std::set<std::size_t> sizes{};
  std::int64_t right = 0;
  std::int64_t of = 0;
  for (const MatchedTrial* assignment : assignments) {
    persons.insert(assignment->person);
    sizes.insert(assignment->items());
    right += static_cast<std::int64_t>(assignment->right * assignment->times);
    of += static_cast<std::int64_t>(assignment->items() * assignment->times);
  }
  ResultRow& cells = table.rows.emplace_back();
  Finding finding{};
  finding.quantity = "share_of_items_correct";
  finding.key = "column=" + column + " person=" + person;
  finding.unit = "1";
  finding.n = persons.size();
  cells.insert(cells.end(), {column, person, right});
  if (sizes.size() != 1) {
    cells.resize(table.columns.size());
    finding.status =
        sizes.empty()
            ? "there are no responses that count"
            : "the number of items, and therefore the chance level, differs between the trials";
    outcome.findings.push_back(std::move(finding));
    return;
  }
  const std::vector<Finding> numbers =
      analysis_of("matching", "matching", matched_trials_table(gathered, assignments, "totals"));
  const FoundNumbers found(numbers);
  const std::size_t items = *sizes.begin();
  const auto share = [&](QuantityName quantity) {
    return found.value(quantity).value_or(0.0) / static_cast<double>(of);
  };
  const double p = found.value("relabel.p.greater").value_or(1.0);
  cells.insert(cells.end(),
               {of, static_cast<std::int64_t>(persons.size()), found.cell("prop.correct"),
                1.0 / static_cast<double>(items),
                interval_cell(share("relabel.null.lower"), share("relabel.null.upper")), p});
  finding.value = found.value("prop.correct");
  finding.method = "proportion of correctly matched items; chance level 1/" + std::to_string(items);
  outcome.findings.push_back(finding);
  finding.quantity = "p";
  finding.value = p;
  finding.method =
      "one-sided permutation test of the number of correctly matched items, one relabelling of "
      "the " +
      std::to_string(items) + " pictures per participant";
  outcome.tests_in_tables.insert(name_of(finding));
  outcome.findings.push_back(std::move(finding));
}

}  // namespace

void add_matching_tables(const GatheredAnswers& gathered, std::span<const MatchedTrial> assignments,
                         AnalysisOutcome& outcome) {
  ChapterTally whole(gathered);
  const ChapterCells& cells = whole.cells();
  const std::size_t sexes = cells.sexes().size();
  std::vector<std::vector<const MatchedTrial*>> in_cell(cells.columns().size() * sexes);
  Tally goes{};
  Tally single{};
  for (const MatchedTrial& assignment : assignments) {
    const std::uint32_t person = assignment.person;
    const std::uint64_t outcomes = permutations(assignment.items());
    goes.count(person, assignment.whole(), outcomes);
    single.count(person, false, assignment.items());
    whole.count({.column = assignment.column,
                 .person = person,
                 .hit = assignment.whole(),
                 .outcomes = outcomes,
                 .times = assignment.times});
    cells.for_each(assignment.column, person, [&](std::size_t column, std::size_t sex) {
      in_cell[column * sexes + sex].push_back(&assignment);
    });
  }
  whole.add(
      "table_2", phrase("Analysis", "Trials with all items correct (counts)"),
      phrase("Analysis", "%1 %2")
          .with(
              chance_note(goes, phrase("Analysis",
                                       "Chance level: all items correct in 1/%1 of the trials.")),
              chance_note(single, phrase("Analysis", "Chance level: 1/%1 of the items correct."))),
      outcome);
  ShareTable shares{"whole_permutations",
                    phrase("Analysis", "Proportion of trials with all items correct"),
                    phrase("Analysis",
                           "The chance level is 1/m! for m items. p: exact binomial test, "
                           "two-sided, uncorrected for the number of rows."),
                    {columns::kRepetition, columns::kSex},
                    columns::kCorrect,
                    "share_of_permutations_correct",
                    {}};
  ResultTable items{
      "items",
      phrase("Analysis", "Proportion of correctly matched items"),
      {columns::kRepetition, columns::kSex, columns::kCorrect, columns::kOf, columns::kPersons,
       columns::kShare, columns::kChance, kUnderGuessing, columns::kP},
      phrase("Analysis",
             "The chance level is 1/m. p: exact permutation test, one-sided, "
             "uncorrected for the number of rows: the pictures are relabelled at "
             "random once per participant, in all of the participant's trials alike. "
             "The interval contains 95 % of the permutation distribution.")};
  for (std::size_t column = 0; column < cells.columns().size(); ++column) {
    for (std::size_t sex = 0; sex < sexes; ++sex) {
      add_item_row(gathered, cells.columns()[column], cells.sexes()[sex],
                   in_cell[column * sexes + sex], items, outcome);
    }
  }
  whole.add_rows(shares);
  add_shares(shares, outcome).figures = [](const ResultTable& table, const AnalysisOutcome&) {
    return std::vector{answering("whole", share_forest(table))};
  };
  outcome.tables.push_back(std::move(items));
}

void add_confusions(const GatheredAnswers& gathered, std::span<const MatchedTrial> assignments,
                    AnalysisOutcome& outcome) {
  std::map<std::string, Tally> by_texture{};
  ConfusionTally confusions{};
  std::set<std::uint32_t> lists{};
  for (const MatchedTrial& assignment : assignments) {
    for (std::size_t i = 0; i < assignment.items(); ++i) {
      const bool right = assignment.felt[i] == assignment.chosen[i];
      by_texture[gathered.word(assignment.felt[i])].count(assignment.person, right,
                                                          assignment.items(), assignment.times);
      confusions.count(assignment.felt[i], assignment.chosen[i], assignment.times);
    }
    lists.insert(assignment.options);
  }
  std::set<std::string> options{};
  for (const std::uint32_t list : lists) {
    options.insert(gathered.option_lists[list].begin(), gathered.option_lists[list].end());
  }
  ShareTable textures{
      kSharesByTexture,
      phrase("Analysis", "Proportion of correctly matched items, by texture"),
      phrase(
          "Analysis",
          "The chance level of each texture is 1/m. The rows are not independent of each other."),
      {columns::kFelt},
      columns::kCorrect,
      "share_of_items_correct",
      {}};
  for (const auto& [texture, tally] : by_texture) textures.rows.push_back({{texture}, tally});
  add_shares(textures, outcome).figures = [](const ResultTable& table,
                                             const AnalysisOutcome& drawn) {
    return std::vector{answering("items", share_forest(table, drawn, {kPersonMeans, "matching"}))};
  };
  confusions.add_table(gathered, options, outcome).figures = confusion_figures;
}

void add_confused_pairs(const std::vector<std::string>& felt, const FoundNumbers& found,
                        AnalysisOutcome& outcome) {
  ResultTable made{kConfusedPairs,
                   phrase("Analysis", "Confused pairs of textures, the most frequent first"),
                   {columns::kFelt, columns::kOther, kFeltAsOther, kOtherAsFelt},
                   phrase("Analysis",
                          "Number of times that one texture was assigned the picture of the other, "
                          "in each direction.")};
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const auto count = [&](const std::string& a, const std::string& b) {
        return static_cast<std::int64_t>(found.value("confusion", {a, b}).value_or(0.0));
      };
      made.add({felt[i], felt[j], count(felt[i], felt[j]), count(felt[j], felt[i])});
    }
  }
  std::stable_sort(made.rows.begin(), made.rows.end(),
                   [&made](const ResultRow& one, const ResultRow& other) {
                     return confusions_of(made, one) > confusions_of(made, other);
                   });
  outcome.tables.push_back(std::move(made));
}

std::int64_t confusions_of(const ResultTable& table, const ResultRow& pair) {
  const RowReader row(table, pair);
  return std::llround(row.number(kFeltAsOther).value_or(0.0) +
                      row.number(kOtherAsFelt).value_or(0.0));
}

void add_right_items(std::size_t items, const FoundNumbers& found, AnalysisOutcome& outcome) {
  ResultTable made{
      "right_items",
      phrase("Analysis", "Trials by their number of correctly matched items"),
      {columns::kCorrectCount, kMatchingTrials, kByChance},
      phrase("Analysis",
             "Expected under guessing: number of trials if every assignment is equally likely.")};
  const double goes = found.value("n.trials").value_or(0.0);
  for (std::size_t k = 0; k <= items; ++k) {
    const FindingKey key = "n=" + std::to_string(items) + ";k=" + std::to_string(k);
    made.add(
        {count_cell(k),
         static_cast<std::int64_t>(found.value("trials.with.k", std::to_string(k)).value_or(0.0)),
         found.value("null.pmf", key).value_or(0.0) * goes});
  }
  outcome.tables.push_back(std::move(made));
}

}  // namespace asperity
