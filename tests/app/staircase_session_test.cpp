// Sessions whose levels a procedure chooses: resumed after an interruption anywhere, they continue with the same levels.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/trial_outcome.h"
#include "results_schema/analysis_use.h"
#include "tests/app/exported_study.h"
#include "tests/app/scripted_session.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

/// Four interleaved tracks of four trials each, and a trial of a fixed block after them.
constexpr const char* kStaircases = R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "staircases",
  "version": "1.0.0", "title": "Staircases",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "factors": {"stroking": {"levels": ["short", "long"]}},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2},
                   "long": {"minimum_contact_s": 0.15, "maximum_contact_s": 2}},
  "blocks": {
    "tracks": {
      "crossed": ["stroking"], "exploration": {"factor": "stroking"},
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
      "procedure": {"method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10, 5],
                    "stop": {"trials": 4}, "tracks": [{"start": 50}, {"start": 25}]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}},
    "after": {
      "phase": "practice", "exploration": "short", "pause_before_trial_s": 0,
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels_ratio": [2]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "flow": [{"run": "tracks"}, {"run": "after"}]})";

constexpr const char* kProcedure =
    R"("method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10, 5],
                    "stop": {"trials": 4}, "tracks": [{"start": 50}, {"start": 25}])";
constexpr int kTrials = 17;

class StaircaseSession : public ResumableSession {
 protected:
  void SetUp() override { begin(kStaircases); }
};

TEST_F(StaircaseSession, StoresEveryTrialBeforeItsFirstAttempt) {
  start(1);
  std::vector<std::size_t> stored{};
  person_.at_question = [&](int, const Trial& trial) {
    stored.push_back(study_->plan(session_.row.id).size());
    EXPECT_EQ(stored.back(), static_cast<std::size_t>(trial.ordinal));
    return correct_reply(trial);
  };
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_EQ(stored.size(), static_cast<std::size_t>(kTrials));
  EXPECT_EQ(stored_session().expected_trials, kTrials);
}

TEST_F(StaircaseSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    SCOPED_TRACE(seed);
    EXPECT_EQ(same_plan_after_interruptions(seed).size(), static_cast<std::size_t>(kTrials));
  }
}

/// The same tracks with psi.
class PsiSession : public StaircaseSession {
 protected:
  void SetUp() override {
    begin(replaced(kStaircases, kProcedure,
                   R"("method": "psi", "stop": {"trials": 4}, "tracks": [{}, {}])"));
  }
};

TEST_F(PsiSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  EXPECT_EQ(same_plan_after_interruptions(1).size(), static_cast<std::size_t>(kTrials));
}

/// The same tracks with the weighted method and the option "cannot tell", which is every third response.
class UnforcedSession : public StaircaseSession {
 protected:
  void SetUp() override {
    const std::string text = replaced(kStaircases, R"("judgement": "performance"}})",
                                      R"("judgement": "performance", "allow_cannot_tell": true}})");
    begin(replaced(text,
                   R"("method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10, 5],)",
                   R"("method": "weighted_up_down", "steps": [10, 5],)"));
  }

  Reply reply_to(const Trial& trial, std::uint64_t seed) const override {
    const bool has_option = trial.questions.front().options.size() == 3;
    return has_option && trial.ordinal % 3 == 0 ? chooses(2)
                                                : StaircaseSession::reply_to(trial, seed);
  }
};

TEST_F(UnforcedSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  EXPECT_EQ(same_plan_after_interruptions(1).size(), static_cast<std::size_t>(kTrials));
}

/// An attempt whose judged question has this answer; empty: none.
AttemptRow attempt_at(const Trial& trial, AttemptOutcome outcome, const std::string& answer) {
  AttemptRow attempt{.trial = trial.ordinal, .attempt = 1, .outcome = outcome, .valid = true};
  for (const PlannedPresentation& planned : trial.presentations) {
    attempt.presentations.push_back({.position = planned.position,
                                     .role = planned.role,
                                     .item = planned.item,
                                     .parameters_json = R"({"amplitude_m": 6e-5})"});
  }
  if (!answer.empty()) attempt.responses.push_back({.question = "rougher", .answer = answer});
  return attempt;
}

TEST_F(UnforcedSession, TakesCannotTellAsTheThirdOutcome) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  const AttemptRow attempt = attempt_at(trial, AttemptOutcome::answered, kCannotTellOption);
  EXPECT_EQ(outcome_of(protocol_, trial, attempt).answer->outcome, LevelOutcome::unsure);
}

