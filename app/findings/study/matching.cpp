#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "app/findings/study/crossed_textures.h"
#include "app/findings/study/group_equivalence.h"
#include "app/findings/study/kinds/matching_analysis.h"
#include "app/findings/study/repetition_reliability.h"
#include "app/findings/study/study_findings.h"
#include "app/findings/study/tally.h"
#include "app/findings/study/test_sentences.h"

namespace asperity {

namespace {

// the largest number for which the chance distribution is computed
constexpr std::size_t kMostItems = 12;

/// One trial: as many pictures as surfaces, every picture correct for one surface and used once, so
/// that a participant who feels nothing responds with a random permutation. Equal trials of a
/// participant are adjacent.
struct Assignment {
  std::uint32_t person = 0;
  std::uint32_t column = 0;
  std::uint32_t options = 0;
  std::vector<std::uint32_t> felt{};  ///< words in order
  std::vector<std::uint32_t> chosen{};
  std::size_t right = 0;
  std::size_t times = 0;

  std::size_t items() const noexcept { return felt.size(); }
  bool whole() const noexcept { return right == items(); }
};

using Chosen = std::span<const Assignment* const>;

bool is_permutation_of_pictures(const GatheredAnswers& gathered, const GatheredAnswer& answer) {
  const auto surfaces = gathered.surfaces_of(answer);
  const auto replies = gathered.replies_of(answer);
  const std::size_t items = surfaces.size();
  if (items == 0 || items > kMostItems || replies.size() != items ||
      gathered.option_lists[answer.options].size() != items) {
    return false;
  }
  for (std::size_t i = 0; i < items; ++i) {
    if (!replies[i].correct) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (surfaces[i].item == surfaces[j].item || replies[i].answer == replies[j].answer) {
        return false;
      }
    }
  }
  return true;
}

std::vector<RepeatedScore> repeated_scores(const GatheredAnswers& gathered) {
  std::vector<RepeatedScore> scores{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) continue;
    const auto replies = gathered.replies_of(answer);
    const auto right = std::count_if(replies.begin(), replies.end(),
                                     [](const GatheredReply& reply) { return *reply.correct; });
    scores.push_back({.person = answer.person,
                      .column = answer.column,
                      .repetition = answer.repetition,
                      .score = static_cast<double>(right) / static_cast<double>(replies.size())});
  }
  return scores;
}

std::vector<TextureResponse> responses_to_textures(const GatheredAnswers& gathered) {
  std::vector<TextureResponse> responses{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) continue;
    const auto surfaces = gathered.surfaces_of(answer);
    const auto replies = gathered.replies_of(answer);
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      responses.push_back(
          {.person = answer.person, .texture = surfaces[i].item, .is_hit = *replies[i].correct});
    }
  }
  return responses;
}

std::vector<Assignment> assignments_of(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  std::vector<Assignment> assignments{};
  std::unordered_map<std::u32string, std::size_t> places{};
  std::size_t left_out = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs{};
  std::u32string name{};
  for (const GatheredAnswer& answer : gathered.answers) {
    if (!is_permutation_of_pictures(gathered, answer)) {
      ++left_out;
      continue;
    }
    const auto surfaces = gathered.surfaces_of(answer);
    const auto replies = gathered.replies_of(answer);
    pairs.clear();
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      pairs.emplace_back(surfaces[i].item, replies[i].answer);
    }
    std::sort(pairs.begin(), pairs.end());
    name.clear();
    for (const std::uint32_t part : {answer.person, answer.column, answer.options}) name += part;
    for (const auto& [felt, chosen] : pairs) {
      name += felt;
      name += chosen;
    }
    const auto [found, is_new] = places.try_emplace(name, assignments.size());
    if (is_new) {
      Assignment& made = assignments.emplace_back();
      made.person = answer.person;
      made.column = answer.column;
      made.options = answer.options;
      for (const auto& [felt, chosen] : pairs) {
        made.felt.push_back(felt);
        made.chosen.push_back(chosen);
      }
      made.right = static_cast<std::size_t>(std::count_if(
          replies.begin(), replies.end(), [](const GatheredReply& r) { return *r.correct; }));
    }
    ++assignments[found->second].times;
  }
  if (left_out > 0) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Responses left out because they do not assign each picture to exactly one surface, "
               "so that the chance level of a permutation does not apply: %1.")
            .with(std::to_string(left_out)));
  }
  return assignments;
}

