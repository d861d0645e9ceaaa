// Sessions at amplitudes of equal roughness: what they present and store, resumed after an interruption anywhere.

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/shared/equal_roughness.h"
#include "app/findings/study/analyze_study.h"
#include "app/records/presented_matches.h"
#include "app/report/text/report_roughness.h"
#include "app/study_files/parameter_json.h"
#include "protocols/file/stored_protocol.h"
#include "tests/app/exported_study.h"
#include "tests/app/scripted_session.h"
#include "tests/app/stored_tables.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

/// Two models are matched to a third one in two tracks of four trials each; then every pair, in both orders.
constexpr const char* kMatchedModels = R"({
  "format": "asperity.protocol/1", "kind": "paired_comparison", "design": "improved", "name": "matched",
  "version": "1.0.0", "title": "Matched models",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "factors": {"model": {"levels": ["sinusoid", "solid_noise", "stochastic"]}},
  "stimuli": {"reference": {"model": "sinusoid"}, "rendered": {"model": {"factor": "model"}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
  "blocks": {
    "matching": {
      "kind": "discrimination", "crossed": ["model"], "exclude": [{"model": "sinusoid"}],
      "vary": {"parameter": "relative_amplitude", "of": "comparison", "relative_to": "standard",
               "levels_decibels": {"lowest": -8, "highest": 8, "step": 2}},
      "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [4, 2],
                    "stop": {"trials": 4}, "tracks": [{"start": 2}, {"start": -2}]},
      "presented": [{"role": "standard", "stimulus": "reference"}, {"role": "comparison", "stimulus": "rendered"}],
      "positions": "balanced", "exploration": "short", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "comparison"}},
    "comparisons": {
      "all_pairs": {"factor": "model", "in_both_orders": true}, "presented": [{"stimulus": "rendered"}],
      "exploration": "short", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "closer", "prompt": "Which is better?"},
      "equal_roughness": {"matched_in": "matching"}}},
  "flow": [{"run": "matching"}, {"run": "comparisons"}]})";

constexpr int kTrialsOfMatching = 16;
constexpr int kTrialsOfSession = 22;

class EqualRoughnessSession : public ResumableSession {
 protected:
  void SetUp() override {
    begin(kMatchedModels);
    links_.tell = [this](const std::string& text) { told_.push_back(text); };
  }

  /// Both models are as rough as the reference at 1 dB.
  Reply reply_to(const Trial& trial, std::uint64_t) const override {
    if (trial.block != "matching") return chooses(0);
    const double amplitude = std::get<double>(trial.factors.at("relative_amplitude"));
    const bool is_rougher = 20.0 * std::log10(amplitude) > 1.0;
    const std::string role = is_rougher ? "comparison" : "standard";
    return chooses(trial.presentations.front().role == role ? 0 : 1);
  }

  std::vector<nlohmann::json> match_events() const {
    std::vector<nlohmann::json> events{};
    for (const EventRow& event : study_->events(session_.row.id)) {
      if (event.kind == "roughness_match") events.push_back(nlohmann::json::parse(event.data_json));
    }
    return events;
  }

  std::vector<std::string> told_{};
};

TEST_F(EqualRoughnessSession, RendersTheAmplitudesThatTheResponsesDetermined) {
  uninterrupted(1);
  const std::vector<PresentedMatch> matches =
      presented_matches(stored_protocol(kMatchedModels).protocol, study_->plan(session_.row.id));
  ASSERT_EQ(matches.size(), 2U);
  std::map<std::string, double> relative{{"sinusoid", 1.0}};
  for (const PresentedMatch& match : matches) {
    EXPECT_EQ(match.status, MatchStatus::matched);
    EXPECT_NEAR(20.0 * std::log10(match.relative_amplitude), 1.0, 1.0) << match.model;
    relative[match.model] = match.relative_amplitude;
  }
  int compared = 0;
  for (const AttemptRow& attempt : attempts()) {
    for (const PresentationRow& surface : attempt.presentations) {
      const ModelDeclaration& model = models_.find(surface.model)->declaration;
      const std::string& name = *model.amplitude_parameter;
      const double own =
          number_of(complete_values(models_.find(surface.model)->declaration, {}), name);
      const double rendered = number_of(parameter_values_in(surface.parameters_json), name);
      if (attempt.trial <= kTrialsOfMatching) {
        if (surface.role == "standard") {
          EXPECT_EQ(rendered, own);
        }
        continue;
      }
      ++compared;
      EXPECT_NEAR(rendered / own, relative.at(surface.model), 1e-12) << surface.model;
    }
  }
  EXPECT_EQ(compared, 12);
}

TEST_F(EqualRoughnessSession, StoresAndReportsEachMatchOnce) {
  uninterrupted(1);
  const std::vector<nlohmann::json> events = match_events();
  ASSERT_EQ(events.size(), 2U);
  for (const nlohmann::json& event : events) {
    EXPECT_EQ(event.at("block"), "matching");
    EXPECT_EQ(event.at("status"), "matched");
    EXPECT_EQ(event.at("answers"), 8);
    EXPECT_GE(event.at("reversals"), 4);
  }
  EXPECT_THAT(told_, testing::IsEmpty()) << "lines that a participant at a terminal reads";
}

