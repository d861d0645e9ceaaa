// Exploration by condition and over the session, from the rows of a study.

#include "app/findings/shared/exploration.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/shared/exploration_model.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

ComplianceRow compliance_of_surface(int position, const std::string& quantity, double mean,
                                    double sd = 0.0) {
  ComplianceRow row{};
  row.position = position;
  row.quantity = quantity;
  row.mean = mean;
  row.sd = sd;
  row.p05 = row.p50 = row.p95 = mean;
  return row;
}

/// How one surface was explored; nothing where it was not touched for a stroke.
struct MadeUpExploration {
  double contact_s = 0.0;
  std::optional<double> force_N{};
  std::optional<double> stroke_length_m{};
};

void explore(MadeUpTrial& trial, const MadeUpExploration& made) {
  const int position = static_cast<int>(trial.compliance.size()) / 5 + 1;
  const auto add = [&](const char* quantity, double mean, double sd = 0.0) {
    trial.compliance.push_back(compliance_of_surface(position, quantity, mean, sd));
  };
  add("normal_force_N", made.force_N.value_or(0.0), made.force_N ? 0.25 : 0.0);
  add("speed_m_per_s", made.force_N ? 0.05 : 0.0, made.force_N ? 0.01 : 0.0);
  add("contact_s", made.contact_s);
  add("strokes", made.stroke_length_m ? 3.0 : 0.0);
  add("stroke_length_m", made.stroke_length_m.value_or(0.0));
}

/// A recognition of one texture.
MadeUpTrial explored_trial(const std::string& texture, const MadeUpExploration& made) {
  MadeUpTrial trial{};
  trial.factors_json = R"({"texture": ")" + texture + "\"}";
  trial.surfaces = {surface_of(texture, "height_map", texture)};
  trial.answers = {texture};
  trial.right = {texture};
  trial.options = {"metal", "wood"};
  explore(trial, made);
  return trial;
}

AnalysisOutcome analyze_explored(const std::vector<std::vector<MadeUpTrial>>& by_participant) {
  return analysed("recognition", "{}", {.first = 0, .sex = "F"}, by_participant);
}

/// The cells of a row by column.
class ExploredCells final {
 public:
  ExploredCells(const AnalysisOutcome& outcome, const std::string& table,
                const std::string& measure, const std::string& factor,
                const std::string& level = {}) {
    table_ = table_of(outcome, table).table;
    const Cell third = level.empty() ? Cell{} : Cell{level};
    const auto found =
        std::find_if(table_.rows.begin(), table_.rows.end(), [&](const std::vector<Cell>& row) {
          return row[0] == Cell{measure} && row[1] == Cell{factor} && row[2] == third;
        });
    if (found == table_.rows.end()) {
      throw std::runtime_error("no row of " + measure + ' ' + factor + ' ' + level);
    }
    row_ = *found;
  }
  Cell at(const std::string& column) const {
    const auto place = column_of(table_, column);
    return place ? row_[*place] : Cell{};
  }
  double number(const std::string& column) const { return number_of(at(column)).value(); }

 private:
  Table table_{};
  std::vector<Cell> row_{};
};

bool has_row(const AnalysisOutcome& outcome, const std::string& table, const std::string& measure,
             const std::string& factor) {
  const StoredTable* const named = find_table(outcome, table);
  return named != nullptr &&
         std::any_of(named->table.rows.begin(), named->table.rows.end(), [&](const auto& row) {
           return row[0] == Cell{measure} && row[1] == Cell{factor};
         });
}

const std::vector<std::vector<MadeUpTrial>> kTwoParticipants{
    {explored_trial("wood", {1.0, 0.5, 0.04}), explored_trial("wood", {3.0, 0.7, 0.06}),
     explored_trial("metal", {5.0, 1.0, 0.05}), explored_trial("metal", {7.0, 2.0, 0.05})},
    {explored_trial("wood", {2.0, 1.0, 0.02}), explored_trial("wood", {4.0, 1.0, 0.02}),
     explored_trial("metal", {4.0, 3.0, 0.03}), explored_trial("metal", {10.0, 2.0, {}})}};

