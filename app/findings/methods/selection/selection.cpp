// Analyses selections: all choices where every trial presents the same models, otherwise each pair separately.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "analysis/numbers/proportion.h"
#include "app/findings/methods/selection/selection_analysis.h"
#include "app/findings/methods/selection/target_choices.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/estimate_sentences.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/group_comparisons.h"
#include "app/findings/shared/participant_pairs.h"
#include "app/findings/shared/selection_choices.h"
#include "app/findings/shared/selection_questions.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

namespace {

constexpr const char* kChoice = "choice";  // the analysis of the choices

/// All counts, from one pass over the responses.
struct SelectionCounts {
  explicit SelectionCounts(const Selection& selection, const ChapterCells& cells);

  CountTable table_1{};
  std::vector<Tally> shares{};     ///< column × item
  std::vector<Tally> pairs{};      ///< column × item × item, the first before the second
  std::vector<Tally> textures{};   ///< texture × item
  std::vector<Tally> positions{};  ///< by position
  Tally choices{};
};

SelectionCounts::SelectionCounts(const Selection& selection, const ChapterCells& cells) {
  const std::size_t items = selection.items.size();
  std::vector<std::string> labels = selection.items;
  if (selection.can_abstain) labels.emplace_back(kCannotTell);
  table_1 = count_table(std::move(labels), cells.columns());
  shares.resize(cells.columns().size() * items);
  pairs.resize(cells.columns().size() * items * items);
  textures.resize(selection.textures.size() * items);
  positions.resize(selection.positions);
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    const auto surfaces = selection.gathered.surfaces_of(answer);
    const std::size_t chosen = selection.chosen(answer);
    const std::array<std::size_t, 2> columns =
        cells.columns_of(selection.gathered.column_of(answer));
    choices.count(answer.person, true, surfaces.size());
    for (std::size_t i = columns[0] == columns[1] ? 1 : 0; i < 2; ++i) {
      const std::size_t column = columns[i];
      if (chosen != kNoChoice || selection.can_abstain) {
        ++table_1.at(chosen == kNoChoice ? items : chosen, column);
      }
      if (chosen == kNoChoice) continue;
      for (const FeltSurface& surface : surfaces) {
        const std::size_t item = selection.item(surface);
        shares[column * items + item].count(answer.person, item == chosen, surfaces.size());
        if (item == chosen) continue;
        const std::size_t first = std::min(item, chosen);
        const std::size_t second = std::max(item, chosen);
        pairs[(column * items + first) * items + second].count(answer.person, chosen == first, 2);
      }
    }
    if (chosen == kNoChoice) continue;
    for (std::size_t place = 0; place < surfaces.size(); ++place) {
      const std::size_t item = selection.item(surfaces[place]);
      textures[selection.texture(answer) * items + item].count(answer.person, item == chosen,
                                                               surfaces.size());
      positions[place].count(answer.person, item == chosen, surfaces.size());
    }
  }
}

