// What an experimenter requests of a session: pauses, remarks, the end, trials again.

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/study_overview.h"
#include "app/tasks/unfinished_session.h"
#include "tests/app/watched_session.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(WatchedSession, PausesBetweenTrialsUntilItIsResumed) {
  play_sound();
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.pause();
    return chooses(0);
  };
  once_in(SessionPhase::paused, [&] {
    EXPECT_EQ(attempts().size(), 1U);
    EXPECT_TRUE(requests_.pending().pause);
    EXPECT_EQ(monitor_.snapshot().scene->kind, ParticipantScene::Kind::paused);
    requests_.note("the door was open");
    requests_.resume();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 3U);
  EXPECT_EQ(events_of("paused").size(), 1U);
  EXPECT_EQ(events_of("resumed").size(), 1U);
  EXPECT_THAT(phases(), testing::IsSupersetOf({"paused"}));
  EXPECT_THAT(sound_.cues(), Contains("paused"));
  ASSERT_EQ(events_of("note").size(), 1U);
  EXPECT_EQ(events_of("note")[0].text, "the door was open");
}

TEST_F(WatchedSession, PausesBeforeAQuestionToo) {
  begin(one_trial());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.pause();
    return chooses(0);
  };
  once_in(SessionPhase::paused, [&] {
    EXPECT_TRUE(study_->session_answers(session_.row.id).empty());
    requests_.resume();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(study_->session_answers(session_.row.id).size(), 2U);  // one left empty
}

TEST_F(WatchedSession, StopsFromAPause) {
  begin(small_protocol());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.pause();
    return chooses(0);
  };
  once_in(SessionPhase::paused, [&] { requests_.stop_after(StopAfter::trial); });
  EXPECT_EQ(run().state, SessionState::stopped);
  EXPECT_EQ(attempts().size(), 1U);
  ASSERT_TRUE(monitor_.snapshot().trouble);
  EXPECT_EQ(monitor_.snapshot().trouble->remedy, SessionTrouble::Remedy::try_again);
}

TEST_F(WatchedSession, StoresRemarksWithTheTimeAtWhichTheyWereMade) {
  begin(one_trial());
  std::int64_t made_ns = 0;
  requests_.remark("consent_seen", "before there was a clock");
  person_.at_question = [&](int, const Trial&) -> Reply {
    made_ns = rig_->clock().now_ns();
    requests_.remark("unblinded", "the participant asked");
    return chooses(0);
  };
  run();
  ASSERT_EQ(events_of("unblinded").size(), 1U);
  EXPECT_EQ(events_of("unblinded")[0].time_ns, made_ns);
  ASSERT_EQ(events_of("consent_seen").size(), 1U);
}

TEST_F(WatchedSession, EndsAReadingPromptlyWhenAskedToStop) {
  begin(small_protocol());
  once_in(SessionPhase::ready, [&] { requests_.stop_after(StopAfter::trial); });
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "on request");
  EXPECT_LT(end.duration_s, 0.05);  // the welcome takes 0.1 s
}

TEST_F(WatchedSession, AsksTheLastTrialAgainWhenWanted) {
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 2) {
      requests_.repeat_last("somebody came in");
      EXPECT_TRUE(requests_.pending().repeat_last);
    }
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::pair<int, int>> asked{};
  for (const AttemptDone& done : done_) asked.emplace_back(done.trial, done.attempt);
  EXPECT_THAT(asked, ElementsAre(testing::Pair(1, 1), testing::Pair(2, 1), testing::Pair(2, 2),
                                 testing::Pair(3, 1)));
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_FALSE(rows[1].valid);
  EXPECT_THAT(rows[1].invalid_reason->text, HasSubstr("somebody came in"));
  EXPECT_FALSE(rows[1].responses.empty());  // it stays
  EXPECT_TRUE(rows[2].valid);
  EXPECT_FALSE(monitor_.snapshot().attempts->at(1).valid);
  EXPECT_FALSE(requests_.pending().repeat_last);
  EXPECT_EQ(events_of("trial_repeated").size(), 1U);
}

TEST_F(WatchedSession, AsksTheVeryLastTrialAgainAsWell) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.repeat_last("");
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_EQ(attempts().size(), 2U);
  EXPECT_TRUE(attempts()[1].valid);
}

