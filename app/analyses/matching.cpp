// Matching: several felt textures are assigned to as many pictures.

#include <algorithm>
#include <utility>

#include "analysis/matching_null.h"
#include "app/analyses/families.h"
#include "app/analyses/tally.h"

namespace asperity {

namespace {

constexpr double kConfidence = 0.95;

/// One go: as many pictures as surfaces, every picture right for one surface and used once, so that
/// a person who feels nothing draws a random permutation.
struct Assignment {
  const GatheredAnswer* answer = nullptr;
  std::size_t items = 0;
  std::size_t right = 0;

  bool whole() const noexcept { return right == items; }
};

bool has_twice(std::vector<std::string> words) {
  std::sort(words.begin(), words.end());
  return std::adjacent_find(words.begin(), words.end()) != words.end();
}

bool is_permutation_of_pictures(const GatheredAnswer& answer) {
  const std::size_t items = answer.surfaces.size();
  std::vector<std::string> felt{};
  for (const FeltSurface& surface : answer.surfaces) felt.push_back(surface.item);
  const bool judged =
      std::all_of(answer.correct.begin(), answer.correct.end(),
                  [](const std::optional<bool>& correct) { return correct.has_value(); });
  return items > 0 && judged && answer.answers.size() == items && answer.options.size() == items &&
         !has_twice(felt) && !has_twice(answer.answers);
}

std::vector<Assignment> assignments_of(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Assignment> assignments{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(answer)) continue;
    const auto right = std::count(answer.correct.begin(), answer.correct.end(), true);
    assignments.push_back({&answer, answer.surfaces.size(), static_cast<std::size_t>(right)});
  }
  const std::size_t left_out = gathered.answers.size() - assignments.size();
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Answers left out because they do not give every picture to one surface, so that "
               "chance is not that of a permutation: %1.")
            .with(std::to_string(left_out)));
  }
  return assignments;
}

std::uint64_t permutations(std::size_t items) {
  std::uint64_t product = 1;
  for (std::uint64_t i = 2; i <= items; ++i) product *= i;
  return product;
}

/// A row of the table of items: how many are right, against random permutations.
struct ItemRow {
  std::size_t right = 0;
  std::size_t assignments = 0;
  std::set<std::size_t> items{};  ///< in one assignment
  std::set<std::string> persons{};
};

void add_item_row(const std::string& column, const std::string& person, const ItemRow& row,
                  NamedTable& table, AnalysisOutcome& outcome) {
  std::vector<Cell>& cells = table.table.rows.emplace_back();
  Finding finding{};
  finding.quantity = "share_of_items_correct";
  finding.key = "column=" + column + " person=" + person;
  finding.unit = "1";
  finding.n = row.persons.size();
  cells.insert(cells.end(), {column, person, static_cast<std::int64_t>(row.right)});
  if (row.items.size() != 1) {
    cells.resize(table.table.columns.size());
    finding.status = row.items.empty()
                         ? "nobody has answered yet"
                         : "the number of items differs between the trials, and chance with it";
    outcome.findings.push_back(std::move(finding));
    return;
  }
  const std::size_t items = *row.items.begin();
  const std::size_t of = items * row.assignments;
  const MatchingNull null({items, row.assignments});
  const CountInterval by_chance = null.central_interval(kConfidence);
  const double p = null.upper_tail(row.right);
  const auto share = [of](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(of);
  };
  cells.insert(cells.end(), {static_cast<std::int64_t>(of),
                             static_cast<std::int64_t>(row.persons.size()), share(row.right),
                             item_chance(items), share(by_chance.low), share(by_chance.high), p});
  finding.value = share(row.right);
  finding.method = "right items of all items; chance 1/" + std::to_string(items);
  outcome.findings.push_back(finding);
  finding.quantity = "p";
  finding.value = p;
  finding.method = "one-sided test of the number of right items against random permutations of " +
                   std::to_string(items);
  outcome.findings.push_back(std::move(finding));
}

}  // namespace