std::uint64_t permutations(std::size_t items) {
  std::uint64_t product = 1;
  for (std::uint64_t i = 2; i <= items; ++i) product *= i;
  return product;
}

/// Rows of the family `matching`. A response is correct there when it has the name of the texture
/// felt.
TidyInput assignments_table(const GatheredAnswers& gathered, Chosen assignments,
                            const char* parts) {
  NumberColumn times{};
  LabelColumn people{};
  LabelColumn trials{};
  LabelColumn felt{};
  LabelColumn chosen{};
  LabelColumn groups{.names = {"F", "M"}};
  bool sexes[2] = {false, false};
  for (const AnsweringPerson& person : gathered.people) {
    people.names.push_back(person.label);
    sexes[0] = sexes[0] || person.sex == "F";
    sexes[1] = sexes[1] || person.sex == "M";
  }
  for (std::size_t word = 0; word < gathered.words.size(); ++word) {
    felt.names.push_back(gathered.word(static_cast<std::uint32_t>(word)));
  }
  chosen.names = felt.names;
  std::vector<std::size_t> trials_of(gathered.people.size());
  for (const Assignment* assignment : assignments) {
    const std::size_t trial = trials_of[assignment->person]++;
    if (trial == trials.names.size()) trials.names.push_back(std::to_string(trial + 1));
    const std::optional<std::string>& sex = gathered.people[assignment->person].sex;
    for (std::size_t i = 0; i < assignment->items(); ++i) {
      people.codes.push_back(assignment->person);
      trials.codes.push_back(trial);
      felt.codes.push_back(assignment->felt[i]);
      chosen.codes.push_back(assignment->chosen[i]);
      times.push_back(static_cast<double>(assignment->times));
      if (sexes[0] && sexes[1]) {
        groups.codes.push_back(sex == "F" ? 0 : sex == "M" ? 1 : LabelColumn::kMissing);
      }
    }
  }
  std::vector<TidyTable::Column> columns{{"subject", std::move(people)},
                                         {"trial", std::move(trials)},
                                         {"stimulus", std::move(felt)},
                                         {"response", std::move(chosen)},
                                         {"times", std::move(times)}};
  if (sexes[0] && sexes[1]) columns.push_back({"group", std::move(groups)});
  TidyInput input{};
  input.tables.emplace_back(std::move(columns), "the assignments");
  input.options.set("parts", std::string(parts));
  return input;
}