TEST_F(WatchedSession, AsksASkippedTrialAgainWhenWanted) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.skip("the wrong sample lay there");
    requests_.repeat_last("the right sample lies there now");
    return feels_again(1);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::skipped);
  EXPECT_EQ(
      rows[0].invalid_reason.value().text,
      "the wrong sample lay there; repeated by the experimenter: the right sample lies there now");
  EXPECT_EQ(monitor_.snapshot().attempts->at(0).reason.english(), rows[0].invalid_reason->text);
  EXPECT_TRUE(rows[1].valid);
}

TEST_F(WatchedSession, AsksARepeatedTrialAgainAfterAResumeWhenItWasInterrupted) {
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) {
      requests_.skip("a cough");
      requests_.repeat_last("over");
    } else if (question == 2) {
      requests_.abort("the fire alarm rang");
    }
    return feels_again(1);
  };
  EXPECT_EQ(run().state, SessionState::stopped);
  EXPECT_EQ(unfinished_sessions(*study_, protocol_).at(0).trials_done, 0);  // skipped, set aside
  EXPECT_EQ(session_detail(*study_, session_.row.id).overview.done_trials, 0);
  reopen_session();
  person_.at_question = {};
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[2].trial, 1);  // skipped, set aside, aborted: this one counts
  EXPECT_TRUE(rows[2].valid);
}

/// Each trial in a block of its own.
std::string blocks_of_one_trial(const std::string& exploration = "") {
  std::string text = one_trial(small_protocol("", exploration));
  text.replace(text.find(R"({"run": "main"})"), 15, R"({"run": "main"}, {"run": "main"})");
  return text;
}

TEST_F(WatchedSession, AsksARepeatedTrialUntilItCountsAlsoWhenItsBlockIsOver) {
  begin(blocks_of_one_trial(R"(, "on_failure": "requeue_at_end_of_block", "maximum_repeats": 2)"));
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.repeat_last("somebody came in");
    return chooses(0);
  };
  // In the second attempt the first touch is too short.
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.attempt == 2 && now.phase == SessionPhase::contact) rig_->hand().lift();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].outcome, AttemptOutcome::not_compliant);
  EXPECT_EQ(rows[2].trial, 1);
  EXPECT_TRUE(rows[2].valid);
  EXPECT_TRUE(rows[3].valid);
}

TEST_F(WatchedSession, AsksARepeatedTrialOfAnEarlierBlockAgainAfterAResume) {
  begin(blocks_of_one_trial());
  person_.at_question = [&](int question, const Trial& trial) -> Reply {
    if (question == 1) {
      EXPECT_EQ(trial.ordinal, 1);
    } else if (question == 2) {  // trial 2 is not answered: the last is trial 1
      EXPECT_EQ(trial.ordinal, 2);
      requests_.repeat_last("the hand had slipped");
      requests_.emergency_stop();
      return feels_again(1);
    } else if (question == 3) {
      EXPECT_EQ(trial.ordinal, 1);
      requests_.abort("the fire alarm rang");
      return feels_again(1);
    }
    return chooses(0);
  };
  once_in(SessionPhase::fault, [&] { requests_.clear_fault(); });
  EXPECT_EQ(run().state, SessionState::stopped);
  reopen_session();
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<int> counted{};
  for (const AttemptRow& row : attempts()) {
    if (row.valid) counted.push_back(row.trial);
  }
  EXPECT_THAT(counted, ElementsAre(1, 2));
}

TEST_F(WatchedSession, PausesAfterARepeatedTrialToo) {
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.repeat_last("somebody came in");
    if (question == 2) requests_.pause();
    return chooses(0);
  };
  std::size_t stored = 0;
  once_in(SessionPhase::paused, [&] {
    stored = attempts().size();
    requests_.resume();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(stored, 2U);
}

TEST_F(WatchedSession, IsInTheBlockOfTheNextTrialAfterARepeatedOne) {
  begin(blocks_of_one_trial());
  std::vector<int> blocks{};
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.repeat_last("somebody came in");
    blocks.push_back(monitor_.snapshot().scene->block);
    return chooses(0);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(blocks, ElementsAre(1, 1, 2));
}

TEST_F(WatchedSession, SaysThatThereIsNothingToRepeat) {
  begin(one_trial());
  requests_.repeat_last("too early");
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(events_of("repeat_refused").size(), 1U);
  EXPECT_EQ(attempts().size(), 1U);
}

}  // namespace
}  // namespace asperity