void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<std::string> columns = columns_of(gathered);
  const std::vector<Assignment> assignments = assignments_of(gathered, outcome);

  CountTable counts{"table_2",
                    phrase("Analysis", "Matched: whole permutations right (counts)"),
                    {},
                    "person",
                    sex_labels(gathered)};
  const auto count_of = [&](std::size_t label, const std::string& column) {
    return static_cast<std::size_t>(
        std::count_if(assignments.begin(), assignments.end(), [&](const Assignment& assignment) {
          return assignment.whole() && stands_in(*assignment.answer, column) &&
                 is_of(*assignment.answer, counts.labels[label]);
        }));
  };
  Tally goes{};
  Tally single{};
  for (const Assignment& assignment : assignments) {
    const std::string& person = assignment.answer->participant;
    goes.count(person, assignment.whole(), permutations(assignment.items));
    single.count(person, false, assignment.items);
  }
  counts.note =
      phrase("Analysis", "%1 %2")
          .with(chance_note(goes, phrase("Analysis", "By chance: 1/%1 of the goes wholly right.")),
                chance_note(single,
                            phrase("Analysis", "By chance: 1/%1 of the single items right.")));
  add_counts(counts, columns, count_of, outcome);

  ShareTable whole{"whole_permutations",
                   phrase("Analysis", "Whole permutations: share of goes with every item right"),
                   phrase("Analysis",
                          "Chance is 1/m! for m items. p: exact binomial test, two-sided, not "
                          "corrected for the number of rows."),
                   {"column", "person"},
                   "correct",
                   "share_of_permutations_correct",
                   {}};
  NamedTable items{
      "items",
      phrase("Analysis", "Items: share of right items"),
      {{"column", "person", "correct", "of", "persons", "share", "chance", "chance_low",
        "chance_high", "p"},
       {}},
      phrase("Analysis",
             "Chance is 1/m. The items of one go are not independent (all but one right is "
             "impossible): the interval holds 95 % of what random permutations give, and p is "
             "the probability that they give as many right items or more.")};
  for (const std::string& column : columns) {
    for (const std::string& label : counts.labels) {
      ShareRow& row = whole.rows.emplace_back(ShareRow{{column, label}, {}});
      ItemRow item_row{};
      for (const Assignment& assignment : assignments) {
        const GatheredAnswer& answer = *assignment.answer;
        if (!stands_in(answer, column) || !is_of(answer, label)) continue;
        row.tally.count(answer.participant, assignment.whole(), permutations(assignment.items));
        item_row.right += assignment.right;
        ++item_row.assignments;
        item_row.items.insert(assignment.items);
        item_row.persons.insert(answer.participant);
      }
      add_item_row(column, label, item_row, items, outcome);
    }
  }
  add_shares(whole, outcome);
  outcome.tables.push_back(std::move(items));

  std::map<std::string, Tally> by_texture{};
  PersonShares people{"all", {}};
  std::vector<std::pair<std::string, std::string>> pairs{};
  std::set<std::string> options{};
  for (const Assignment& assignment : assignments) {
    const GatheredAnswer& answer = *assignment.answer;
    for (std::size_t i = 0; i < assignment.items; ++i) {
      const bool right = *answer.correct[i];
      by_texture[answer.surfaces[i].item].count(answer.participant, right, assignment.items);
      people.people[answer.participant].count(answer.participant, right, assignment.items);
      pairs.emplace_back(answer.surfaces[i].item, answer.answers[i]);
    }
    options.insert(answer.options.begin(), answer.options.end());
  }
  ShareTable textures{"shares_by_texture",
                      phrase("Analysis", "Share of right items, by felt texture"),
                      phrase("Analysis",
                             "One texture alone is right with chance 1/m; the rows depend on each "
                             "other."),
                      {"felt"},
                      "correct",
                      "share_of_items_correct",
                      {}};
  for (const auto& [texture, tally] : by_texture) textures.rows.push_back({{texture}, tally});
  add_shares(textures, outcome);
  add_confusion(pairs, options, outcome);
  add_person_shares(std::span(&people, 1), "answers", "share_of_items_correct", outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(assignments.size(), people.people.size(), outcome);
}

}  // namespace asperity