void add_share_tables(const Selection& selection, const SelectionCounts& counts,
                      const ChapterCells& cells, AnalysisOutcome& outcome) {
  const std::size_t items = selection.items.size();
  ShareTable shares{kAllShares,
                    phrase("Analysis", "Proportion of choices of each model"),
                    phrase("Analysis",
                           "The chance level is 1 divided by the number of surfaces presented. p: "
                           "exact binomial test, two-sided, uncorrected for the number of rows; "
                           "the proportions of one column are not independent of each other."),
                    {columns::kRepetition, columns::kItem},
                    columns::kChosen,
                    "share_chosen",
                    {}};
  if (selection.can_abstain) {
    shares.note =
        phrase("Analysis",
               "%1 “Cannot tell” responses are counted in the table of counts and left out here.")
            .with(shares.note);
  }
  ShareTable pairs{
      "pairs",
      phrase("Analysis", "Pairwise comparisons of the models, among the choices of either model"),
      phrase("Analysis", "The chance level is 1/2: choices of a third model are not counted."),
      {columns::kRepetition, columns::kItem, kAgainst},
      columns::kChosen,
      "share_of_pair",
      {}};
  for (std::size_t column = 0; column < cells.columns().size(); ++column) {
    for (std::size_t item = 0; item < items; ++item) {
      shares.rows.push_back(
          {{cells.columns()[column], selection.items[item]}, counts.shares[column * items + item]});
      for (std::size_t other = item + 1; other < items; ++other) {
        pairs.rows.push_back(
            {{cells.columns()[column], selection.items[item], selection.items[other]},
             counts.pairs[(column * items + item) * items + other]});
      }
    }
  }
  add_shares(shares, outcome).figures = [](const ResultTable& table, const AnalysisOutcome& drawn) {
    return std::vector{share_forest(table, drawn, {kPersonMeans, kChoice})};
  };
  add_shares(pairs, outcome).figures = figures_of_pairs;
  ShareTable textures{kSharesByTexture,
                      phrase("Analysis", "Proportion of choices of each model, by texture"),
                      {},
                      {columns::kTexture, columns::kItem},
                      columns::kChosen,
                      "share_chosen",
                      {}};
  for (std::size_t texture = 0; texture < selection.textures.size(); ++texture) {
    for (std::size_t item = 0; item < items; ++item) {
      textures.rows.push_back({{selection.textures[texture], selection.items[item]},
                               counts.textures[texture * items + item]});
    }
  }
  add_shares(textures, outcome).figures = [](const ResultTable& table, const AnalysisOutcome&) {
    return std::vector{answering("textures", share_forest(table))};
  };
}

void add_positions(const SelectionCounts& counts, AnalysisOutcome& outcome) {
  add_positions_table(counts.positions,
                      phrase("Analysis",
                             "The position is the place of a surface in the order of "
                             "presentation, regardless of its model. "
                             "Where the order of surfaces is random, a proportion above the "
                             "chance level is a position bias, not a preference."),
                      outcome);
}

void add_scale_table(const Selection& selection, const FoundNumbers& found,
                     AnalysisOutcome& outcome) {
  const bool paired = selection.two_offered;
  const QuantityName log_worth = scale_quantity(selection);
  if (found.find(log_worth, selection.items.front()) == nullptr) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The models cannot be placed on a scale: one of them was always or never chosen "
               "when it was presented, or was never presented with the others, so that its "
               "distance has no finite estimate. Collect more choices with this model."));
    return;
  }
  add_worth_scale(
      {.log_worth = log_worth,
       .worth = paired ? QuantityName("bt.worth") : "pl.worth",
       .no_interval = paired ? QuantityName("bt.cluster.status") : "pl.cluster.status",
       .title = phrase("Analysis", "The models on one scale"),
       .note =
           paired
               ? phrase(
                     "Analysis",
                     "Bradley–Terry model: of two models, i is chosen with probability 1/(1 + "
                     "exp(l_j − l_i)). The log-worths l have a mean of 0; the worths sum to 1. %1")
               : phrase("Analysis",
                        "Plackett–Luce model: of several models, each is chosen in proportion to "
                        "its worth. The log-worths have a mean of 0; the worths sum to 1. %1")},
      selection.items, found, outcome);
}

/// Whether every participant felt every texture equally often, so that textures are exchangeable.
bool is_balanced(const Selection& selection) {
  std::vector<std::size_t> trials(selection.gathered.people.size() * selection.textures.size());
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    ++trials[answer.person * selection.textures.size() + selection.texture(answer)];
  }
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i] != trials[i - i % selection.textures.size()]) return false;
  }
  return true;
}

