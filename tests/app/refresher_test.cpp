// Practice that is repeated when a session is resumed, and breaks after a time in contact.

#include <algorithm>
#include <functional>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/session_setup.h"
#include "app/tasks/verify/verify_study.h"
#include "tests/app/scripted_session.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Practice to three correct responses in a row, and a main block of two trials.
std::string refreshed_protocol(int practice_trials) {
  const std::string text = replaced(practised_protocol("continue_flagged"), R"("main": {)",
                                    R"("main": {"repetitions": 2,)");
  return replaced(
      text, R"("flow":)",
      R"("resume": {"practice_trials": )" + std::to_string(practice_trials) + R"(}, "flow":)");
}

class RefreshedSession : public ResumableSession {
 protected:
  void begin_refreshed(int practice_trials) {
    begin(refreshed_protocol(practice_trials));
    person_.at_question = [](int, const Trial& trial) { return correct_reply(trial); };
  }

  ConductorSettings settings() const override { return {.record = true}; }

  /// "1/2 refresher" of every attempt in the order in which they were made.
  std::vector<std::string> made() const {
    std::vector<AttemptRow> rows = attempts();
    std::sort(rows.begin(), rows.end(),
              [](const AttemptRow& a, const AttemptRow& b) { return a.id < b.id; });
    std::vector<std::string> texts{};
    for (const AttemptRow& row : rows) {
      texts.push_back(std::to_string(row.trial) + '/' + std::to_string(row.attempt) + ' ' +
                      text_of(row.purpose));
    }
    return texts;
  }
};

TEST_F(RefreshedSession, RepeatsTheFirstTrialsOfThePracticeAndCountsNone) {
  begin_refreshed(2);
  ASSERT_EQ(run_attempts(4).state, SessionState::stopped);
  person_.at_question = [](int, const Trial& trial) {
    return trial.phase == Phase::practice ? incorrect_reply(trial) : correct_reply(trial);
  };
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_THAT(made(), ElementsAre("1/1 trial", "2/1 trial", "3/1 trial", "6/1 trial",
                                  "1/2 refresher", "2/2 refresher", "7/1 trial"));
  EXPECT_THAT(person_.texts, Contains(HasSubstr("practice trials again")));
  EXPECT_THAT(person_.texts, Contains(HasSubstr("Incorrect"))) << "with the practice's feedback";
  ASSERT_EQ(done_.size(), 3U);
  EXPECT_FALSE(done_[0].counts);
  EXPECT_TRUE(done_[2].counts);
  const SessionCounts counts = study_->session_counts(session_.row.id);
  EXPECT_EQ(counts.done_trials, 5);
  EXPECT_EQ(counts.attempts, 7);
  EXPECT_EQ(verified_trials(), 7U);
  for (const AttemptRow& row : attempts()) {
    if (row.purpose == AttemptPurpose::refresher) {
      EXPECT_TRUE(row.valid);
    }
  }
}

TEST_F(RefreshedSession, RepeatsThemAtEveryResume) {
  begin_refreshed(1);
  ASSERT_EQ(run_attempts(3).state, SessionState::stopped);  // the practice is over
  ASSERT_EQ(resume(2).state, SessionState::stopped);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_THAT(made(), ElementsAre("1/1 trial", "2/1 trial", "3/1 trial", "1/2 refresher",
                                  "6/1 trial", "1/3 refresher", "7/1 trial"));
}

TEST_F(RefreshedSession, IsInterruptedWithinItsRefreshersWithoutHarm) {
  begin_refreshed(3);
  ASSERT_EQ(run_attempts(4).state, SessionState::stopped);
  ASSERT_EQ(resume(1).state, SessionState::stopped);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_THAT(made(),
              ElementsAre("1/1 trial", "2/1 trial", "3/1 trial", "6/1 trial", "1/2 refresher",
                          "1/3 refresher", "2/2 refresher", "3/2 refresher", "7/1 trial"));
}

TEST_F(RefreshedSession, ContinuesAnInterruptedPracticeInstead) {
  begin_refreshed(2);
  ASSERT_EQ(run_attempts(2).state, SessionState::stopped);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_THAT(made(), ElementsAre("1/1 trial", "2/1 trial", "3/1 trial", "6/1 trial", "7/1 trial"));
  EXPECT_THAT(person_.texts, Not(Contains(HasSubstr("practice trials again"))));
}