TEST_F(EqualRoughnessSession, ContinuesAtTheSameAmplitudesAfterAnInterruptionAnywhere) {
  EXPECT_EQ(same_plan_after_interruptions(3).size(), static_cast<std::size_t>(kTrialsOfSession));
  for (const SessionRow& row : study_->sessions()) {
    session_.row = row;
    if (row.state == SessionState::completed) {
      EXPECT_EQ(match_events().size(), 2U) << row.id;
    }
  }
}

TEST_F(EqualRoughnessSession, IsResumedWhereTheMatchesWereNotYetStored) {
  const std::vector<std::string> expected = uninterrupted(3);
  start(3);
  ASSERT_EQ(run_attempts(kTrialsOfMatching).state, SessionState::stopped);
  change_store(
      "DROP TRIGGER trial_no_delete; DROP TRIGGER event_no_delete; DELETE FROM trial WHERE trial > "
      "16 AND" +
      of_session() + "; DELETE FROM event WHERE kind = 'roughness_match' AND" + of_session());
  ASSERT_TRUE(match_events().empty());
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_EQ(stored_plan(), expected);
  EXPECT_EQ(match_events().size(), 2U);
}

TEST_F(EqualRoughnessSession, StoresTheMatchesThatAnInterruptionLeftOut) {
  start(3);
  ASSERT_EQ(run_attempts(kTrialsOfMatching).state, SessionState::stopped);
  const std::vector<nlohmann::json> stored = match_events();
  ASSERT_EQ(stored.size(), 2U);
  change_store(
      "DROP TRIGGER event_no_delete; DELETE FROM event WHERE id = (SELECT max(id) FROM event WHERE "
      "kind = 'roughness_match' AND" +
      of_session() + ")");
  ASSERT_EQ(match_events().size(), 1U);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_THAT(match_events(), testing::UnorderedElementsAreArray(stored));
}

TEST_F(EqualRoughnessSession, IsFoundChangedWhereAnAmplitudeWasChanged) {
  uninterrupted(1);
  change_store(
      "DROP TRIGGER trial_no_update; UPDATE trial SET plan_json = json_set(plan_json, "
      "'$.presentations[0].relative_amplitude', 1.9) WHERE trial = 20 AND" +
      of_session());
  EXPECT_THAT(refusal_of<std::runtime_error>([this] { verified_plan(); }), HasSubstr("trial 20"));
}

TEST_F(EqualRoughnessSession, IsExportedWithEverySurface) {
  uninterrupted(1);
  export_study(*study_, models_, folder_.path() / "out", tables_only());
  const Table surfaces = table_in(folder_.path() / "out", "presentations.tsv");
  std::map<Cell, int> statuses{};
  int varied = 0;
  for (std::size_t row = 0; row < surfaces.rows.size(); ++row) {
    ++statuses[cell_of(surfaces, row, "roughness_match")];
    const Cell role = cell_of(surfaces, row, "role");
    EXPECT_EQ(cell_of(surfaces, row, "relative_amplitude") == Cell{}, role == Cell{"standard"});
    varied += role == Cell{"comparison"} ? 1 : 0;
  }
  EXPECT_EQ(varied, kTrialsOfMatching);
  EXPECT_EQ(statuses[Cell{}], 2 * kTrialsOfMatching) << "n/a";
  EXPECT_EQ(statuses[Cell{"reference"}], 4);
  EXPECT_EQ(statuses[Cell{"matched"}], 8);
}

TEST_F(EqualRoughnessSession, HasATableOfItsMatchesInTheAnalysis) {
  uninterrupted(1);
  const std::vector<AnalysisOutcome> outcomes = analyze_study(*study_, {}, {});
  int tables = 0;
  for (const AnalysisOutcome& outcome : outcomes) {
    EXPECT_NE(outcome.kind, "discrimination") << "the matches have their own table";
    for (const ResultTable& each : outcome.tables) {
      const StoredTable table = stored(each);
      if (table.name != kEqualRoughness) continue;
      ++tables;
      EXPECT_EQ(outcome.kind, "paired_comparison");
      ASSERT_EQ(table.table.rows.size(), 2U);
      EXPECT_EQ(table.table.rows[0].back(), Cell{std::string("matched")});
    }
  }
  EXPECT_EQ(tables, 1);
}

/// The matches that the analysis lists, and those that the report counts.
std::pair<std::size_t, std::size_t> reported_matches(const Study& study) {
  std::pair<std::size_t, std::size_t> matches{};
  for (const AnalysisOutcome& outcome : analyze_study(study, {}, {})) {
    for (const ResultTable& each : outcome.tables) {
      const StoredTable table = stored(each);
      if (table.name == kEqualRoughness) matches.first += table.table.rows.size();
    }
  }
  for (const ReportFacts& facts : report_facts(study, {}, {}, {})) {
    for (const auto& [status, count] : facts.roughness_matches) matches.second += count;
  }
  return matches;
}

