// Analyses matching: which picture was assigned to which texture.

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/findings/methods/matching/matching_analysis.h"
#include "app/findings/methods/matching/matching_questions.h"
#include "app/findings/methods/matching/matching_tables.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/outcome/test_sentences.h"
#include "app/findings/shared/crossed_textures.h"
#include "app/findings/shared/group_equivalence.h"
#include "app/findings/shared/matched_trials.h"
#include "app/findings/shared/participant_pairs.h"
#include "app/findings/shared/repetition_reliability.h"

namespace asperity {

namespace {

/// The same finding converted to a unit that is `unit` times as large.
std::optional<Finding> in_units(const Finding* finding, double unit) {
  if (finding == nullptr) return std::nullopt;
  Finding scaled = *finding;
  for (std::optional<double>* number : {&scaled.value, &scaled.low, &scaled.high}) {
    if (*number) **number /= unit;
  }
  return scaled;
}

bool are_of_equal_size(const std::vector<MatchedTrial>& assignments) {
  return std::all_of(assignments.begin(), assignments.end(), [&assignments](const auto& each) {
    return each.items() == assignments.front().items();
  });
}

/// Correctly matched items and all items of each of the gathered people, in their order.
std::vector<HitCount> items_of_people(const GatheredAnswers& gathered,
                                      const std::vector<MatchedTrial>& assignments) {
  std::vector<HitCount> own(gathered.people.size());
  for (const MatchedTrial& assignment : assignments) {
    own[assignment.person].trials += assignment.times * assignment.items();
    own[assignment.person].hits += assignment.times * assignment.right;
  }
  return own;
}

/// The proportion expected under guessing, the mean over the participants: of a participant's items one of each trial, which is
/// correct on average, and of the trials those in which all are.
struct ChanceOfMatching {
  double of_items = 0.0;
  double of_trials = 0.0;
};

ChanceOfMatching chance_of_matching(const std::vector<MatchedTrial>& assignments) {
  struct Own {
    double trials = 0.0;
    double items = 0.0;
    double whole = 0.0;
  };
  std::map<std::uint32_t, Own> people{};
  for (const MatchedTrial& one : assignments) {
    const auto times = static_cast<double>(one.times);
    Own& own = people[one.person];
    own.trials += times;
    own.items += times * static_cast<double>(one.items());
    own.whole += times / static_cast<double>(permutations(one.items()));
  }
  ChanceOfMatching chance{};
  for (const auto& [person, own] : people) {
    chance.of_items += own.trials / own.items / static_cast<double>(people.size());
    chance.of_trials += own.whole / own.trials / static_cast<double>(people.size());
  }
  return chance;
}

/// The tests of all items, of whole trials and, of the textures of `felt`, of single ones. `found`: of the family `matching`.
void add_matching_tests(const std::vector<MatchedTrial>& assignments,
                        const std::set<std::string>& felt, const FoundNumbers& found,
                        StudyTests& tests) {
  const bool varies = !are_of_equal_size(assignments);
  const ChanceOfMatching chance = chance_of_matching(assignments);
  tests.add("items", "", found, "relabel.p.greater");
  tests.state_chance(chance.of_items, varies);
  tests.add("whole", "", found, "perfect.relabel.p.greater");
  tests.state_chance(chance.of_trials, varies);
  for (const std::string& texture : felt) {
    tests.add("textures", texture, found, "texture.relabel.p.greater", texture);
    // Its interval is over trials, and is not stated with the test.
    if (!varies) tests.state_chance(chance.of_items);
  }
}

/// The textures with responses.
std::set<std::string> felt_in(std::span<const Finding> findings) {
  std::set<std::string> felt{};
  for (const Finding& finding : findings) {
    if (is(finding, "texture.prop")) felt.insert(finding.key.last());
  }
  return felt;
}

std::vector<Finding> matching_findings_of(const GatheredAnswers& gathered,
                                          const std::vector<MatchedTrial>& assignments,
                                          const char* parts) {
  std::vector<const MatchedTrial*> all{};
  for (const MatchedTrial& assignment : assignments) all.push_back(&assignment);
  return analysis_of("matching", "matching", matched_trials_table(gathered, all, parts));
}

}  // namespace

std::vector<StudyTest> test_matching(const GatheredAnswers& gathered) {
  StudyTests tests(gathered);
  AnalysisOutcome unused{};
  const std::vector<MatchedTrial> assignments = matched_trials(gathered, unused);
  if (assignments.empty()) return std::move(tests).take_family();
  const bool needs_all = tests.is_in_family("whole") || tests.is_in_family("textures") ||
                         tests.is_in_family(kSexesTest);
  const std::vector<Finding> findings =
      matching_findings_of(gathered, assignments, needs_all ? "summary" : "totals");
  const FoundNumbers found(findings);
  add_matching_tests(assignments, felt_in(findings), found, tests);
  if (found.find("group.perm.p.two", "F-M") != nullptr) {
    tests.add("sexes", {"F", "M"}, found, "group.perm.p.two", "F-M");
    tests.state_difference(found.find("group.diff", "F-M"));
  }
  if (tests.is_in_family(kGroupsTest)) {
    PairComparisons(gathered, pairs_of_groups(gathered), items_of_people(gathered, assignments))
        .add_tests(tests, unused);
  }
  return std::move(tests).take_family();
}

void analyze_matching(const GatheredAnswers& gathered, AnalysisOutcome& outcome) {
  const std::vector<MatchedTrial> assignments = matched_trials(gathered, outcome);
  if (assignments.empty()) {
    outcome.remarks.push_back(
        phrase("Analysis",
               "No response assigns each picture to exactly one surface, so that the matchings are "
               "not analysed; ask participants to assign every picture."));
    return;
  }
  add_matching_tables(gathered, assignments, outcome);
  add_confusions(gathered, assignments, outcome);

  const std::vector<Finding> findings = matching_findings_of(gathered, assignments, "summary");
  const FoundNumbers found(findings);
  keep_findings(findings, outcome);
  const std::size_t items = assignments.front().items();
  const bool equal_size = are_of_equal_size(assignments);
  const std::set<std::string> felt = felt_in(findings);
  add_confused_pairs({felt.begin(), felt.end()}, found, outcome);
  if (equal_size) add_right_items(items, found, outcome);
  const std::array<PersonsRow, 1> persons{PersonsRow{"all", ""}};
  add_persons(found, persons, columns::kAllAnswers, "share_of_items_correct", outcome);
  const std::size_t people = gathered.people.size();
  const std::array measures{
      Measure{"right_items_per_go", "mean.correct"}, Measure{"by_chance_in_all", "null.mean"},
      Measure{"right_items_in_all", "total.correct", Measure::Form::count},
      Measure{"z", "relabel.z"},
      Measure{"mallows_theta", "mallows.theta", Measure::Form::number, people > 1}};
  add_measures(found, measures, outcome);

  StudyTests tests(gathered);
  add_matching_tests(assignments, felt, found, tests);
  if (found.find("group.perm.p.two", "F-M") != nullptr) {
    tests.add("sexes", {"F", "M"}, found, "group.perm.p.two", "F-M");
    tests.state_difference(found.find("group.diff", "F-M"));
  }
  const PairComparisons groups(gathered, pairs_of_groups(gathered),
                               items_of_people(gathered, assignments));
  groups.add_tests(tests, outcome);
  tests.finish(outcome);
  ask_items(found, tests, outcome);
  ask_whole(found, tests, outcome);
  ask_confused_pairs(outcome, gathered.people.size(), outcome);
  const auto in_shares = [&](QuantityName quantity, const char* key) {
    return in_units(found.find(quantity, key), equal_size ? static_cast<double>(items) : 1.0);
  };
  const ParticipantPair sexes = women_and_men(gathered);
  const PairMeans means{.first = in_shares("group.mean", "F"),
                        .second = in_shares("group.mean", "M"),
                        .difference = in_shares("group.diff", "F-M"),
                        .scale = equal_size ? PairScale::shares_of_items : PairScale::items};
  if (equal_size && means.first && means.second && means.difference) {
    // Under the names of the family `group`.
    for (const auto& [finding, quantity, key] :
         {std::tuple(&means.first, "subj.mean", "F"), std::tuple(&means.second, "subj.mean", "M"),
          std::tuple(&means.difference, "subj.diff", "")}) {
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
      share.key = {person.label, *person.sex};
      share.analysis = "sexes";
      outcome.findings.push_back(std::move(share));
    }
  }
  ask_pair(sexes, means, tests, outcome);
  if (equal_size) {
    std::vector<std::optional<double>> proportions{};
    for (const AnsweringPerson& person : gathered.people) {
      const std::optional<double> mean = found.value("subject.mean", person.label);
      proportions.push_back(mean ? std::optional(*mean / static_cast<double>(items)) : mean);
    }
    ask_equivalence(sexes, gathered, proportions, outcome);
  }
  groups.ask(PairScale::shares_of_items, "", tests, outcome);
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
  for (const MatchedTrial& assignment : assignments) goes += assignment.times;
  remark_on_pooling(goes, people, outcome);
}

}  // namespace asperity