/// A main trial of the earlier stretch must not be asked among practice trials.
TEST_F(RefreshedSession, RefusesToRepeatTheLastTrialWhilePracticeIsRepeated) {
  begin_refreshed(2);
  ASSERT_EQ(run_attempts(4).state, SessionState::stopped);
  bool has_asked = false;
  person_.at_tell = [&] {
    if (!has_asked) conductor_->requests().repeat_last("the door banged");
    has_asked = true;
  };
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_TRUE(has_asked);
  EXPECT_THAT(made(), ElementsAre("1/1 trial", "2/1 trial", "3/1 trial", "6/1 trial",
                                  "1/2 refresher", "2/2 refresher", "7/1 trial"));
  std::vector<std::string> refused{};
  for (const EventRow& event : study_->events(session_.row.id)) {
    if (event.kind == "repeat_refused") refused.push_back(event.text);
  }
  EXPECT_THAT(refused, ElementsAre(HasSubstr("practice trials are being repeated")));
}

TEST_F(RefreshedSession, HasNoRefreshersWhenSimulated) {
  begin_refreshed(2);
  ASSERT_EQ(run_attempts(4).state, SessionState::stopped);
  session_ = reopen(*study_, protocol_, stored_session());
  session_.row.mode = SessionMode::simulate;
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 5U);
}

/// How a refresher, or the trial before it, is interrupted.
struct Interrupting {
  std::string name{};
  std::function<Reply(SessionRequests&, ServoLoop&)> act{};
  AttemptOutcome outcome = AttemptOutcome::aborted;
  bool ends_session = true;
};

std::ostream& operator<<(std::ostream& out, const Interrupting& interrupting) {
  return out << interrupting.name;
}

/// A track of four practice trials, and two tracks of three trials.
constexpr const char* kPractisedTracks = R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "practised_tracks",
  "version": "1.0.0", "title": "Practised tracks",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
  "blocks": {
    "practice": {
      "phase": "practice", "exploration": "short", "feedback": "correctness",
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 50, "highest": 100, "step": 10}},
      "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [10],
                    "stop": {"trials": 4}, "start": 80},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}},
    "main": {
      "exploration": "short",
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
      "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [20, 10, 5],
                    "stop": {"trials": 3}, "tracks": [{"start": 50}, {"start": 25}]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "resume": {"practice_trials": 2},
  "flow": [{"run": "practice"}, {"run": "main"}]})";

class InterruptedRefresher : public RefreshedSession,
                             public testing::WithParamInterface<Interrupting> {
 protected:
  /// The participant answers one of three trials incorrectly, and every refresher otherwise than the trial. At this
  /// question of the run (0: none) it is interrupted.
  void interrupt_at(int question) {
    person_.at_question = [this, question, asked = 0](int, const Trial& trial) mutable {
      if (++asked == question) {
        return GetParam().act(conductor_->requests(), rig_->loop());
      }
      const bool was_answered = is_answered(trial.ordinal);
      return reply_that_is(trial, (trial.ordinal % 3 != 0) != was_answered);
    };
  }

  bool is_answered(int trial) const {
    const std::vector<AttemptRow> rows = attempts();
    return std::any_of(rows.begin(), rows.end(), [trial](const AttemptRow& row) {
      return row.trial == trial && row.outcome == AttemptOutcome::answered;
    });
  }
};

