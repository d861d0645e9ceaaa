// Sessions whose levels a procedure chooses: resumed after an interruption anywhere, they continue with the same levels.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/trial_outcome.h"
#include "results_schema/analysis_use.h"
#include "results_schema/sqlite.h"
#include "tests/app/exported_study.h"
#include "tests/app/scripted_session.h"

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

constexpr int kTrials = 17;

class StaircaseSession : public SessionTest {
 protected:
  void SetUp() override {
    begin(kStaircases);
    links_ = {};
  }

  /// A new session. Its participant answers four of five trials correctly; a trial has the same answer in every session
  /// of this seed.
  void start(std::uint64_t seed) {
    SessionTest::start("p" + std::to_string(++participants_), seed);
    person_.at_question = [seed](int, const Trial& trial) {
      Random random =
          Random(seed).split("answers").split(static_cast<std::uint64_t>(trial.ordinal));
      return reply_that_is(trial, random.uniform() < 0.8);
    };
  }

  /// Runs the session, and stops it after this number of trials in this run.
  SessionEnd run_trials(int trials) {
    int made = 0;
    conductor_ = std::make_unique<Conductor>(
        *study_, protocol_, *builder_, *rig_, person_,
        ConductorSettings{.record = true,
                          .done =
                              [this, &made, trials](const AttemptDone&) {
                                if (++made == trials)
                                  conductor_->requests().stop_after(StopAfter::trial);
                              },
                          .links = links_});
    return conductor_->run(session_);
  }

  SessionEnd resume(int trials) {
    make_rig({});
    session_ = reopen(*study_, protocol_, study_->session(session_.row.id));
    return run_trials(trials);
  }

  std::vector<std::string> uninterrupted(std::uint64_t seed) {
    start(seed);
    EXPECT_EQ(run_trials(1000).state, SessionState::completed);
    return stored_plan();
  }

  int participants_ = 1;
};

TEST_F(StaircaseSession, StoresEveryTrialBeforeItsFirstAttempt) {
  start(1);
  std::vector<std::size_t> stored{};
  person_.at_question = [&](int, const Trial& trial) {
    stored.push_back(study_->plan(session_.row.id).size());
    EXPECT_EQ(stored.back(), static_cast<std::size_t>(trial.ordinal));
    return correct_reply(trial);
  };
  EXPECT_EQ(run_trials(1000).state, SessionState::completed);
  EXPECT_EQ(stored.size(), static_cast<std::size_t>(kTrials));
  EXPECT_EQ(study_->session(session_.row.id).expected_trials, kTrials);
}

TEST_F(StaircaseSession, GoesOnWithTheSameLevelsAfterAnInterruptionAnywhere) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const std::vector<std::string> expected = uninterrupted(seed);
    ASSERT_EQ(expected.size(), static_cast<std::size_t>(kTrials));
    for (int position = 1; position < kTrials; ++position) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", after " + std::to_string(position));
      start(seed);
      EXPECT_EQ(run_trials(position).state, SessionState::stopped);
      EXPECT_EQ(resume(1000).state, SessionState::completed);
      EXPECT_EQ(stored_plan(), expected);
    }
  }
}

TEST_F(StaircaseSession, GoesOnWithTheSameLevelsWhenInterruptedAfterEachTrial) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const std::vector<std::string> expected = uninterrupted(seed);
    start(seed);
    SessionEnd end = run_trials(1);
    for (int i = 0; i < kTrials && end.state != SessionState::completed; ++i) end = resume(1);
    EXPECT_EQ(end.state, SessionState::completed);
    EXPECT_EQ(stored_plan(), expected);
  }
}

/// The same tracks with psi.
class PsiSession : public StaircaseSession {
 protected:
  void SetUp() override {
    std::string text = kStaircases;
    const std::size_t first = text.find(R"({"method": "transformed_up_down")");
    const std::string end = R"({"start": 25}]})";
    text.replace(first, text.find(end) + end.size() - first,
                 R"({"method": "psi", "stop": {"trials": 4}, "tracks": [{}, {}]})");
    begin(text);
    links_ = {};
  }
};

TEST_F(PsiSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  const std::vector<std::string> expected = uninterrupted(1);
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(kTrials));
  for (int position = 1; position < kTrials; ++position) {
    SCOPED_TRACE("after " + std::to_string(position));
    start(1);
    EXPECT_EQ(run_trials(position).state, SessionState::stopped);
    EXPECT_EQ(resume(1000).state, SessionState::completed);
    EXPECT_EQ(stored_plan(), expected);
  }
}