TEST_F(EqualRoughnessSession, IsReportedOnlyWhereAnAttemptCounts) {
  uninterrupted(1);
  const std::int64_t first = session_.row.id;
  uninterrupted(2);
  start(3);
  ASSERT_EQ(run_attempts(kTrialsOfMatching).state, SessionState::stopped);
  ASSERT_EQ(study_->plan(session_.row.id).size(), static_cast<std::size_t>(kTrialsOfSession));
  EXPECT_EQ(reported_matches(*study_), std::pair(std::size_t{4}, std::size_t{4}))
      << "the third participant did not compare";
  study_->add_decision(first, {.verdict = Verdict::exclude, .reason = "was asleep"});
  EXPECT_EQ(reported_matches(*study_), std::pair(std::size_t{2}, std::size_t{2}));
}

PlannedTrialRow presenting(const std::string& block, const std::string& stimulus) {
  const nlohmann::json surface{{"stimulus", stimulus},
                               {"model", "recorded"},
                               {"texture", "stone"},
                               {"relative_amplitude", 1.0},
                               {"roughness_match", "unmatched"}};
  return {.block = block,
          .plan_json = nlohmann::json{{"presentations", nlohmann::json::array({surface})}}.dump()};
}

TEST(PresentedMatches, AreThoseOfAStimulusInAMatchingBlock) {
  Protocol protocol{};
  protocol.blocks["light"].equal_roughness = {"matching_light"};
  protocol.blocks["again"].equal_roughness = {"matching_light"};
  protocol.blocks["heavy"].equal_roughness = {"matching_heavy"};
  protocol.blocks["other"];
  const std::vector<PlannedTrialRow> trials{
      presenting("light", "smooth"), presenting("light", "coarse"), presenting("light", "smooth"),
      presenting("again", "smooth"), presenting("heavy", "smooth"), presenting("other", "smooth")};
  const std::vector<PresentedMatch> matches = presented_matches(protocol, trials);
  EXPECT_EQ(matches.size(), 4U);
  const std::vector<PresentedMatch> distinct = without_blocks(matches);
  ASSERT_EQ(distinct.size(), 3U);
  EXPECT_EQ(distinct[0].stimulus, "smooth");
  EXPECT_EQ(distinct[0].matched_in, "matching_light");
  EXPECT_EQ(distinct[1].stimulus, "coarse");
  EXPECT_EQ(distinct[2].matched_in, "matching_heavy");
}

/// The stimuli in the table of means, in its order.
std::vector<Cell> labels_of(const std::vector<PresentedMatch>& matches) {
  GatheredAnswers gathered{};
  for (const PresentedMatch& match : matches) {
    gathered.matches.push_back({.participant = "p1", .session = 1, .match = match});
  }
  AnalysisOutcome outcome{};
  add_equal_roughness(gathered, outcome);
  std::vector<Cell> labels{};
  for (const ResultTable& each : outcome.tables) {
    const StoredTable table = stored(each);
    if (table.name != kMeanAmplitudes) continue;
    for (const auto& row : table.table.rows) labels.push_back(row.front());
  }
  return labels;
}

TEST(PresentedMatches, HaveTheShortestLabelsThatDistinguishThem) {
  const auto match = [](const std::string& matched_in, const std::string& stimulus,
                        const std::string& model, const std::string& texture) {
    return PresentedMatch{
        .matched_in = matched_in, .stimulus = stimulus, .model = model, .texture = texture};
  };
  const auto texts = [](const std::vector<std::string>& labels) {
    return std::vector<Cell>(labels.begin(), labels.end());
  };
  EXPECT_EQ(labels_of({match("m", "a_stone_recorded", "recorded", "stone"),
                       match("n", "b_stone_normal_map", "normal_map", "stone")}),
            texts({"recorded", "normal_map"}));
  EXPECT_EQ(labels_of({match("m", "a_stone_recorded", "recorded", "stone"),
                       match("m", "a_wood_recorded", "recorded", "wood")}),
            texts({"recorded, stone", "recorded, wood"}));
  EXPECT_EQ(labels_of({match("m", "a_stone_recorded", "recorded", "stone"),
                       match("m", "b_stone_recorded", "recorded", "stone")}),
            texts({"a_stone_recorded", "b_stone_recorded"}));
  EXPECT_EQ(labels_of({match("m", "a_stone_recorded", "recorded", "stone"),
                       match("n", "a_stone_recorded", "recorded", "stone")}),
            texts({"recorded (m)", "recorded (n)"}));
}

TEST(EqualRoughnessText, StatesTheMatchesThatDidNotSucceed) {
  ReportFacts facts{};
  EXPECT_EQ(equal_roughness_text(facts), "");
  facts.roughness_matches = {{MatchStatus::matched, 8}};
  EXPECT_THAT(equal_roughness_text(facts), HasSubstr("All 8 matches succeeded."));
  facts.roughness_matches = {
      {MatchStatus::matched, 6}, {MatchStatus::below_range, 1}, {MatchStatus::unmatched, 2}};
  EXPECT_THAT(
      equal_roughness_text(facts),
      HasSubstr("Of 9 matches, 3 did not succeed: 1 below_range (rougher than the reference"));
}

}  // namespace
}  // namespace asperity