TEST_P(InterruptedRefresher, LeavesEveryTrackAsItIs) {
  begin(kPractisedTracks);
  interrupt_at(0);
  ASSERT_EQ(run().state, SessionState::completed);
  const std::vector<std::string> expected = stored_plan();
  ASSERT_EQ(expected.size(), 10U);

  SessionTest::start("p2", 7);
  // A skipped trial changes its track; here the session is stopped before it.
  const bool ends = GetParam().ends_session;
  interrupt_at(ends ? 6 : 0);
  ASSERT_EQ(run_attempts(ends ? kToItsEnd : 5).state, SessionState::stopped);
  interrupt_at(1);
  SessionEnd end = resume();
  if (ends) {
    ASSERT_EQ(end.state, SessionState::stopped);
    interrupt_at(0);
    end = resume();
  }
  ASSERT_EQ(end.state, SessionState::completed) << end.reason.english();
  std::vector<std::string> order{"1/1 trial", "2/1 trial", "3/1 trial", "4/1 trial", "5/1 trial"};
  if (ends) order.push_back("6/1 trial");
  order.push_back("1/2 refresher");
  if (ends) order.push_back("1/3 refresher");
  order.push_back("2/2 refresher");
  order.push_back(ends ? "6/2 trial" : "6/1 trial");
  for (const char* const last : {"7/1 trial", "8/1 trial", "9/1 trial", "10/1 trial"}) {
    order.emplace_back(last);
  }
  EXPECT_EQ(made(), order);
  EXPECT_EQ(stored_plan(), expected);
  EXPECT_EQ(study_->session_counts(session_.row.id).done_trials, 10);
  int interrupted = 0;
  for (const AttemptRow& row : attempts()) {
    const bool is_interrupted = row.outcome == GetParam().outcome;
    interrupted += is_interrupted ? 1 : 0;
    EXPECT_EQ(row.valid, !is_interrupted) << row.trial << '/' << row.attempt;
  }
  EXPECT_EQ(interrupted, ends ? 2 : 1);
  const VerifyResult verified = verify_study(*study_, models_, true, {}, [](double) {});
  EXPECT_THAT(verified.problems, testing::IsEmpty());
  EXPECT_EQ(verified.recordings_replayed, 10 + static_cast<int>(attempts().size()));
}

INSTANTIATE_TEST_SUITE_P(Each, InterruptedRefresher,
                         testing::Values(Interrupting{"Fault",
                                                      [](SessionRequests&, ServoLoop& loop) {
                                                        loop.lose_device();
                                                        return feels_again(1);
                                                      },
                                                      AttemptOutcome::device_fault},
                                         Interrupting{"EmergencyStop",
                                                      [](SessionRequests& requests, ServoLoop&) {
                                                        requests.emergency_stop();
                                                        return feels_again(1);
                                                      },
                                                      AttemptOutcome::emergency_stop},
                                         Interrupting{"Abort",
                                                      [](SessionRequests& requests, ServoLoop&) {
                                                        requests.abort("the fire alarm rang");
                                                        return feels_again(1);
                                                      },
                                                      AttemptOutcome::aborted},
                                         Interrupting{"Skip",
                                                      [](SessionRequests& requests, ServoLoop&) {
                                                        requests.skip("the sample broke");
                                                        return feels_again(1);
                                                      },
                                                      AttemptOutcome::skipped, false},
                                         Interrupting{"ParticipantGone",
                                                      [](SessionRequests&, ServoLoop&) -> Reply {
                                                        throw RespondentGone(
                                                            "the participant left");
                                                      },
                                                      AttemptOutcome::aborted}),
                         [](const auto& each) { return each.param.name; });

/// Three trials of two surfaces, felt for at least 0.4 s each, with a break after 0.6 s of contact.
TEST_F(SessionTest, RestsOnceSurfacesWereInContactForLongEnough) {
  begin(replaced(small_protocol(), R"({"run": "main"})",
                 R"({"run": "main", "break_every_contact_minutes": 0.01,
                   "pause": {"minimum_s": 1, "text": "Rest."}})"));
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> rows = attempts();
  double since_break_s = 0.0;
  std::size_t expected = 0;
  std::vector<std::int64_t> ends_ns{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (since_break_s >= 0.6) {
      ++expected;
      since_break_s = 0.0;
      ends_ns.push_back(rows[i - 1].offset_ns);
    }
    for (const PresentationRow& surface : rows[i].presentations) since_break_s += surface.contact_s;
  }
  ASSERT_GE(expected, 1U);
  std::vector<std::int64_t> breaks_ns{};
  for (const EventRow& event : study_->events(session_.row.id)) {
    if (event.kind == "break_began") breaks_ns.push_back(event.time_ns);
  }
  ASSERT_EQ(breaks_ns.size(), expected);
  for (std::size_t i = 0; i < expected; ++i) EXPECT_GE(breaks_ns[i], ends_ns[i]);
  for (const PlanStep& step : verified_plan().steps) {
    EXPECT_FALSE(std::holds_alternative<Protocol::Break>(step)) << "is not planned";
  }
}

}  // namespace
}  // namespace asperity