TEST(Exploration, IsDescribedByConditionOverParticipants) {
  const AnalysisOutcome outcome = analyze_explored(kTwoParticipants);
  // Medians of contact times with wood: 2 and 3; over both 2.5, quartiles 2.25 and 2.75.
  const ExploredCells wood(outcome, kExploration, "contact_s", "texture", "wood");
  EXPECT_EQ(wood.at("persons"), Cell{std::int64_t{2}});
  EXPECT_EQ(wood.at("measurements"), Cell{std::int64_t{4}});
  EXPECT_NEAR(wood.number("median"), 2.5, 1e-12);
  EXPECT_NEAR(wood.number("lower_quartile"), 2.25, 1e-12);
  EXPECT_NEAR(wood.number("upper_quartile"), 2.75, 1e-12);
  EXPECT_EQ(wood.at("mean"), Cell{});
  // Both participants' medians of all four: 4.
  EXPECT_NEAR(ExploredCells(outcome, kExploration, "contact_s", "all").number("median"), 4.0,
              1e-12);
  // Mean forces with metal: 1.5 and 2.5; mean 2, SD √½.
  const ExploredCells metal(outcome, kExplorationForces, "force_N", "texture", "metal");
  EXPECT_NEAR(metal.number("mean"), 2.0, 1e-12);
  EXPECT_NEAR(metal.number("sd"), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(metal.at("median"), Cell{});
  EXPECT_NEAR(ExploredCells(outcome, kExplorationForces, "force_sd_N", "all").number("mean"), 0.25,
              1e-12);
  EXPECT_NEAR(ExploredCells(outcome, kExplorationForces, "speed_m_per_s", "all").number("mean"),
              0.05, 1e-12);
  EXPECT_NEAR(ExploredCells(outcome, kExploration, "response_s", "all").number("median"), 1.5,
              1e-12);
  EXPECT_FALSE(has_row(outcome, kExploration, "contact_s", "surface"));  // it is the texture
}

// The last surface was touched without a stroke.
TEST(Exploration, LeavesOutWhatWasNotMeasured) {
  const AnalysisOutcome outcome = analyze_explored(kTwoParticipants);
  const ExploredCells length(outcome, kExploration, "stroke_length_m", "texture", "metal");
  EXPECT_EQ(length.at("measurements"), Cell{std::int64_t{3}});
  EXPECT_NEAR(length.number("mean"), 0.04, 1e-12);  // of 0.05 and 0.03
  const ExploredCells strokes(outcome, kExploration, "strokes", "texture", "metal");
  EXPECT_EQ(strokes.at("measurements"), Cell{std::int64_t{4}});
  EXPECT_NEAR(strokes.number("mean"), 2.25, 1e-12);  // of 3 and 1.5
}

TEST(Exploration, HasARowWithoutNumbersWhereNothingIsStored) {
  std::vector<MadeUpTrial> trials{explored_trial("wood", {1.0, {}, {}}),
                                  explored_trial("metal", {2.0, {}, {}})};
  const AnalysisOutcome outcome = analyze_explored({trials, trials});
  const ExploredCells force(outcome, kExplorationForces, "force_N", "all");
  EXPECT_EQ(force.at("persons"), Cell{std::int64_t{0}});
  EXPECT_EQ(force.at("measurements"), Cell{std::int64_t{0}});
  EXPECT_EQ(force.at("mean"), Cell{});
  EXPECT_FALSE(has_row(outcome, kExplorationForces, "force_N", "texture"));
  EXPECT_THAT(table_of(outcome, kExplorationForces).note.english(),
              HasSubstr("Not stored by these sessions: mean normal force, N, "));
  const AnalysisOutcome complete = analyze_explored(kTwoParticipants);
  EXPECT_THAT(table_of(complete, kExplorationForces).note.english(), Not(HasSubstr("Not stored")));
}

// Two surfaces in a trial, the first visited twice. Attempts that were made up without visits have contact times.
TEST(Exploration, HasVisitsAndPathWhereTheyAreStored) {
  const auto trial_of = [](bool has_visits) {
    MadeUpTrial trial{};
    trial.surfaces = {surface_of("wood", "height_map", "wood"),
                      surface_of("metal", "height_map", "metal")};
    trial.answers = {"wood", "metal"};
    trial.right = trial.answers;
    trial.options = trial.answers;
    explore(trial, {2.0, 1.0, 0.05});
    explore(trial, {0.0, {}, {}});
    if (has_visits) {
      trial.surfaces[0].visits = {{.contact_ns = 7'000'000'000,
                                   .offset_ns = 8'000'000'000,
                                   .contact_s = 0.5,
                                   .path_m = 0.1},
                                  {.contact_ns = 9'000'000'000,
                                   .offset_ns = 9'900'000'000,
                                   .contact_s = 0.5,
                                   .path_m = 0.3}};
    }
    return trial;
  };
  const auto outcome_of = [&](bool has_visits) {
    MadeUpStudy made;
    const std::int64_t protocol = made.add_protocol("matching", "matching");
    for (const char* const label : {"a", "b"}) {
      made.add_person(label, "F");
      made.add_session(label, protocol, {trial_of(has_visits), trial_of(has_visits)});
    }
    return analyze_study(made.study()).front();
  };
  const AnalysisOutcome stored = outcome_of(true);
  EXPECT_NEAR(ExploredCells(stored, kExploration, "visits", "surface", "wood").number("mean"), 2.0,
              1e-12);
  EXPECT_NEAR(ExploredCells(stored, kExploration, "path_m", "surface", "wood").number("mean"), 0.4,
              1e-12);
  EXPECT_NEAR(ExploredCells(stored, kExploration, "visits", "surface", "metal").number("mean"), 0.0,
              1e-12);
  const AnalysisOutcome earlier = outcome_of(false);
  for (const char* const measure : {"visits", "path_m"}) {
    const ExploredCells missing(earlier, kExploration, measure, "all");
    EXPECT_EQ(missing.at("measurements"), Cell{std::int64_t{0}});
    EXPECT_EQ(missing.at("mean"), Cell{});
  }
  EXPECT_THAT(table_of(earlier, kExploration).note.english(),
              HasSubstr("Not stored by these sessions: visits, path in contact, m."));
}

TEST(Exploration, IsAbsentWhereNoneIsStored) {
  MadeUpTrial trial = explored_trial("wood", {1.0, 0.5, 0.04});
  trial.compliance.clear();
  const AnalysisOutcome outcome = analyze_explored({{trial, trial}, {trial, trial}});
  EXPECT_EQ(find_table(outcome, kExploration), nullptr);
  EXPECT_EQ(find_table(outcome, kExplorationModel), nullptr);
}

TEST(Exploration, IsDisplayedWithARowPerCondition) {
  const AnalysisOutcome outcome = analyze_explored(kTwoParticipants);
  const Table times = shown_table(outcome, kExploration);
  EXPECT_THAT(times.columns, ElementsAre("factor", "level", "persons", "measurements", "contact_s",
                                         "strokes", "stroke_length_m", "response_s"))
      << "without what no session stored";
  ASSERT_EQ(times.rows.size(), 3U);
  EXPECT_EQ(times.rows[2][1], Cell{"wood"});
  EXPECT_EQ(times.rows[2][4], Cell{"2.50 [2.25, 2.75]"});
  const Table forces = shown_table(outcome, kExplorationForces);
  // Means 1.05 and 1.75, SD 0.7/√2.
  EXPECT_EQ(forces.rows[0][4], Cell{"1.400 (0.495)"});
  EXPECT_EQ(forces.rows[0][6], Cell{"0.0500 (0.0000)"});
  const Table models = shown_table(outcome, kExplorationModel);
  EXPECT_FALSE(column_of(models, "df1").has_value());
  EXPECT_TRUE(column_of(models, "statistic").has_value());
}

/// Twelve trials of each participant: contact times fall by 5 % with each trial, and are a half longer with metal.
std::vector<std::vector<MadeUpTrial>> planted_trials() {
  Random random(3);
  std::vector<std::vector<MadeUpTrial>> by_participant{};
  for (int participant = 0; participant < 6; ++participant) {
    const double own = 0.4 * random.normal();
    std::vector<MadeUpTrial>& trials = by_participant.emplace_back();
    for (int trial = 0; trial < 12; ++trial) {
      const bool is_metal = (trial + participant) % 2 == 0;
      const double logarithm = 1.0 + own + trial * std::log(0.95) +
                               (is_metal ? std::log(1.5) : 0.0) + 0.05 * random.normal();
      trials.push_back(
          explored_trial(is_metal ? "metal" : "wood", {std::exp(logarithm), 1.0, 0.05}));
      trials.back().from_cue_s = std::exp(0.3 * random.normal() + own);
    }
  }
  return by_participant;
}

TEST(ExplorationModel, FindsAPlantedTrendAndCondition) {
  const AnalysisOutcome outcome = analyze_explored(planted_trials());
  const ExploredCells trend(outcome, kExplorationModel, "contact_s", "trial_place");
  const double per_10 = std::pow(0.95, 10.0);
  EXPECT_NEAR(trend.number("ratio"), per_10, 0.04);
  EXPECT_LT(trend.number("ratio_low"), per_10);
  EXPECT_GT(trend.number("ratio_high"), per_10);
  EXPECT_LT(trend.number("ratio_high"), 0.7);
  EXPECT_LT(trend.number("p"), 1e-6);
  EXPECT_NEAR(trend.number("df2"), 64.0, 1.0);  // 72 − 6 participants − 2 effects
  const ExploredCells texture(outcome, kExplorationModel, "contact_s", "texture");
  EXPECT_EQ(texture.number("df1"), 1.0);
  EXPECT_LT(texture.number("p"), 1e-6);
  const ExploredCells wood(outcome, kExplorationModel, "contact_s", "texture", "wood");
  EXPECT_EQ(wood.at("reference"), Cell{"metal"});
  EXPECT_NEAR(wood.number("ratio"), 1.0 / 1.5, 0.03);
  EXPECT_EQ(wood.at("measurements"), Cell{std::int64_t{72}});
  const ExploredCells response(outcome, kExplorationModel, "response_s", "trial_place");
  EXPECT_LT(response.number("ratio_low"), 1.0);
  EXPECT_GT(response.number("ratio_high"), 1.0);
  EXPECT_THAT(table_of(outcome, kExplorationModel).note.english(),
              HasSubstr("Contact time changes by a factor of 0.597 "));
}

// Every p is in the table, so that reports do not list it among the tests that no table has.
TEST(ExplorationModel, HasItsTestsInTheTable) {
  const AnalysisOutcome outcome = analyze_explored(planted_trials());
  std::size_t tests = 0;
  for (const Finding& finding : outcome.findings) {
    if (finding.analysis != kContactTimeModel || !finding.quantity.ends_with(".p")) continue;
    ++tests;
    EXPECT_NE(finding.key, "intercept");
    EXPECT_TRUE(outcome.tests_in_tables.contains(name_of(finding))) << finding.key;
  }
  EXPECT_EQ(tests, 3U);  // of the texture by F, of its level and of the place by t
}

// The second block always has the second texture.
TEST(ExplorationModel, StatesEffectsThatCannotBeDistinguished) {
  std::vector<std::vector<MadeUpTrial>> by_participant = planted_trials();
  for (std::vector<MadeUpTrial>& trials : by_participant) {
    for (std::size_t i = 0; i < trials.size(); ++i) {
      trials[i].block_ordinal = i < 6 ? 1 : 2;
      trials[i].block = i < 6 ? "first" : "second";
    }
  }
  const AnalysisOutcome outcome = analyze_explored(by_participant);
  const ExploredCells block(outcome, kExplorationModel, "contact_s", "block_place");
  EXPECT_EQ(block.at("status"), Cell{"dependent"});
  EXPECT_EQ(block.at("ratio"), Cell{});
  EXPECT_LT(ExploredCells(outcome, kExplorationModel, "contact_s", "block").number("p"), 1e-6);
}

// Blocks of six trials: a change per ten would be an extrapolation, in the table, in the note and in the text for a paper.
TEST(ExplorationModel, StatesNoChangePerTenTrialsOfShorterBlocks) {
  std::vector<std::vector<MadeUpTrial>> by_participant = planted_trials();
  for (std::vector<MadeUpTrial>& trials : by_participant) {
    for (std::size_t i = 0; i < trials.size(); ++i) trials[i].block_ordinal = i < 6 ? 1 : 2;
  }
  const AnalysisOutcome outcome = analyze_explored(by_participant);
  for (const std::vector<Cell>& row : table_of(outcome, kExplorationModel).table.rows) {
    EXPECT_NE(row[1], Cell{"trial_place"});
  }
  for (const Finding& finding : outcome.findings) EXPECT_NE(finding.key, "trial_place");
  EXPECT_THAT(table_of(outcome, kExplorationModel).note.english(),
              testing::Not(HasSubstr("per 10 trials of a block, 95 % CI")));
}

TEST(ExplorationModel, LeavesOutSurfacesThatWereNotTouched) {
  std::vector<std::vector<MadeUpTrial>> by_participant = planted_trials();
  by_participant[2][5] = explored_trial("metal", {0.0, {}, {}});
  const AnalysisOutcome outcome = analyze_explored(by_participant);
  EXPECT_EQ(
      ExploredCells(outcome, kExplorationModel, "contact_s", "trial_place").at("measurements"),
      Cell{std::int64_t{71}});
  EXPECT_EQ(ExploredCells(outcome, kExploration, "contact_s", "all").at("measurements"),
            Cell{std::int64_t{72}});
  EXPECT_THAT(
      table_of(outcome, kExplorationModel).note.english(),
      HasSubstr("Contact time: measurements without a time above 0, which are left out: 1."));
}

TEST(ExplorationModel, HasAReasonWithOneParticipant) {
  const AnalysisOutcome outcome = analyze_explored({kTwoParticipants.front()});
  const ExploredCells contact(outcome, kExplorationModel, "contact_s", "all");
  EXPECT_EQ(contact.at("status"), Cell{"too_few_participants"});
  EXPECT_EQ(contact.at("ratio"), Cell{});
}

// Levels that a procedure chose depend on the responses; the surfaces differ in their role.
TEST(Exploration, OfADiscriminationWithAProcedureIsByRole) {
  const auto outcome_of = [](const std::string& procedure) {
    MadeUpStudy made;
    const std::int64_t protocol = made.add_protocol(
        "jnd", "discrimination",
        R"({"kind": "discrimination",
            "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5}}},
            "blocks": {"only": {)" +
            procedure +
            R"("vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
              "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
              "question": {"name": "which", "prompt": "Which is rougher?", "judgement": "performance"}}}})");
    for (const char* const label : {"a", "b", "c"}) {
      made.add_person(label, "F");
      std::vector<MadeUpTrial> trials{};
      for (int i = 0; i < 8; ++i) {
        MadeUpTrial& trial = trials.emplace_back();
        trial.factors_json =
            R"({"amplitude_m": )" + std::string(i % 2 == 0 ? "6e-5" : "7e-5") + "}";
        trial.surfaces = {surface_of("standard", "sinusoid", ""),
                          surface_of("comparison", "sinusoid", "")};
        trial.answers = {i % 3 == 0 ? "standard" : "comparison"};
        trial.right = {"comparison"};
        trial.options = {"standard", "comparison"};
        explore(trial, {2.0 + 0.1 * i, 1.0, 0.05});
        explore(trial, {3.0 + 0.2 * (i * 5 % 8) + (label[0] == 'b' ? 2.0 : 0.0), 1.0, 0.05});
      }
      made.add_session(label, protocol, trials);
    }
    return analyze_study(made.study()).front();
  };
  const AnalysisOutcome chosen = outcome_of(R"("procedure": {"method": "transformed_up_down"}, )");
  EXPECT_TRUE(has_row(chosen, kExploration, "contact_s", "surface"));
  EXPECT_FALSE(has_row(chosen, kExploration, "contact_s", "amplitude_m"));
  EXPECT_FALSE(has_row(chosen, kExploration, "response_s", "surface"));  // two in each trial
  const AnalysisOutcome constant = outcome_of("");
  EXPECT_TRUE(has_row(constant, kExploration, "contact_s", "surface"));
  EXPECT_TRUE(has_row(constant, kExploration, "contact_s", "amplitude_m"));
}

}  // namespace
}  // namespace asperity