/// The same tracks with the weighted method and the option "cannot tell", which is every third response.
class UnforcedSession : public StaircaseSession {
 protected:
  void SetUp() override {
    std::string text = kStaircases;
    const auto replace = [&text](const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    replace(R"("method": "transformed_up_down", "down": 2, "up": 1, "steps": [20, 10, 5],)",
            R"("method": "weighted_up_down", "steps": [10, 5],)");
    replace(R"("judgement": "performance"}})",
            R"("judgement": "performance", "allow_cannot_tell": true}})");
    begin(text);
    links_ = {};
  }

  void start(std::uint64_t seed) {
    StaircaseSession::start(seed);
    const auto choose = person_.at_question;
    person_.at_question = [choose](int question, const Trial& trial) {
      const bool has_option = trial.questions.front().options.size() == 3;
      return has_option && trial.ordinal % 3 == 0 ? chooses(2) : choose(question, trial);
    };
  }
};

TEST_F(UnforcedSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  start(1);
  ASSERT_EQ(run_trials(1000).state, SessionState::completed);
  const std::vector<std::string> expected = stored_plan();
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(kTrials));
  for (int position = 1; position < kTrials; ++position) {
    SCOPED_TRACE("after " + std::to_string(position));
    start(1);
    EXPECT_EQ(run_trials(position).state, SessionState::stopped);
    EXPECT_EQ(resume(1000).state, SessionState::completed);
    EXPECT_EQ(stored_plan(), expected);
  }
  // As verification makes it again from the stored responses.
  EXPECT_EQ(plan_of(*study_, study_->session(session_.row.id), models_).trials.size(),
            expected.size());
}

TEST_F(UnforcedSession, TakesCannotTellAsTheThirdOutcome) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  AttemptRow attempt{
      .trial = trial.ordinal, .attempt = 1, .outcome = AttemptOutcome::answered, .valid = true};
  for (const PlannedPresentation& planned : trial.presentations) {
    attempt.presentations.push_back({.position = planned.position,
                                     .role = planned.role,
                                     .item = planned.item,
                                     .parameters_json = R"({"amplitude_m": 6e-5})"});
  }
  attempt.responses.push_back({.question = "rougher", .answer = kCannotTellOption});
  EXPECT_EQ(outcome_of(protocol_, trial, attempt).answer->outcome, LevelOutcome::unsure);
}

TEST_F(StaircaseSession, IsResumedWhereTheNextTrialWasNotYetStored) {
  const std::vector<std::string> expected = uninterrupted(2);
  start(2);
  ASSERT_EQ(run_trials(5).state, SessionState::stopped);
  ASSERT_EQ(stored_plan().size(), 6U);
  {
    const std::filesystem::path folder = folder_.path() / "study";
    Database database(folder, folder / "study.sqlite", Database::Mode::read_write);
    database.execute(
        "DROP TRIGGER trial_no_delete; DELETE FROM trial WHERE trial = 6 AND session_id = " +
        std::to_string(session_.row.id));
  }
  EXPECT_EQ(plan_of(*study_, study_->session(session_.row.id), models_).trials.size(), 5U);
  EXPECT_EQ(resume(1000).state, SessionState::completed);
  EXPECT_EQ(stored_plan(), expected);
}

/// The outcome of the last trial of the tracks determines a whole block.
TEST_F(StaircaseSession, IsResumedWhereTheFollowingBlockWasNotYetStored) {
  std::string text = kStaircases;
  const std::string one = R"("levels_ratio": [2])";
  text.replace(text.find(one), one.size(), R"("levels_ratio": [2, 3, 4])");
  protocol_ = read_small_protocol(models_, text);
  const std::vector<std::string> expected = uninterrupted(2);
  ASSERT_EQ(expected.size(), 19U);
  start(2);
  ASSERT_EQ(run_trials(16).state, SessionState::stopped);
  ASSERT_EQ(stored_plan(), expected);
  {
    const std::filesystem::path folder = folder_.path() / "study";
    Database database(folder, folder / "study.sqlite", Database::Mode::read_write);
    database.execute(
        "DROP TRIGGER trial_no_delete; DELETE FROM trial WHERE trial > 16 AND session_id = " +
        std::to_string(session_.row.id));
  }
  EXPECT_EQ(resume(1000).state, SessionState::completed);
  EXPECT_EQ(stored_plan(), expected);
}