void test_textures(const Selection& selection, StudyTests& tests, AnalysisOutcome& outcome) {
  if (!asks_about_textures(selection)) return;
  if (!is_balanced(selection)) {
    if (tests.is_in_family("textures")) tests.add_untested("textures", "", "textures_unbalanced");
    return;
  }
  const auto target = static_cast<std::size_t>(
      std::lower_bound(selection.items.begin(), selection.items.end(), selection.target()) -
      selection.items.begin());
  const std::vector<Finding> findings = analysis_of(
      "texture", "selection",
      choices_table(
          selection, selection.textures,
          [&](const GatheredAnswer& answer) {
            return selection.chosen(answer) == target ? selection.texture(answer) : kNoChoice;
          },
          selection.textures.front()));
  const FoundNumbers found(findings);
  const std::size_t participants = selection.gathered.people.size();
  if (found.find("relabel.exact.p") == nullptr) {
    tests.add_untested("textures", "", "target_never_chosen");
    return;
  }
  tests.add("textures", "", found, "relabel.exact.p");
  tests.leave_out(participants - tests.tests().back().n,
                  phrase("Analysis",
                         "Participants who never chose the target cannot contribute to the test of "
                         "textures and are not counted in its n"));
  keep_findings(findings, outcome, [](const Finding& finding) {
    return finding.quantity.starts_with("relabel.exact") ||
           finding.quantity.starts_with("signflip");
  });
}

/// The findings of the family `selection` on the choices: for each pair separately where trials
/// offer different items. `parts`: those of the family's findings that are needed.
std::vector<Finding> choice_findings(const Selection& selection, const char* parts = "all") {
  constexpr const char* kFamily = "selection";
  if (selection.items.size() < 2) return {};
  if (selection.all_offered) {
    TidyInput choices = choices_table(
        selection, selection.items,
        [&](const GatheredAnswer& answer) { return selection.chosen(answer); }, selection.target());
    choices.options.set("parts", std::string(parts));
    return analysis_of(kChoice, kFamily, std::move(choices));
  }
  return pair_findings(kChoice, selection, parts);
}

/// Each participant's proportions: of every item, or of the first of every pair.
void add_shares_of_persons(const Selection& selection, const FoundNumbers& found,
                           AnalysisOutcome& outcome) {
  std::vector<PersonsRow> rows{};
  if (selection.all_offered) {
    for (const std::string& item : selection.items) rows.push_back({item, item});
    ResultTable* const made = add_persons(found, rows, columns::kItem, "share_chosen", outcome);
    if (made == nullptr) return;
    made->figures = [](const ResultTable& table, const AnalysisOutcome& drawn) {
      std::vector<Figure> figures{};
      // A single mean is drawn with the proportions that it averages.
      if (table.rows.size() > 1) {
        figures.push_back(
            answering("preference", person_forest(table, drawn, kChoice, kAllShares)));
      }
      return figures;
    };
    return;
  }
  for (const ItemPair& pair : pairs_offered(selection)) {
    const FindingKey key{selection.items[pair.first], selection.items[pair.second]};
    rows.push_back({JoinedCell{{key[0], key[1]}, words_of_subject({key[0], key[1]})}, key});
  }
  add_persons(found, rows, columns::kPair, "share_of_pair", outcome, "persons_by_pair");
}

/// Tests of a declared family that would compare all choices.
void add_untestable(StudyTests& tests) {
  for (const char* const name : {"preference", "textures"}) {
    if (!tests.is_in_family(name)) continue;
    tests.add_untested(name, "", "not every model is presented in every trial");
  }
}

void add_choice_tests(const Selection& selection, const FoundNumbers& found, StudyTests& tests) {
  const bool only_target = tests.is_in_family("target_pairs");
  for (const ItemPair& pair : pairs_offered(selection)) {
    const std::string& first = selection.items[pair.first];
    const std::string& second = selection.items[pair.second];
    const bool of_target = first == selection.target() || second == selection.target();
    const FindingKey key{first, second};
    tests.add(only_target && of_target ? "target_pairs" : "pairs", {first, second}, found,
              "signflip.p.two", key);
    state_share_of_pair(found, key, tests);
  }
}