/// A row of the table of items: the number correct, tested against one relabelling of the pictures
/// per participant.
void add_item_row(const GatheredAnswers& gathered, const std::string& column,
                  const std::string& person, Chosen assignments, NamedTable& table,
                  AnalysisOutcome& outcome) {
  std::set<std::uint32_t> persons{};
  std::set<std::size_t> sizes{};
  std::int64_t right = 0;
  std::int64_t of = 0;
  for (const Assignment* assignment : assignments) {
    persons.insert(assignment->person);
    sizes.insert(assignment->items());
    right += static_cast<std::int64_t>(assignment->right * assignment->times);
    of += static_cast<std::int64_t>(assignment->items() * assignment->times);
  }
  std::vector<Cell>& cells = table.table.rows.emplace_back();
  Finding finding{};
  finding.quantity = "share_of_items_correct";
  finding.key = "column=" + column + " person=" + person;
  finding.unit = "1";
  finding.n = persons.size();
  cells.insert(cells.end(), {column, person, right});
  if (sizes.size() != 1) {
    cells.resize(table.table.columns.size());
    finding.status =
        sizes.empty()
            ? "there are no responses that count"
            : "the number of items, and therefore the chance level, differs between the trials";
    outcome.findings.push_back(std::move(finding));
    return;
  }
  const std::vector<Finding> numbers =
      analysis_of("matching", "matching", assignments_table(gathered, assignments, "totals"));
  const FoundNumbers found(numbers);
  const std::size_t items = *sizes.begin();
  const auto share = [&](const char* quantity) {
    return found.value(quantity).value_or(0.0) / static_cast<double>(of);
  };
  const double p = found.value("relabel.p.greater").value_or(1.0);
  cells.insert(cells.end(), {of, static_cast<std::int64_t>(persons.size()),
                             found.cell("prop.correct"), 1.0 / static_cast<double>(items),
                             share("relabel.null.lower"), share("relabel.null.upper"), p});
  finding.value = found.value("prop.correct");
  finding.method = "correctly matched items of all items; chance level 1/" + std::to_string(items);
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

/// The tables by column and sex.
void add_matching_tables(const GatheredAnswers& gathered, std::span<const Assignment> assignments,
                         AnalysisOutcome& outcome) {
  ChapterTally whole(gathered);
  const ChapterCells& cells = whole.cells();
  const std::size_t sexes = cells.sexes().size();
  std::vector<std::vector<const Assignment*>> in_cell(cells.columns().size() * sexes);
  Tally goes{};
  Tally single{};
  for (const Assignment& assignment : assignments) {
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
                    {"column", "person"},
                    "correct",
                    "share_of_permutations_correct",
                    {}};
  NamedTable items{"items",
                   phrase("Analysis", "Proportion of correctly matched items"),
                   {{"column", "person", "correct", "of", "persons", "share", "chance",
                     "chance_low", "chance_high", "p"},
                    {}},
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
  add_shares(shares, outcome);
  outcome.tables.push_back(std::move(items));
}

void add_confusions(const GatheredAnswers& gathered, std::span<const Assignment> assignments,
                    AnalysisOutcome& outcome) {
  std::map<std::string, Tally> by_texture{};
  ConfusionTally confusions{};
  std::set<std::uint32_t> lists{};
  for (const Assignment& assignment : assignments) {
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
      "shares_by_texture",
      phrase("Analysis", "Proportion of correctly matched items, by texture"),
      phrase(
          "Analysis",
          "The chance level of each texture is 1/m. The rows are not independent of each other."),
      {"felt"},
      "correct",
      "share_of_items_correct",
      {}};
  for (const auto& [texture, tally] : by_texture) textures.rows.push_back({{texture}, tally});
  add_shares(textures, outcome);
  confusions.add_table(gathered, options, outcome);
}

void add_confused_pairs(const std::vector<std::string>& felt, const FoundNumbers& found,
                        AnalysisOutcome& outcome) {
  NamedTable made{"confused_pairs",
                  phrase("Analysis", "Confused pairs of textures, the most frequent first"),
                  {{"felt", "other", "felt_as_other", "other_as_felt"}, {}},
                  phrase("Analysis",
                         "Number of times that one texture was assigned the picture of the other, "
                         "in each direction.")};
  for (std::size_t i = 0; i < felt.size(); ++i) {
    for (std::size_t j = i + 1; j < felt.size(); ++j) {
      const auto count = [&](const std::string& a, const std::string& b) {
        return static_cast<std::int64_t>(found.value("confusion", a + '|' + b).value_or(0.0));
      };
      made.table.rows.push_back(
          {felt[i], felt[j], count(felt[i], felt[j]), count(felt[j], felt[i])});
    }
  }
  const auto both = [](const std::vector<Cell>& row) {
    return std::get<std::int64_t>(row[2]) + std::get<std::int64_t>(row[3]);
  };
  std::stable_sort(made.table.rows.begin(), made.table.rows.end(),
                   [&both](const auto& a, const auto& b) { return both(a) > both(b); });
  outcome.tables.push_back(std::move(made));
}

void add_right_items(std::size_t items, const FoundNumbers& found, AnalysisOutcome& outcome) {
  NamedTable made{
      "right_items",
      phrase("Analysis", "Trials by their number of correctly matched items"),
      {{"right", "goes", "by_chance"}, {}},
      phrase("Analysis",
             "Expected under guessing: number of trials if every assignment is equally likely.")};
  const double goes = found.value("n.trials").value_or(0.0);
  for (std::size_t k = 0; k <= items; ++k) {
    const std::string key = "n=" + std::to_string(items) + ";k=" + std::to_string(k);
    made.table.rows.push_back(
        {static_cast<std::int64_t>(k),
         static_cast<std::int64_t>(found.value("trials.with.k", std::to_string(k)).value_or(0.0)),
         found.value("null.pmf", key).value_or(0.0) * goes});
  }
  outcome.tables.push_back(std::move(made));
}

/// `fewest`: items of a trial; `equal_size`: the same number in every trial, and therefore one
/// chance level.
void ask_items(std::size_t fewest, bool equal_size, const FoundNumbers& found,
               const StudyTests& tests, AnalysisOutcome& outcome) {
  const Finding* mean = found.find("subj.mean");
  const StudyTests::Test* test = tests.find("items");
  if (mean == nullptr || !mean->value || test == nullptr || !test->p) return;
  const double chance = 1.0 / static_cast<double>(fewest);
  const auto with_numbers = [&](const Phrase& words) {
    return words.with(
        percent(*mean->value), interval_text(*mean),
        equal_size
            ? percent(chance)
            : phrase("Analysis", "1 divided by the number of items, which differs between trials"),
        p_text(*test));
  };
  if (test->is_significant() && holds_in_interval(*mean, chance)) {
    qualify_test_sentence(outcome, test->name, kChanceInInterval);
  }
  const Sayings sayings{
      mean->n == 1
          ? with_numbers(phrase(
                "Analysis",
                "For this participant only: %1 of the items were matched correctly (%2), compared "
                "with a chance level of %3; permutation test, %4. More participants are needed."))
      : holds_in_interval(*mean, chance)
          ? with_numbers(
                phrase("Analysis",
                       "Not established: on average %1 of a participant's items were matched "
                       "correctly (%2), compared with a chance level of %3; permutation test over "
                       "participants, %4. The test is significant, but the CI contains the chance "
                       "level; more participants are needed."))
          : with_numbers(phrase(
                "Analysis",
                "Yes: on average %1 of a participant's items were matched correctly (%2), compared "
                "with a chance level of %3; permutation test over participants, %4.")),
      with_numbers(phrase("Analysis",
                          "Not significantly more often: on average %1 of a participant's items "
                          "were matched correctly (%2), compared with a chance level of %3; "
                          "permutation test over participants, %4.")),
      with_numbers(
          phrase("Analysis",
                 "On average %1 of a participant's items were matched correctly (%2), compared "
                 "with a chance level of %3; permutation test over participants, %4."))};
  add_question(
      outcome, "items", phrase("Analysis", "Are textures matched to their pictures above chance?"),
      said_of(*test, sayings),
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
  add_question(
      outcome, "whole", phrase("Analysis", "How often are all items of a trial correct?"),
      phrase("Analysis",
             "Trials with all items correct: %1 of %2, on average %3 of a participant's trials "
             "(%4); permutation test over participants, %5.")
          .with(std::to_string(static_cast<std::size_t>(*hits->value)), std::to_string(hits->n),
                percent(*share.value), interval_text(share), p_text(*test)),
      phrase("Analysis",
             "%1 Exact permutation test: the pictures are relabelled once per participant, in all "
             "trials alike.")
          .with(averaged(
              phrase("Analysis", "Each participant's proportion of trials with all items correct"),
              mean)),
      "whole_permutations", &share);
}

/// The same finding converted to a unit that is `unit` times as large.
std::optional<Finding> in_units(const Finding* finding, double unit) {
  if (finding == nullptr) return std::nullopt;
  Finding scaled = *finding;
  for (std::optional<double>* number : {&scaled.value, &scaled.low, &scaled.high}) {
    if (*number) **number /= unit;
  }
  return scaled;
}

void ask_confused_pairs(const AnalysisOutcome& made, std::size_t people, AnalysisOutcome& outcome) {
  const auto table = std::find_if(made.tables.begin(), made.tables.end(),
                                  [](const auto& each) { return each.name == "confused_pairs"; });
  if (table == made.tables.end() || table->table.rows.empty()) return;
  const std::vector<Cell>& worst = table->table.rows.front();
  const auto times_of = [](const std::vector<Cell>& pair) {
    return std::get<std::int64_t>(pair[2]) + std::get<std::int64_t>(pair[3]);
  };
  const std::int64_t times = times_of(worst);
  const auto as_often = std::count_if(table->table.rows.begin(), table->table.rows.end(),
                                      [&](const auto& pair) { return times_of(pair) == times; });
  Finding finding{};
  finding.quantity = "confusions";
  finding.key = std::get<std::string>(worst[0]) + '|' + std::get<std::string>(worst[1]);
  finding.value = static_cast<double>(times);
  finding.unit = "1";
  finding.method = "items of one texture that were assigned the picture of the other";
  finding.n = people;
  add_question(
      outcome, "confusions", phrase("Analysis", "Which textures are confused?"),
      times == 0 ? phrase("Analysis", "No texture was confused with another.")
      : as_often > 1
          ? phrase("Analysis",
                   "%1 pairs are confused equally often, and none more often; number of "
                   "confusions, counted in both directions: %2.")
                .with(std::to_string(as_often), std::to_string(times))
          : phrase("Analysis",
                   "%1 and %2 are confused most often; number of confusions, counted in both "
                   "directions: %3.")
                .with(std::get<std::string>(worst[0]), std::get<std::string>(worst[1]),
                      std::to_string(times)),
      phrase("Analysis", "Counts of all responses; a CI would require a model of the confusions."),
      "confused_pairs", &finding, CountedUnit::participants);
}

}  // namespace

void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<Assignment> assignments = assignments_of(gathered, outcome);
  if (assignments.empty()) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "No response assigns each picture to exactly one surface: nothing is analysed."));
    return;
  }
  add_matching_tables(gathered, assignments, outcome);
  add_confusions(gathered, assignments, outcome);

  std::vector<const Assignment*> all{};
  for (const Assignment& assignment : assignments) all.push_back(&assignment);
  const std::vector<Finding> findings =
      analysis_of("matching", "matching", assignments_table(gathered, all, "summary"));
  const FoundNumbers found(findings);
  keep_findings(findings, outcome);
  const std::size_t items = assignments.front().items();
  const auto [least, most] = std::minmax_element(
      assignments.begin(), assignments.end(),
      [](const Assignment& a, const Assignment& b) { return a.items() < b.items(); });
  const std::size_t fewest = least->items();
  const bool equal_size = fewest == most->items();
  std::set<std::string> felt{};
  for (const Finding& finding : findings) {
    if (finding.quantity == "texture.prop") felt.insert(finding.key);
  }
  add_confused_pairs({felt.begin(), felt.end()}, found, outcome);
  if (equal_size) add_right_items(items, found, outcome);
  const std::array<PersonsRow, 1> persons{PersonsRow{"all", ""}};
  add_persons(found, persons, "answers", "share_of_items_correct", outcome);
  const std::size_t people = gathered.people.size();
  const std::array measures{
      Measure{"right_items_per_go", "mean.correct"}, Measure{"by_chance_in_all", "null.mean"},
      Measure{"right_items_in_all", "total.correct", Measure::Form::count},
      Measure{"z", "relabel.z"},
      Measure{"mallows_theta", "mallows.theta", Measure::Form::number, people > 1}};
  add_measures(found, measures, outcome);

  StudyTests tests(gathered);
  const auto is_against = [&](double chance) {
    if (equal_size) tests.state_chance(chance);
  };
  const double chance_of_item = 1.0 / static_cast<double>(items);
  tests.add("items", "", found, "relabel.p.greater");
  is_against(chance_of_item);
  tests.add("whole", "", found, "perfect.relabel.p.greater");
  is_against(1.0 / static_cast<double>(permutations(items)));
  for (const std::string& texture : felt) {
    tests.add("textures", texture, found, "texture.relabel.p.greater", texture);
    is_against(chance_of_item);
  }
  if (found.find("group.perm.p.two", "F-M") != nullptr) {
    tests.add("sexes", "F|M", found, "group.perm.p.two", "F-M");
  }
  tests.finish(outcome);
  ask_items(fewest, equal_size, found, tests, outcome);
  ask_whole(found, tests, outcome);
  ask_confused_pairs(outcome, gathered.people.size(), outcome);
  const auto in_shares = [&](const char* quantity, const char* key) {
    return in_units(found.find(quantity, key), equal_size ? static_cast<double>(items) : 1.0);
  };
  const SexesComparison sexes{
      .women = in_shares("group.mean", "F"),
      .men = in_shares("group.mean", "M"),
      .difference = in_shares("group.diff", "F-M"),
      .scale = equal_size ? SexesScale::shares_of_items : SexesScale::items};
  if (equal_size && sexes.women && sexes.men && sexes.difference) {
    // Under the names of the family `group`.
    for (const auto& [finding, quantity, key] :
         {std::tuple(&sexes.women, "subj.mean", "F"), std::tuple(&sexes.men, "subj.mean", "M"),
          std::tuple(&sexes.difference, "subj.diff", "")}) {
      Finding share = **finding;
      share.quantity = quantity;
      share.key = key;
      share.analysis = "sexes";
      outcome.findings.push_back(std::move(share));
    }
    for (const AnsweringPerson& person : gathered.people) {
      const Finding* own = found.find("subject.share", person.label);
      if (own == nullptr || !person.sex) continue;
      Finding share = *own;
      share.key = person.label + '|' + *person.sex;
      share.analysis = "sexes";
      outcome.findings.push_back(std::move(share));
    }
  }
  ask_sexes(sexes, tests, outcome);
  if (equal_size) {
    std::vector<std::optional<double>> proportions{};
    for (const AnsweringPerson& person : gathered.people) {
      const std::optional<double> mean = found.value("subject.mean", person.label);
      proportions.push_back(mean ? std::optional(*mean / static_cast<double>(items)) : mean);
    }
    ask_equivalence_of_sexes(gathered, proportions, outcome);
  }
  if (equal_size) {
    const std::vector<TextureResponse> responses = responses_to_textures(gathered);
    ask_other_textures(
        {.responses = responses,
         .chance = 1.0 / static_cast<double>(items),
         .proportion = phrase("Analysis", "the proportion of correctly matched items"),
         .assumption =
             phrase("Analysis", "The items of a trial are treated as independent of each other.")},
        outcome);
  } else {
    add_no_crossed_model(
        "chance_differs",
        "the number of items, and therefore the chance level, differs between the trials", outcome);
  }
  const std::vector<RepeatedScore> scores = repeated_scores(gathered);
  ask_reliability(gathered, {scores, phrase("Analysis", "the participants' proportions correct")},
                  outcome);
  add_texture_force(gathered, outcome);
  std::size_t goes = 0;
  for (const Assignment& assignment : assignments) goes += assignment.times;
  remark_on_pooling(goes, people, outcome);
}

}  // namespace asperity