/// A procedure for each level of an iterated factor, in the group of the participant.
TEST_F(StaircaseSession, ContinuesInEveryRunOfItsBlockAndInItsGroup) {
  std::string text = kStaircases;
  const auto replace = [&text](const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  };
  replace(R"("factors": {)",
          R"("counterbalance": "latin", "groups": {"factor": "hand"},
             "factors": {"ground": {"levels": ["soft", "hard"]}, "hand": {"levels": ["bare", "gloved"]}, )");
  replace(R"({"run": "tracks"})", R"({"run": "tracks", "for_each": "ground"})");
  protocol_ = read_small_protocol(models_, text);
  const std::vector<std::string> expected = uninterrupted(2);
  ASSERT_EQ(expected.size(), 33U);
  const std::optional<std::string> group = session_.row.group_level;
  ASSERT_TRUE(group);
  for (const int position : {15, 16, 17, 31, 32}) {
    SCOPED_TRACE(position);
    do {
      start(2);
    } while (session_.row.group_level != group || session_.row.counterbalance_row != 0);
    EXPECT_EQ(run_trials(position).state, SessionState::stopped);
    EXPECT_EQ(resume(1000).state, SessionState::completed);
    EXPECT_EQ(stored_plan(), expected);
  }
}

TEST_F(StaircaseSession, ContinuesWithTheSameCatchTrials) {
  std::string text = kStaircases;
  const std::string method = R"("method": "transformed_up_down",)";
  text.replace(text.find(method), method.size(),
               method + R"( "catch_trials": {"level": 100, "every": 4},)");
  protocol_ = read_small_protocol(models_, text);
  const std::vector<std::string> expected = uninterrupted(2);
  ASSERT_GT(expected.size(), 20U);
  for (int position = 1; position < 8; ++position) {
    SCOPED_TRACE(position);
    start(2);
    EXPECT_EQ(run_trials(position).state, SessionState::stopped);
    EXPECT_EQ(resume(1000).state, SessionState::completed);
    EXPECT_EQ(stored_plan(), expected);
  }
  int caught = 0;
  for (const PlannedTrialRow& row : study_->plan(session_.row.id)) {
    if (!row.is_catch) continue;
    ++caught;
    EXPECT_FALSE(row.track);
    EXPECT_EQ(row.repetition, 0);
    EXPECT_EQ(use_in_analyses(row), AnalysisUse::catch_trial);
  }
  EXPECT_GE(caught, 5);
  EXPECT_EQ(plan_of(*study_, study_->session(session_.row.id), models_).trials.size(),
            expected.size());
}

// A catch trial whose protocol states no type is an easy one.
TEST_F(StaircaseSession, ExportsTheTypeOfItsCatchTrials) {
  std::string text = kStaircases;
  const std::string method = R"("method": "transformed_up_down",)";
  text.replace(text.find(method), method.size(),
               method + R"( "catch_trials": {"level": 100, "every": 4},)");
  protocol_ = read_small_protocol(models_, text);
  start(2);
  run_trials(1000);
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
  EXPECT_EQ(run_trials(1000).state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(kTrials) + 1);
  EXPECT_EQ(rows[2].trial, 3);
  EXPECT_FALSE(rows[2].valid);
  EXPECT_EQ(rows[3].trial, 3);
  const std::vector<std::string> repeated = stored_plan();
  EXPECT_EQ(plan_of(*study_, study_->session(session_.row.id), models_).trials.size(),
            static_cast<std::size_t>(kTrials))
      << "made again from the stored attempts";
  start(3);
  person_.at_question = [](int, const Trial& trial) { return correct_reply(trial); };
  EXPECT_EQ(run_trials(1000).state, SessionState::completed);
  EXPECT_EQ(stored_plan(), repeated);
}

TEST_F(StaircaseSession, PresentsTheLevelOfASkippedTrialAgain) {
  start(1);
  person_.at_question = [this](int question, const Trial& trial) {
    if (question == 2) conductor_->requests().skip("the sample broke");
    if (question == 2) return feels_again(1);
    return correct_reply(trial);
  };
  EXPECT_EQ(run_trials(1000).state, SessionState::completed);
  EXPECT_EQ(stored_plan().size(), static_cast<std::size_t>(kTrials) + 1);
  EXPECT_EQ(plan_of(*study_, study_->session(session_.row.id), models_).trials.size(),
            static_cast<std::size_t>(kTrials) + 1);
}

TEST_F(StaircaseSession, IsFoundIncompleteWhereItsLastTrialsWereRemoved) {
  uninterrupted(1);
  const SessionRow row = study_->session(session_.row.id);
  {
    const std::filesystem::path folder = folder_.path() / "study";
    Database database(folder, folder / "study.sqlite", Database::Mode::read_write);
    database.execute(
        "PRAGMA foreign_keys = OFF; DROP TRIGGER trial_no_delete; DROP TRIGGER attempt_no_delete; "
        "DELETE FROM trial WHERE trial > 10 AND session_id = " +
        std::to_string(row.id));
    database.execute("DELETE FROM attempt WHERE trial > 10 AND session_id = " +
                     std::to_string(row.id));
  }
  EXPECT_THROW(plan_of(*study_, row, models_), std::runtime_error);
}

/// An attempt with a judged question and a rating of confidence after it.
AttemptRow attempt_at(const Trial& trial, AttemptOutcome outcome, bool is_correct) {
  AttemptRow attempt{.trial = trial.ordinal, .attempt = 1, .outcome = outcome, .valid = true};
  for (const PlannedPresentation& planned : trial.presentations) {
    attempt.presentations.push_back({.position = planned.position,
                                     .role = planned.role,
                                     .item = planned.item,
                                     .parameters_json = R"({"amplitude_m": 6e-5})"});
  }
  if (outcome == AttemptOutcome::answered || is_correct) {
    attempt.responses.push_back(
        {.question = "rougher", .answer = is_correct ? "comparison" : "standard"});
  }
  return attempt;
}

TEST_F(StaircaseSession, TakesAMissedDeadlineAsTheProtocolSpecifies) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  const auto outcome = [&](AttemptOutcome what, bool is_correct) {
    return outcome_of(protocol_, trial, attempt_at(trial, what, is_correct)).answer;
  };
  EXPECT_FALSE(outcome(AttemptOutcome::timed_out, false)) << "the judged question";
  ASSERT_TRUE(outcome(AttemptOutcome::timed_out, true)) << "a later question";
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, true)->outcome, LevelOutcome::correct);
  EXPECT_FALSE(outcome(AttemptOutcome::skipped, true));
  EXPECT_EQ(outcome(AttemptOutcome::answered, false)->value, 6e-5) << "as delivered";
  const AttemptRow answered = attempt_at(trial, AttemptOutcome::answered, false);
  EXPECT_EQ(level_answer_of(protocol_, trial, answered)->level,
            protocol_.blocks.at("tracks").vary->level_of(6e-5));
  protocol_.blocks.at("tracks").procedure->timeouts_are_incorrect = true;
  ASSERT_TRUE(outcome(AttemptOutcome::timed_out, false));
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, false)->outcome, LevelOutcome::incorrect);
  EXPECT_EQ(outcome(AttemptOutcome::timed_out, true)->outcome, LevelOutcome::correct);
}