TEST_F(StaircaseSession, IsResumedWhereTheNextTrialWasNotYetStored) {
  const std::vector<std::string> expected = uninterrupted(2);
  start(2);
  ASSERT_EQ(run_attempts(5).state, SessionState::stopped);
  ASSERT_EQ(stored_plan().size(), 6U);
  change_store("DROP TRIGGER trial_no_delete; DELETE FROM trial WHERE trial = 6 AND" +
               of_session());
  EXPECT_EQ(verified_trials(), 5U);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_EQ(stored_plan(), expected);
}

/// The outcome of the last trial of the tracks determines a whole block.
TEST_F(StaircaseSession, IsResumedWhereTheFollowingBlockWasNotYetStored) {
  protocol_ = read_small_protocol(
      models_, replaced(kStaircases, R"("levels_ratio": [2])", R"("levels_ratio": [2, 3, 4])"));
  const std::vector<std::string> expected = uninterrupted(2);
  ASSERT_EQ(expected.size(), 19U);
  start(2);
  ASSERT_EQ(run_attempts(16).state, SessionState::stopped);
  ASSERT_EQ(stored_plan(), expected);
  change_store("DROP TRIGGER trial_no_delete; DELETE FROM trial WHERE trial > 16 AND" +
               of_session());
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_EQ(stored_plan(), expected);
}