void add_preference_test(const Selection& selection, const FoundNumbers& found, StudyTests& tests) {
  tests.add("preference", "", found, "relabel.exact.p");
  if (selection.items.size() == 2) state_share_of_pair(found, selection.items.front(), tests);
}

void add_position_test(const Selection& selection, const FoundNumbers& found, StudyTests& tests) {
  tests.add("position", "", found, "relabel.exact.p");
  if (selection.positions == 2) state_share_of_pair(found, "1", tests);
}

std::vector<Finding> position_findings(const Selection& selection) {
  return analysis_of(
      "position", "selection",
      choices_table(
          selection, numbers_up_to(selection.positions),
          [&](const GatheredAnswer& answer) { return selection.position(answer); }, "1"));
}

PairComparisons comparisons_of_groups(const Selection& selection) {
  return {
      selection.gathered,
      selection.has_target() ? pairs_of_groups(selection.gathered) : std::vector<ParticipantPair>{},
      target_choices_of_people(selection)};
}

/// The proportions of the trials with an item in which a participant chose it.
GroupComparisons profiles_of_groups(const Selection& selection) {
  std::map<std::pair<std::uint32_t, std::string>, HitCount> counts{};
  for (const GatheredAnswer& answer : selection.gathered.answers) {
    std::set<std::size_t> offered{};
    for (const FeltSurface& surface : selection.gathered.surfaces_of(answer)) {
      offered.insert(selection.item(surface));
    }
    offered.erase(kNoChoice);
    for (const std::size_t item : offered) {
      HitCount& count = counts[{answer.person, selection.items[item]}];
      ++count.trials;
      if (selection.chosen(answer) == item) ++count.hits;
    }
  }
  GroupProfile profile{.words = phrase("Analysis", "which items are chosen"),
                       .items = selection.items};
  for (const auto& [of, count] : counts) profile.values[of] = proportion(count);
  GroupComparisons groups(selection.gathered);
  groups.add(profile);
  return groups;
}

/// Whether every trial presents the same number of surfaces, and more than one.
bool present_equally_many(const Selection& selection) {
  const auto& answers = selection.gathered.answers;
  return selection.positions > 1 &&
         std::all_of(answers.begin(), answers.end(), [&selection](const GatheredAnswer& answer) {
           return answer.surface_count == selection.positions;
         });
}

}  // namespace

std::vector<StudyTest> test_selection(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  const Selection selection(gathered);
  if (selection.items.empty()) return std::move(tests).take_family();
  AnalysisOutcome unused{};
  const bool needs_all = tests.is_in_family("preference") && selection.all_offered;
  const std::vector<Finding> choice = choice_findings(selection, needs_all ? "all" : "pairs");
  const FoundNumbers found(choice);
  add_choice_tests(selection, found, tests);
  if (!selection.all_offered) add_untestable(tests);
  if (needs_all && !choice.empty()) add_preference_test(selection, found, tests);
  if (tests.is_in_family("position") && present_equally_many(selection)) {
    const std::vector<Finding> position = position_findings(selection);
    add_position_test(selection, FoundNumbers(position), tests);
  }
  if (tests.is_in_family("textures")) test_textures(selection, tests, unused);
  if (tests.is_in_family(kGroupsTest)) comparisons_of_groups(selection).add_tests(tests, unused);
  if (tests.is_in_family(kGroupProfilesTest))
    profiles_of_groups(selection).add_tests(tests, unused);
  return std::move(tests).take_family();
}