/// "Which is smoother?": the choice of the standard states that the comparison is rougher.
TEST_F(StaircaseSession, GoesDownAfterTheStandardWhereTheQuestionAsksForLess) {
  start(1);
  const Trial& trial = session_.course->plan().trials.front();
  protocol_.blocks.at("tracks").questions.at(0).asks_for_less = true;
  const auto counts_down = [&](bool chose_comparison) {
    return outcome_of(protocol_, trial,
                      attempt_at(trial, AttemptOutcome::answered, chose_comparison))
               .answer->outcome == LevelOutcome::correct;
  };
  EXPECT_FALSE(counts_down(true));
  EXPECT_TRUE(counts_down(false));
}

TEST_F(StaircaseSession, IsFoundChangedWhereALevelWasChanged) {
  uninterrupted(1);
  const SessionRow row = study_->session(session_.row.id);
  EXPECT_EQ(plan_of(*study_, row, models_).trials.size(), static_cast<std::size_t>(kTrials));
  {
    const std::filesystem::path folder = folder_.path() / "study";
    Database database(folder, folder / "study.sqlite", Database::Mode::read_write);
    database.execute(
        "DROP TRIGGER trial_no_update; UPDATE trial SET factors_json = "
        "json_set(factors_json, '$.amplitude_m', 6.1e-5) WHERE trial = 7 AND session_id = " +
        std::to_string(row.id));
  }
  try {
    plan_of(*study_, row, models_);
    FAIL() << "a changed level was not found";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("trial 7"));
  }
}

}  // namespace
}  // namespace asperity