/// A procedure for each level of an iterated factor, in the group of the participant.
TEST_F(StaircaseSession, ContinuesInEveryRunOfItsBlockAndInItsGroup) {
  const std::string grouped = replaced(kStaircases, R"("factors": {)",
                                       R"("counterbalance": "latin", "groups": {"factor": "hand"},
             "factors": {"ground": {"levels": ["soft", "hard"]}, "hand": {"levels": ["bare", "gloved"]}, )");
  protocol_ = read_small_protocol(models_, replaced(grouped, R"({"run": "tracks"})",
                                                    R"({"run": "tracks", "for_each": "ground"})"));
  const std::vector<std::string> expected = uninterrupted(2);
  ASSERT_EQ(expected.size(), 33U);
  const std::optional<std::string> group = session_.row.group_level;
  ASSERT_TRUE(group);
  do {
    start(2);
  } while (session_.row.group_level != group || session_.row.counterbalance_row != 0);
  interrupt_after_every_attempt();
  EXPECT_EQ(stored_plan(), expected);
}

/// The tracks with an easy trial after every three.
std::string staircases_with_catch_trials() {
  const std::string method = R"("method": "transformed_up_down",)";
  return replaced(kStaircases, method, method + R"( "catch_trials": {"level": 100, "every": 4},)");
}

TEST_F(StaircaseSession, ContinuesWithTheSameCatchTrials) {
  protocol_ = read_small_protocol(models_, staircases_with_catch_trials());
  EXPECT_GT(same_plan_after_interruptions(2).size(), 20U);
  int caught = 0;
  for (const PlannedTrialRow& row : study_->plan(session_.row.id)) {
    if (!row.is_catch) continue;
    ++caught;
    EXPECT_FALSE(row.track);
    EXPECT_EQ(row.repetition, 0);
    EXPECT_EQ(use_in_analyses(row), AnalysisUse::catch_trial);
  }
  EXPECT_GE(caught, 5);
}

TEST_F(StaircaseSession, ContinuesWithTheSameAnchors) {
  const std::string crossed = R"("crossed": ["stroking"],)";
  protocol_ = read_small_protocol(
      models_, replaced(kStaircases, crossed,
                        crossed + R"( "anchor": {"stroking": "short", "amplitude_m": 60},
                                      "anchor_at": ["start", "middle", "end"],)"));
  EXPECT_EQ(same_plan_after_interruptions(2).size(), static_cast<std::size_t>(kTrials) + 3);
  std::vector<int> anchors{};
  for (const PlannedTrialRow& row : study_->plan(session_.row.id)) {
    if (row.repetition > 0) continue;
    anchors.push_back(row.trial);
    EXPECT_FALSE(row.track);
    EXPECT_EQ(use_in_analyses(row), AnalysisUse::anchor);
  }
  EXPECT_EQ(anchors, (std::vector<int>{1, 10, 19})) << "among 16 trials of tracks";
}

// A catch trial whose protocol states no type is an easy one.
TEST_F(StaircaseSession, ExportsTheTypeOfItsCatchTrials) {
  protocol_ = read_small_protocol(models_, staircases_with_catch_trials());
  start(2);
  run_attempts();
  const std::filesystem::path to = folder_.path() / "exported";
  export_study(*study_, models_, to, tables_only());
  const Table trials = table_in(to, "trials.tsv");
  int caught = 0;
  for (std::size_t row = 0; row < trials.rows.size(); ++row) {
    if (cell_of(trials, row, "catch_trial") != Cell{std::string("1")}) {
      EXPECT_EQ(cell_of(trials, row, "catch_type"), Cell{}) << "n/a";
      continue;
    }
    ++caught;
    EXPECT_EQ(cell_of(trials, row, "catch_type"), Cell{std::string("easy")});
  }
  EXPECT_GE(caught, 5);
}

TEST_F(StaircaseSession, TakesTheFirstAttemptThatCompletedATrial) {
  start(3);
  int question = 0;
  person_.at_question = [&](int, const Trial& trial) {
    ++question;
    if (question == 3) conductor_->requests().repeat_last("the door banged");
    return question == 4 ? incorrect_reply(trial) : correct_reply(trial);
  };
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(kTrials) + 1);
  EXPECT_EQ(rows[2].trial, 3);
  EXPECT_FALSE(rows[2].valid);
  EXPECT_EQ(rows[3].trial, 3);
  const std::vector<std::string> repeated = stored_plan();
  EXPECT_EQ(verified_trials(), static_cast<std::size_t>(kTrials))
      << "made again from the stored attempts";
  start(3);
  person_.at_question = [](int, const Trial& trial) { return correct_reply(trial); };
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_EQ(stored_plan(), repeated);
}

TEST_F(StaircaseSession, PresentsTheLevelOfASkippedTrialAgain) {
  start(1);
  person_.at_question = [this](int question, const Trial& trial) {
    if (question == 2) conductor_->requests().skip("the sample broke");
    if (question == 2) return feels_again(1);
    return correct_reply(trial);
  };
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_EQ(stored_plan().size(), static_cast<std::size_t>(kTrials) + 1);
  EXPECT_EQ(verified_trials(), static_cast<std::size_t>(kTrials) + 1);
}

TEST_F(StaircaseSession, IsFoundIncompleteWhereItsLastTrialsWereRemoved) {
  uninterrupted(1);
  for (const char* const table : {"trial", "attempt"}) {
    change_store("PRAGMA foreign_keys = OFF; DROP TRIGGER " + std::string(table) +
                 "_no_delete; DELETE FROM " + table + " WHERE trial > 10 AND" + of_session());
  }
  EXPECT_THROW(verified_plan(), std::runtime_error);
}

TEST_F(StaircaseSession, TakesAMissedDeadlineAsTheProtocolSpecifies) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  const auto outcome = [&](AttemptOutcome what, const std::string& answer) {
    return outcome_of(protocol_, trial, attempt_at(trial, what, answer)).answer;
  };
  EXPECT_FALSE(outcome(AttemptOutcome::timed_out, "")) << "the judged question";
  ASSERT_TRUE(outcome(AttemptOutcome::timed_out, "comparison")) << "a later question";
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, "comparison")->outcome, LevelOutcome::correct);
  EXPECT_FALSE(outcome(AttemptOutcome::skipped, "comparison"));
  EXPECT_EQ(outcome(AttemptOutcome::answered, "standard")->value, 6e-5) << "as delivered";
  const AttemptRow answered = attempt_at(trial, AttemptOutcome::answered, "standard");
  EXPECT_EQ(level_answer_of(protocol_, trial, answered)->level,
            protocol_.blocks.at("tracks").vary->level_of(6e-5));
  protocol_.blocks.at("tracks").procedure->timeouts_are_incorrect = true;
  ASSERT_TRUE(outcome(AttemptOutcome::timed_out, ""));
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, "")->outcome, LevelOutcome::incorrect);
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, "comparison")->outcome, LevelOutcome::correct);
}

/// "Which is smoother?": the choice of the standard states that the comparison is rougher.
TEST_F(StaircaseSession, GoesDownAfterTheStandardWhereTheQuestionAsksForLess) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  protocol_.blocks.at("tracks").questions.at(0).own = DiscriminationQuestion{
      DiscriminationJudgement::comparison, DiscriminationQuestion::AsksFor::less};
  const auto counts_down = [&](const std::string& chosen) {
    return outcome_of(protocol_, trial, attempt_at(trial, AttemptOutcome::answered, chosen))
               .answer->outcome == LevelOutcome::correct;
  };
  EXPECT_FALSE(counts_down("comparison"));
  EXPECT_TRUE(counts_down("standard"));
}

TEST_F(StaircaseSession, IsFoundChangedWhereALevelWasChanged) {
  uninterrupted(1);
  change_store(
      "DROP TRIGGER trial_no_update; UPDATE trial SET factors_json = "
      "json_set(factors_json, '$.amplitude_m', 6.1e-5) WHERE trial = 7 AND" +
      of_session());
  EXPECT_THAT(refusal_of<std::runtime_error>([this] { verified_plan(); }), HasSubstr("trial 7"));
}

}  // namespace
}  // namespace asperity