void analyze_selection(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const Selection selection(gathered);
  if (selection.items.empty()) {
    outcome.remarks.push_back(phrase(
        "Analysis",
        "No surface was presented before these responses, so that no comparison is possible; "
        "collect further responses."));
    return;
  }
  const ChapterCells cells(gathered);
  SelectionCounts counts(selection, cells);
  counts.table_1.name = "table_1";
  counts.table_1.title = phrase("Analysis", "Choices (counts)");
  counts.table_1.label_column = columns::kItem;
  if (gathered.compared_parameter) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "The alternatives differ in %1 alone: these results are choices and do not show "
               "whether the levels can be discriminated.")
            .with(words_of_parameter(*gathered.compared_parameter)));
  }
  counts.table_1.note = chance_note(
      counts.choices, selection.all_offered
                          ? phrase("Analysis", "Chance level: 1/%1 of the choices for each model.")
                          : phrase("Analysis",
                                   "Chance level: each model in 1/%1 of the choices in the trials "
                                   "in which it was presented."));
  add_counts(counts.table_1, outcome);
  add_share_tables(selection, counts, cells, outcome);

  StudyTests tests(gathered);
  const std::size_t people = gathered.people.size();
  const std::vector<Finding> choice = choice_findings(selection);
  if (!selection.all_offered) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "Not every model is presented in every trial: each pair is tested on the trials in "
               "which both were presented, and the scale combines all trials."));
  }
  const FoundNumbers found(choice);
  keep_findings(choice, outcome);
  add_shares_of_persons(selection, found, outcome);

  add_choice_tests(selection, found, tests);
  if (selection.all_offered) {
    if (!choice.empty()) add_preference_test(selection, found, tests);
  } else {
    add_untestable(tests);
  }

  const bool same_size = present_equally_many(selection);
  std::vector<Finding> position{};
  if (same_size) {
    position = position_findings(selection);
    keep_findings(position, outcome);
  }
  const FoundNumbers found_position(position);
  if (same_size) add_position_test(selection, found_position, tests);
  test_textures(selection, tests, outcome);
  const PairComparisons groups = comparisons_of_groups(selection);
  groups.add_tests(tests, outcome);
  const GroupComparisons profiles = profiles_of_groups(selection);
  profiles.add_tests(tests, outcome);

  add_positions(counts, outcome);
  if (same_size) {
    std::vector<PersonsRow> places{};
    for (const std::string& place : numbers_up_to(selection.positions)) {
      places.push_back({place, place});
    }
    add_persons(found_position, places, columns::kPosition, "share_of_position", outcome,
                kPersonsByPosition);
  }
  const std::vector<Finding> scale =
      selection.two_offered ? analysis_of("scale", "paired", comparisons_of(selection))
                            : analysis_of("scale", "ranking", first_places_of(selection));
  keep_findings(scale, outcome);
  if (selection.items.size() > 1) add_scale_table(selection, FoundNumbers(scale), outcome);
  tests.finish(outcome);
  if (selection.all_offered) {
    state_means_of_items(outcome, {.analysis = kChoice,
                                   .quantity = "subj.mean",
                                   .items = selection.items,
                                   .tests = {"preference"},
                                   .tests_of_pairs = {"pairs", "target_pairs"},
                                   .shown = display_percent});
  }

  const std::string pairs = tests.is_in_family("target_pairs") ? "target_pairs" : "pairs";
  const FoundNumbers found_scale(scale);
  // The main comparison comes first: the pairs, where trials present different models.
  if (selection.all_offered) ask_preference(selection, found, found_scale, tests, outcome);
  ask_pairs(words_of_pairs(selection, pairs), tests, found, outcome);
  if (!selection.all_offered) ask_preference(selection, found, found_scale, tests, outcome);
  ask_position(
      selection.positions,
      phrase("Analysis", "The same test as for the models, with positions in their place."),
      found_position, tests, outcome);
  ask_textures(selection, tests, outcome);
  ask_target_choices(selection, outcome);
  groups.ask(PairScale::shares_of_target, selection.target(), tests, outcome);
  profiles.report(tests, outcome);
  add_texture_force(gathered, outcome);
  remark_on_pooling(gathered.answers.size(), people, outcome);
}

}  // namespace asperity
