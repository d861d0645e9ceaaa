// A session that is watched and steered from outside: requests, phases, scenes, sounds, troubles.

#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <set>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/respondents/person_at_window.h"
#include "app/session/rig/recording_columns.h"
#include "app/tasks/study_overview.h"
#include "app/tasks/unfinished_session.h"
#include "renderers/built_in_models.h"
#include "tests/app/scripted_session.h"
#include "tests/support/patient_servo.h"
#include "tests/support/scripted_sound.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class WatchedSession : public SessionTest {
 protected:
  WatchedSession() {
    links_ = {.requests = &requests_, .monitor = &monitor_, .experimenter_is_there = true};
  }

  void play_sound() {
    sound_.now_ns = [this] { return rig_->clock().now_ns(); };
    links_.sound = &loudspeakers_;
  }

  /// Once, when the session is first in this phase.
  void once_in(SessionPhase phase, const std::function<void()>& act) {
    rig_->at_pass = [this, phase, act, done = false]() mutable {
      if (done || monitor_.snapshot().phase != phase) return;
      done = true;
      act();
    };
  }

  std::vector<std::string> phases() const {
    std::vector<EventRow> events = study_->events(session_.row.id);
    for (const AttemptRow& attempt : attempts()) {
      events.insert(events.end(), attempt.events.begin(), attempt.events.end());
    }
    std::stable_sort(events.begin(), events.end(), [](const EventRow& one, const EventRow& other) {
      return one.time_ns < other.time_ns;
    });
    std::vector<std::string> names{};
    for (const EventRow& event : events) {
      if (event.kind == "phase") names.push_back(event.text);
    }
    return names;
  }

  std::vector<EventRow> events_of(const std::string& kind) const {
    std::vector<EventRow> found{};
    for (const EventRow& event : study_->events(session_.row.id)) {
      if (event.kind == kind) found.push_back(event);
    }
    return found;
  }

  SessionMonitor monitor_{};
  SessionRequests requests_{};
  SoundLog sound_{};
  ScriptedSound loudspeakers_{sound_};
};

std::string with(std::string text, const std::string& before, const std::string& added) {
  text.insert(text.find(before), added);
  return text;
}

std::string with_noise(const std::string& text) {
  return with(text, "\"textures\"",
              R"("environment": {"masking_noise": {"kind": "pink", "level_dBA": 60}}, )");
}

/// One trial only.
std::string one_trial(std::string text = small_protocol()) {
  return text.replace(text.find("[1, 2, 3]"), 9, "[1]");
}

TEST_F(WatchedSession, StoresEveryChangeOfPhaseInOrder) {
  begin(one_trial());
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(phases(), ElementsAre("ready", "iti", "fore", "contact", "fore", "contact",
                                    "response", "questions", "ready", "ended"));
  EXPECT_EQ(monitor_.snapshot().phase, SessionPhase::ended);
}

TEST_F(WatchedSession, StoresNoPhasesWhereNobodyWatches) {
  links_ = {};
  begin(one_trial());
  run();
  EXPECT_THAT(phases(), testing::IsEmpty());
}

TEST_F(WatchedSession, RendersTheSameWhetherOrNotItIsWatched) {
  begin(one_trial());
  run();
  const auto columns = [this] {
    return read_recording(study_->folder() / attempts().front().recording->path).columns;
  };
  const auto watched = columns();
  links_ = {};
  make_rig({});
  SessionConditions conditions{};
  conditions.seed = 7;
  conditions.pacing = rig_->pacing();
  conditions.started_utc = rig_->clock().utc();
  conditions.device = rig_->capability();
  session_ = begin_session(*study_, protocol_, "p1", conditions, this_program());
  run();
  EXPECT_EQ(columns(), watched);
}

TEST_F(WatchedSession, ShowsScenesInTheLanguageOfTheProtocol) {
  begin(with(one_trial(), "\"textures\"", R"("language": "de", )"));
  person_.at_question = [&](int, const Trial&) -> Reply {
    EXPECT_EQ(monitor_.snapshot().scene->language, "de");
    return chooses(1);
  };
  run();
  EXPECT_EQ(monitor_.snapshot().scene->language, "de");
}

TEST_F(WatchedSession, ShowsItsProgressAndEveryAttempt) {
  begin(small_protocol());
  std::vector<std::optional<double>> left_s{};
  person_.at_question = [&](int, const Trial& trial) -> Reply {
    const SessionSnapshot now = monitor_.snapshot();
    left_s.push_back(now.expected_left_s);
    EXPECT_EQ(now.phase, SessionPhase::response);
    EXPECT_EQ(now.trial, trial.ordinal);
    EXPECT_EQ(now.attempt, 1);
    EXPECT_EQ(now.block, 1);
    EXPECT_EQ(now.blocks, 1);
    EXPECT_EQ(now.trials, 3);
    EXPECT_EQ(now.trials_done, trial.ordinal - 1);
    EXPECT_EQ(now.rows_stored, trial.ordinal - 1);
    EXPECT_EQ(now.now_ns, rig_->clock().now_ns());
    EXPECT_EQ(now.scene->kind, ParticipantScene::Kind::question);
    EXPECT_EQ(now.scene->block, 1);
    return chooses(1);
  };
  run();
  EXPECT_THAT(left_s, ElementsAre(std::nullopt, std::nullopt, std::nullopt));  // too few trials
  const SessionSnapshot end = monitor_.snapshot();
  EXPECT_EQ(end.trials_done, 3);
  EXPECT_EQ(end.block, 0);
  EXPECT_EQ(end.expected_left_s, 0.0);
  EXPECT_EQ(end.scene->kind, ParticipantScene::Kind::ended);
  EXPECT_NEAR(end.health.rate_Hz, 1000.0, 1.0);
  ASSERT_EQ(end.attempts->size(), 3U);
  const AttemptSummary& last = end.attempts->back();
  EXPECT_EQ(last.trial, 3);
  EXPECT_TRUE(last.valid);
  EXPECT_THAT(last.answers, ElementsAre("B"));  // as it was shown, no name
  EXPECT_FALSE(last.correct);                   // nothing is right or wrong in a selection
  EXPECT_NEAR(*last.from_cue_s, 0.2, 1e-3);
  const auto facts = monitor_.facts();
  ASSERT_NE(facts, nullptr);
  EXPECT_EQ(facts->row.participant, "p1");
  EXPECT_EQ(facts->plan->trials.size(), 3U);
  EXPECT_EQ(facts->protocol->name, "small");
}

/// Outside attempts: what is done, and which trial comes.
TEST_F(WatchedSession, CountsATrialAsDoneAndNamesTheOneThatComesInEveryPhaseBetween) {
  const std::string plain = R"({"run": "main"})";
  std::string text = small_protocol();
  text.replace(text.find(plain), plain.size(), R"({"run": "main", "break_every_trials": 1,
      "pause": {"minimum_s": 1, "text": "Rest.", "zero_force": true}})");
  begin(text);
  std::vector<std::string> seen{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    const bool in_attempt = now.phase == SessionPhase::fore || now.phase == SessionPhase::contact ||
                            now.phase == SessionPhase::response;
    if (in_attempt) {
      EXPECT_EQ(now.trial, now.trials_done + 1);
      return;
    }
    const std::string line =
        std::string(text_of(now.phase)) + ": " + std::to_string(now.trials_done) + " done, " +
        std::to_string(now.trial) + " comes, last " + std::to_string(now.last_done);
    EXPECT_EQ(now.attempts->size(), static_cast<std::size_t>(now.trials_done));
    if (seen.empty() || seen.back() != line) seen.push_back(line);
  };
  run();
  EXPECT_THAT(seen, ElementsAre("ready: 0 done, 1 comes, last 0", "rest: 1 done, 2 comes, last 1",
                                "rest: 2 done, 3 comes, last 2", "ready: 3 done, 0 comes, last 3"));
  EXPECT_EQ(monitor_.snapshot().trial, 0);
}

TEST_F(WatchedSession, NamesTheTrialThatComesWhileItTellsWhatWasRight) {
  begin(practised_protocol("continue_flagged"));
  std::vector<std::pair<int, int>> told{};
  person_.at_tell = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    EXPECT_EQ(now.phase, SessionPhase::feedback);
    told.emplace_back(now.last_done, now.trial);
  };
  person_.at_question = [](int question, const Trial& trial) {
    return question == 1 ? incorrect_reply(trial) : correct_reply(trial);
  };
  run();
  // The fourth meets the criterion, and the fifth of the practice is not asked.
  EXPECT_THAT(told, ElementsAre(testing::Pair(1, 2), testing::Pair(2, 3), testing::Pair(3, 4),
                                testing::Pair(4, 6)));
  const SessionSnapshot end = monitor_.snapshot();
  EXPECT_EQ(end.trials_done, end.trials);
  EXPECT_EQ(end.trials_not_needed, 1);
}

// A frame of a window may fall at any moment.
TEST_F(WatchedSession, ShowsNoAttemptAsDoneWhoseTrialIsStillUnderWay) {
  begin(small_protocol());
  std::vector<std::pair<std::size_t, int>> shown{};
  ConductorSettings settings{};
  settings.links = links_;
  settings.done = [&](const AttemptDone&) {
    const SessionSnapshot now = monitor_.snapshot();
    EXPECT_EQ(now.phase, SessionPhase::iti);
    shown.emplace_back(now.attempts->size(), now.trial);
  };
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person_, settings);
  conductor.run(session_);
  EXPECT_THAT(shown, ElementsAre(testing::Pair(1U, 2), testing::Pair(2U, 3), testing::Pair(3U, 0)));
}

TEST_F(WatchedSession, ShowsTheParticipantsSceneBeforeEachCall) {
  begin(one_trial());
  std::vector<ParticipantScene::Kind> kinds{};
  rig_->at_pass = [&] {
    const auto kind = monitor_.snapshot().scene->kind;
    if (kinds.empty() || kinds.back() != kind) kinds.push_back(kind);
  };
  run();
  using Scene = ParticipantScene::Kind;
  EXPECT_THAT(kinds, ElementsAre(Scene::text, Scene::blank, Scene::feel, Scene::blank, Scene::feel,
                                 Scene::question, Scene::text));
}

TEST_F(WatchedSession, SaysThatASurfaceWasFeltLongEnoughUntilTheHandHasLifted) {
  play_sound();
  begin(one_trial());
  std::vector<std::string> said{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.scene->kind != ParticipantScene::Kind::feel) return;
    const std::vector<std::string> cues = sound_.cues();
    const bool is_over = !cues.empty() && cues.back() == "next";
    EXPECT_EQ(now.scene->text_saying.what,
              is_over ? Saying::What::lift : Saying::What::feel_surface);
    EXPECT_TRUE(now.scene->surfaces.at(now.surface == 1 ? 0 : 1).now);
    if (said.empty() || said.back() != now.scene->text) said.push_back(now.scene->text);
  };
  run();  // nobody asks for the end of a surface
  EXPECT_THAT(said, ElementsAre("Feel surface A now.",
                                "You have finished with surface A. Please lift the handle.",
                                "Feel surface B now.",
                                "You have finished with surface B. Please lift the handle."));
}

TEST_F(WatchedSession, FollowsTheContactWithTheSurfaceUnderTheHand) {
  begin(one_trial());
  double largest_s = 0.0;
  std::vector<int> surfaces{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    largest_s = std::max(largest_s, now.contact_s);
    if (surfaces.empty() || surfaces.back() != now.surface) surfaces.push_back(now.surface);
    if (now.surface != 0) {
      EXPECT_DOUBLE_EQ(now.wanted_contact_s, 0.625);
    }
  };
  run();
  EXPECT_GE(largest_s, 0.625);
  EXPECT_LT(largest_s, 1.0);
  EXPECT_THAT(surfaces, ElementsAre(0, 1, 2, 0));
}

TEST_F(WatchedSession, MakesBinsOfAllThatTheProbeDoesAlsoBetweenAttempts) {
  begin(one_trial());
  run();
  std::vector<LiveBin> bins{};
  monitor_.bins_from(0, bins);
  ASSERT_GT(bins.size(), 60U);
  for (std::size_t i = 1; i < bins.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(bins[i].time_ns - bins[i - 1].time_ns) * 1e-9, 1.0 / 60.0,
                0.0021)
        << i;
  }
  const AttemptRow attempt = attempts().front();
  const auto records = records_of(read_recording(study_->folder() / attempt.recording->path));
  double largest_N = 0.0;
  for (const TickRecord& record : records) {
    largest_N = std::max(largest_N, glm::length(record.sent.force_N));
  }
  float shown_N = 0.0F;
  bool touched = false;
  for (const LiveBin& bin : bins) {
    shown_N = std::max(shown_N, bin.force_maximum_N);
    touched = touched || (bin.touching && bin.surface == 2);
  }
  EXPECT_FLOAT_EQ(shown_N, static_cast<float>(largest_N));
  EXPECT_TRUE(touched);
  EXPECT_LT(bins.front().time_ns, attempt.onset_ns);
  EXPECT_GT(bins.back().time_ns, attempt.offset_ns);
}

// --- requests ------------------------------------------------------------------------------------

TEST_F(WatchedSession, ExpectsTheTrialsThatAreLeftToTakeAsLongAsThoseThatWereDone) {
  begin(small_protocol(R"(, "repetitions": 3)"));
  const int all = static_cast<int>(session_.course->plan().trials.size());
  ASSERT_EQ(all, 9);
  std::vector<std::optional<double>> left_s{};
  person_.at_question = [&](int, const Trial& trial) -> Reply {
    left_s.push_back(monitor_.snapshot().expected_left_s);
    rig_->move_clock_to(rig_->clock().now_ns() + 20'000'000'000);  // slower than any plan expects
    if (trial.ordinal == 5) requests_.stop_after(StopAfter::trial);
    return chooses(1);
  };
  const auto expected_s = [&](int done) {
    const std::vector<AttemptRow> made = attempts();
    double spent_s = 0.0;
    for (int i = 0; i < done; ++i) {
      const AttemptRow& attempt = made.at(static_cast<std::size_t>(i));
      spent_s += static_cast<double>(attempt.offset_ns - attempt.onset_ns) * 1e-9;
    }
    constexpr double kQuestionsAndScreen_s = 2.0 * 8.0 + 5.0;  // as planned
    return spent_s / done * (all - done) + kQuestionsAndScreen_s;
  };
  run();
  ASSERT_EQ(left_s.size(), 5U);
  for (int done = 0; done < 3; ++done) EXPECT_FALSE(left_s[static_cast<std::size_t>(done)]);
  EXPECT_NEAR(left_s[3].value(), expected_s(3), 1e-6);
  EXPECT_NEAR(left_s[4].value(), expected_s(4), 1e-6);
  EXPECT_GT(expected_s(4), 5 * 20.0);
}

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

// --- faults --------------------------------------------------------------------------------------

TEST_F(WatchedSession, WaitsInAFaultUntilItIsClearedAndAsksTheTrialAgain) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] {
    const SessionSnapshot now = monitor_.snapshot();
    ASSERT_TRUE(now.trouble);
    EXPECT_EQ(now.trouble->remedy, SessionTrouble::Remedy::clear_fault);
    EXPECT_TRUE(now.trouble->what.can_be_translated());
    EXPECT_EQ(now.trouble->what.english(),
              "The emergency stop was pressed in trial 1. The force is zero until the stop is "
              "cleared.");
    EXPECT_EQ(now.fault, Fault::emergency_stop);
    EXPECT_EQ(now.scene->kind, ParticipantScene::Kind::paused);
    ASSERT_EQ(attempts().size(), 1U);  // stored before anybody is told
    requests_.clear_fault();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::emergency_stop);
  EXPECT_EQ(rows[0].servo->fault, "emergency_stop");
  EXPECT_EQ(rows[1].trial, 1);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  EXPECT_THAT(phases(), ElementsAre("ready", "iti", "fore", "contact", "fore", "contact",
                                    "response", "fore", "fault", "iti", "fore", "contact", "fore",
                                    "contact", "response", "questions", "ready", "ended"));
  ASSERT_EQ(events_of("fault").size(), 1U);
  EXPECT_EQ(events_of("fault").front().data_json, "null");
  EXPECT_EQ(events_of("fault_cleared").size(), 1U);
}

/// Fails in its first contact, as a plug-in does.
class FailingRenderer final : public ForceRenderer {
 public:
  explicit FailingRenderer(std::unique_ptr<ForceRenderer> sound) : sound_(std::move(sound)) {}
  void reset(const ProbeState& first) noexcept override { sound_->reset(first); }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    RenderedTick result = sound_->tick(probe, dt_s);
    has_failed_ = has_failed_ || result.penetration_m > 0.0;
    if (has_failed_) result.wrench.force_N.z = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  std::string_view error() const noexcept override {
    return has_failed_ ? "the ridge is too steep" : "";
  }

 private:
  std::unique_ptr<ForceRenderer> sound_{};
  bool has_failed_ = false;
};

TEST_F(WatchedSession, StoresTheMessageOfAPluginWithItsFault) {
  ModelRegistry models{};
  for (ForceModel model : models_.models()) {
    if (model.declaration.id == "height_map") {
      model.make = [sound = model.make, has_failed = std::make_shared<bool>(false)](
                       const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
        if (std::exchange(*has_failed, true)) return sound(inputs);
        return std::make_unique<FailingRenderer>(sound(inputs));
      };
    }
    models.add(std::move(model));
  }
  models_ = std::move(models);
  begin(one_trial());
  once_in(SessionPhase::fault, [&] { requests_.clear_fault(); });
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<EventRow> faults = events_of("fault");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().text, "not_finite");
  EXPECT_EQ(faults.front().data_json,
            R"({"reason":"the plug-in of the force model height_map failed: the ridge is too )"
            R"(steep"})");
}

TEST_F(WatchedSession, ContinuesAfterAFaultWhenWhoeverAnswersSaysThatItIsMended) {
  begin(one_trial());
  links_.monitor = nullptr;  // as on a terminal
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  int asked = 0;
  person_.at_fault = [&] {
    return ++asked < 20 ? Respondent::AfterFault::nothing : Respondent::AfterFault::go_on;
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(asked, 20);
  EXPECT_THAT(person_.faults_heard,
              ElementsAre("The emergency stop was pressed in trial 1. The force is zero until the "
                          "stop is cleared."));
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::emergency_stop);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_EQ(events_of("fault_cleared").size(), 1U);
}

TEST_F(WatchedSession, EndsAfterAFaultWhenWhoeverAnswersWantsThat) {
  begin(one_trial(), {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0}});
  person_.at_fault = [] { return Respondent::AfterFault::end; };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(), HasSubstr("the device does not respond"));
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, TellsWhatTheDeviceComplainsOfUntilItIsWell) {
  begin(small_protocol());
  std::vector<std::string> lines{};
  links_.tell = [&lines](const std::string& line) { lines.push_back(line); };
  std::vector<std::string> shown{};
  int slices = 0;
  rig_->at_pass = [&] {
    ++slices;
    if (slices == 20) rig_->complains = "Its motors gave less than was asked for 1 times.";
    // Its words change in every slice: shown as they are, and told and stored now and then.
    if (slices > 20 && slices < 120) {
      rig_->complains =
          "Its motors gave less than was asked for " + std::to_string(slices) + " times.";
    }
    if (slices == 120) rig_->complains.clear();
    const SessionSnapshot now = monitor_.snapshot();
    if (shown.empty() || shown.back() != now.device_complaint)
      shown.push_back(now.device_complaint);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_GT(slices, 140);
  EXPECT_GT(shown.size(), 6U);
  EXPECT_EQ(shown.back(), "");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(lines[0], HasSubstr("Its motors gave less"));
  EXPECT_EQ(lines[1], "The device no longer reports a problem.");
  std::vector<std::string> kinds{};
  std::vector<EventRow> events = study_->events(session_.row.id);
  for (const AttemptRow& attempt : attempts()) {
    events.insert(events.end(), attempt.events.begin(), attempt.events.end());
  }
  for (const EventRow& event : events) {
    if (event.kind.rfind("device_", 0) == 0) kinds.push_back(event.kind);
  }
  EXPECT_THAT(kinds, testing::UnorderedElementsAre("device_trouble", "device_well"));
}

TEST_F(WatchedSession, AnEmergencyStopIsNotLiftedByWhatWasAskedForBeforeIt) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  int slices = 0;
  once_in(SessionPhase::fault, [&] {
    requests_.clear_fault();
    requests_.emergency_stop();  // in the same hundredths of a second
    rig_->at_pass = [&] {
      if (monitor_.snapshot().phase == SessionPhase::fault) ++slices;
      if (slices == 50) requests_.abort("stopped twice");
    };
  });
  EXPECT_EQ(run().reason, "stopped twice");
  EXPECT_EQ(slices, 50);
  EXPECT_EQ(attempts().size(), 1U);
  EXPECT_TRUE(events_of("fault_cleared").empty());
}

TEST_F(WatchedSession, ShowsThePauseAgainAfterAFaultInIt) {
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.pause();
    return chooses(0);
  };
  enum class Step { pause, fault, pause_again } step = Step::pause;
  std::vector<ParticipantScene::Kind> kinds{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (step == Step::pause && now.phase == SessionPhase::paused) {
      requests_.emergency_stop();
      step = Step::fault;
    } else if (step == Step::fault && now.phase == SessionPhase::fault) {
      requests_.clear_fault();
      step = Step::pause_again;
    } else if (step == Step::pause_again && now.phase == SessionPhase::paused) {
      kinds.push_back(now.scene->kind);
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_FALSE(kinds.empty());
  EXPECT_EQ(kinds.front(), ParticipantScene::Kind::paused);
}

// Nobody who wears an eye mask sees the screen.
TEST_F(WatchedSession, IsHeardToPauseInAFault) {
  play_sound();
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] { requests_.clear_fault(); });
  run();
  EXPECT_THAT(sound_.cues(), Contains("paused"));
}

TEST_F(WatchedSession, KeepsNotesOfASessionThatFails) {
  begin(small_protocol());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.note("it smells of smoke");
    throw std::runtime_error("the recording cannot be written");
  };
  EXPECT_THROW(run(), std::runtime_error);
  ASSERT_EQ(events_of("note").size(), 1U);
  EXPECT_EQ(events_of("session_failed").size(), 1U);
}

TEST_F(WatchedSession, SaysFeedbackInWordsThatCanBeTranslated) {
  begin(practised_protocol("continue_flagged"));
  std::vector<Saying::What> said{};
  person_.at_tell = [&] { said.push_back(monitor_.snapshot().scene->text_saying.what); };
  person_.at_question = [](int question, const Trial& trial) {
    return question == 1 ? incorrect_reply(trial) : correct_reply(trial);
  };
  run();
  EXPECT_THAT(said, ElementsAre(Saying::What::was_wrong, Saying::What::was_right,
                                Saying::What::was_right, Saying::What::was_right));
}

TEST_F(WatchedSession, StaysInTheFaultWhileTheDeviceIsNotFit) {
  begin(one_trial(), {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0}});
  bool told = false;
  bool cleared = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::fault || !now.trouble) return;
    if (!cleared) {
      cleared = true;
      requests_.clear_fault();
    } else if (!told && now.trouble->what.english().find("not ready") != std::string::npos) {
      told = true;
      requests_.abort("it is broken");
    }
  };
  const SessionEnd end = run();
  EXPECT_TRUE(told);
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "it is broken");
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, SaysThatTheEmergencyStopWasPressedWhileTheDeviceWasChecked) {
  begin(one_trial());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.emergency_stop();
    return feels_again(1);
  };
  enum class Step { stopped, checked, told } step = Step::stopped;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::fault || !now.trouble) return;
    if (step == Step::stopped) {
      requests_.clear_fault();
      step = Step::checked;
    } else if (step == Step::checked && now.fault == Fault::none) {
      requests_.emergency_stop();
      step = Step::told;
    } else if (now.trouble->what.english().ends_with(
                   " The emergency stop was pressed in the meantime.")) {
      requests_.abort("enough");
    }
  };
  EXPECT_EQ(run().reason, "enough");
}

TEST_F(WatchedSession, EndsFromAFaultWhenAskedToStop) {
  begin(one_trial());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] { requests_.stop_after(StopAfter::block); });
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the emergency stop was pressed in trial 1");
}

TEST_F(WatchedSession, BeginsAScreenAgainThatAFaultInterrupted) {
  begin(one_trial());
  bool stopped = false;
  rig_->at_pass = [&] {
    const SessionPhase phase = monitor_.snapshot().phase;
    if (phase == SessionPhase::ready && !stopped) {
      stopped = true;
      requests_.emergency_stop();
    }
    if (phase == SessionPhase::fault) requests_.clear_fault();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_GE(person_.texts.size(), 2U);
  EXPECT_EQ(person_.texts[0], "Welcome.");
  EXPECT_EQ(person_.texts[1], "Welcome.");
}

TEST_F(WatchedSession, AnEmergencyStopFromAPauseIsAFaultAtOnce) {
  begin(small_protocol());
  bool stopped = false;
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.pause();
    return chooses(0);
  };
  rig_->at_pass = [&] {
    const SessionPhase phase = monitor_.snapshot().phase;
    if (phase == SessionPhase::paused && !stopped) {
      stopped = true;
      requests_.emergency_stop();
    } else if (phase == SessionPhase::paused) {
      requests_.resume();
    }
    if (phase == SessionPhase::fault) requests_.clear_fault();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 3U);  // none was lost to the stop
  EXPECT_THAT(phases(), Contains("fault"));
}

TEST_F(WatchedSession, IsNotGoneOnWithAfterItEndedAsTheProtocolSays) {
  begin(practised_protocol("end_session"));
  person_.at_question = [](int, const Trial& trial) { return incorrect_reply(trial); };
  EXPECT_TRUE(run().as_the_protocol_says);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  EXPECT_TRUE(has_ended_by_rule(*study_, protocol_, study_->session(session_.row.id)));
  EXPECT_THROW(find_unfinished(*study_, protocol_, "p1", {}), std::runtime_error);
  const SessionOverview overview = session_overviews(*study_, {})[0];
  EXPECT_TRUE(overview.ended_by_rule);
  EXPECT_FALSE(overview.is_unfinished());
}

// --- sound ---------------------------------------------------------------------------------------

TEST_F(WatchedSession, PlaysItsNoiseFromBeforeTheContactUntilAfterIt) {
  play_sound();
  begin(one_trial(with_noise(small_protocol(R"(, "pause_before_trial_s": 0.5)"))));
  run();
  const std::vector<SoundLog::MaskingSwitch> masking = sound_.masking();
  ASSERT_EQ(masking.size(), 2U);
  const AttemptRow attempt = attempts().front();
  EXPECT_TRUE(masking[0].on);
  EXPECT_LT(masking[0].time_ns, *attempt.presentations[0].contact_ns);
  EXPECT_FALSE(masking[1].on);
  EXPECT_GT(masking[1].time_ns, *attempt.presentations[1].offset_ns);
  ASSERT_EQ(events_of("masking_noise").size(), 1U);
  EXPECT_EQ(events_of("masking_noise")[0].data_json, R"({"kind":"pink"})");
}

TEST_F(WatchedSession, LetsTheNoiseFadeInWhereThereIsNoPauseBeforeTheTrial) {
  play_sound();
  begin(one_trial(with_noise(small_protocol(R"(, "pause_before_trial_s": 0)"))));
  run();
  EXPECT_GE(*attempts().front().presentations[0].onset_ns - sound_.masking().at(0).time_ns,
            200'000'000);
}

TEST_F(WatchedSession, TellsTheHandByTonesUntilItHasEnoughOfTheSurface) {
  play_sound();
  begin(small_protocol("", R"(, "guidance": "tones", "normal_force_N": {"minimum": 0.5})"));
  rig_->at_pass = [this] {
    const bool is_told = sound_.guide() != GuideTone::none;
    EXPECT_TRUE(!is_told || monitor_.snapshot().hand.force_N.samples > 0);
  };
  person_.at_question = [this](int, const Trial&) -> Reply {
    EXPECT_EQ(sound_.guide(), GuideTone::none);
    return chooses(0);
  };
  run();
  // The force rises on each of six surfaces, and is then enough.
  const std::vector<GuideTone> guides = sound_.guides();
  EXPECT_EQ(std::count(guides.begin(), guides.end(), GuideTone::press_more), 6);
  EXPECT_EQ(std::count(guides.begin(), guides.end(), GuideTone::none), 7);
}

/// A hand that is told to press more from its first touch on, until whatever `act` does.
class TonedSession : public WatchedSession {
 protected:
  void begin_told_to_press_more() {
    play_sound();
    begin(small_protocol("", R"(, "guidance": "tones", "normal_force_N": {"minimum": 3})"));
  }
  bool tone_sounds() const { return sound_.guide() != GuideTone::none; }
};

TEST_F(TonedSession, IsSilentOnceItHasEnded) {
  begin_told_to_press_more();
  run();
  EXPECT_THAT(sound_.guides(), Contains(GuideTone::press_more));
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, IsSilentAfterAFailureInTheMiddleOfATone) {
  begin_told_to_press_more();
  rig_->at_pass = [this] {
    if (tone_sounds()) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_THAT(sound_.guides(), Contains(GuideTone::press_more));
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, AsksNothingOfAHandWhileItsSurfaceIsTakenAway) {
  begin_told_to_press_more();
  bool aborted = false;
  int passes_after = 0;
  rig_->at_pass = [&] {
    if (aborted) {
      ++passes_after;
      EXPECT_EQ(sound_.guide(), GuideTone::none);
    }
    if (!tone_sounds() || aborted) return;
    requests_.abort("enough");
    aborted = true;
  };
  EXPECT_EQ(run().state, SessionState::stopped);
  EXPECT_TRUE(aborted);
  EXPECT_GT(passes_after, 1);
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, StoresWhetherAnybodyIsGuided) {
  begin_told_to_press_more();
  run();
  ASSERT_EQ(events_of("guidance").size(), 1U);
  EXPECT_EQ(events_of("guidance")[0].text, "given");
  sound_.is_heard = false;
  SessionConditions conditions{};
  conditions.seed = 8;
  conditions.pacing = rig_->pacing();
  conditions.started_utc = rig_->clock().utc();
  conditions.device = rig_->capability();
  study_->add_participant({.label = "p2", .created_utc = "2026-01-01T00:00:00.000Z"});
  session_ = begin_session(*study_, protocol_, "p2", conditions, this_program());
  run();
  ASSERT_EQ(events_of("guidance").size(), 1U);
  EXPECT_EQ(events_of("guidance")[0].text, "not_given");
}

TEST_F(WatchedSession, PlaysNoNoiseThatTheProtocolDoesNotWant) {
  play_sound();
  begin(one_trial());
  run();
  EXPECT_TRUE(sound_.masking().empty());
}

TEST_F(WatchedSession, SoundsTheCuesOfATrial) {
  play_sound();
  begin(one_trial());
  run();
  EXPECT_THAT(sound_.cues(), ElementsAre("surface 1", "next", "surface 2", "next", "question",
                                         "accepted", "finished"));
}

TEST_F(WatchedSession, SaysWhetherItsNoiseSoundsAndNothingOfItOnceItHasEnded) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> in_contact{};
  std::set<MaskingState> in_reading{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase == SessionPhase::contact) in_contact.insert(now.masking);
    if (now.phase == SessionPhase::ready) in_reading.insert(now.masking);
  };
  run();
  EXPECT_THAT(in_contact, ElementsAre(MaskingState::on));
  EXPECT_THAT(in_reading, ElementsAre(MaskingState::off));
  EXPECT_EQ(monitor_.snapshot().masking, MaskingState::none);
}

// What counts the samples of a card that is not there may be late: nobody hears the difference.
TEST_F(WatchedSession, ContinuesWithoutASoundCardAndSaysThatNobodyHearsItsNoise) {
  play_sound();
  sound_.is_heard = false;
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> in_contact{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::contact) return;
    in_contact.insert(now.masking);
    sound_.is_running = false;
  };
  run();
  EXPECT_THAT(in_contact, ElementsAre(MaskingState::no_card));
  ASSERT_EQ(attempts().size(), 1U);
  EXPECT_TRUE(attempts()[0].valid);
}

TEST_F(WatchedSession, TakesNoiseFromElsewhereAsHeardOnceItIsAttested) {
  play_sound();
  sound_.is_heard = false;
  sound_.is_attested = true;
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> seen{};
  rig_->at_pass = [&] { seen.insert(monitor_.snapshot().masking); };
  run();
  EXPECT_THAT(seen, Contains(MaskingState::elsewhere));
  EXPECT_THAT(seen, testing::Not(Contains(MaskingState::no_card)));
}

TEST_F(WatchedSession, SaysNothingOfNoiseThatTheProtocolDoesNotWant) {
  play_sound();
  sound_.is_heard = false;
  begin(one_trial());
  std::set<MaskingState> seen{};
  rig_->at_pass = [&] { seen.insert(monitor_.snapshot().masking); };
  run();
  EXPECT_THAT(seen, ElementsAre(MaskingState::none));
}

TEST_F(WatchedSession, SaysThatTheNoiseCannotBeginWhereItNeverSounded) {
  play_sound();
  sound_.is_running = false;
  begin(one_trial(with_noise(small_protocol())));
  std::string said{};
  once_in(SessionPhase::paused, [&] {
    const SessionSnapshot now = monitor_.snapshot();
    said = now.trouble->what.english();
    EXPECT_EQ(now.masking, MaskingState::silent);
    sound_.is_running = true;
    requests_.resume();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(said, HasSubstr("cannot start"));
  EXPECT_TRUE(events_of("masking_noise_lost").empty());
  EXPECT_EQ(events_of("masking_noise_missing").size(), 1U);
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, PausesWhenTheNoiseStopsAndAsksTheTrialAgain) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  bool lost = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase == SessionPhase::contact && !lost) {
      lost = true;
      sound_.is_running = false;
    }
    if (now.phase == SessionPhase::paused && now.trouble) {
      EXPECT_EQ(now.trouble->remedy, SessionTrouble::Remedy::resume);
      EXPECT_THAT(now.trouble->what.english(), HasSubstr("masking noise"));
      EXPECT_TRUE(now.trouble->what.can_be_translated());
      EXPECT_EQ(rig_->loop().status().presentation, 0U);  // nothing is under the hand
      sound_.is_running = true;
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::aborted);
  EXPECT_EQ(rows[0].invalid_reason.value().text, "the masking noise stopped");
  EXPECT_TRUE(rows[1].valid);
  EXPECT_FALSE(monitor_.snapshot().trouble);
}

TEST_F(WatchedSession, PausesWhenTheNoiseStoppedAlsoIfItIsBackAtOnce) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  bool lost = false;
  bool paused = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    sound_.is_running = lost || now.phase != SessionPhase::contact;
    lost = lost || !sound_.is_running;
    if (now.phase == SessionPhase::paused) {
      paused = true;
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_TRUE(paused);
  EXPECT_EQ(events_of("masking_noise_lost").size(), 1U);
}

TEST_F(WatchedSession, EndsWhenTheNoiseStopsAndNobodyIsThere) {
  play_sound();
  links_.experimenter_is_there = false;
  begin(one_trial(with_noise(small_protocol())));
  once_in(SessionPhase::contact, [&] { sound_.is_running = false; });
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the masking noise stopped");
}

// --- the participant -----------------------------------------------------------------------------

/// The real rules of answering, in a session: the first answer comes while the hand lifts.
TEST_F(WatchedSession, RefusesAnAnswerBetweenTheLastSurfaceAndItsQuestion) {
  play_sound();
  begin(one_trial());
  PersonAtWindow person(monitor_, &loudspeakers_);
  const auto press = [&](ParticipantInput::Kind kind, int number = 0) {
    person.post({.kind = kind, .number = number, .time_ns = rig_->clock().now_ns()});
  };
  int lifts = 0;
  std::int64_t answered_scene_ns = -1;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    const int heard = sound_.count(Cue::next);
    if (now.scene->kind == ParticipantScene::Kind::feel && heard > lifts) {
      lifts = heard;
      press(ParticipantInput::Kind::option, 1);
    }
    const bool waits = now.scene->kind == ParticipantScene::Kind::text ||
                       now.scene->kind == ParticipantScene::Kind::question ||
                       now.scene->kind == ParticipantScene::Kind::form;
    if (!waits || now.scene->shown_ns == answered_scene_ns ||
        now.now_ns - now.scene->shown_ns < 300'000'000) {
      return;
    }
    answered_scene_ns = now.scene->shown_ns;
    if (now.scene->kind != ParticipantScene::Kind::text) press(ParticipantInput::Kind::option, 2);
    press(ParticipantInput::Kind::confirm);
  };
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person, {.links = links_});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_EQ(lifts, 2);
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  const AttemptRow row = attempts().front();
  std::vector<std::string> refusals{};
  for (const EventRow& event : row.events) {
    if (event.kind == "refused") refusals.push_back(event.text);
  }
  EXPECT_THAT(refusals,
              ElementsAre("Please feel surface B first.", "Please wait for the question."));
  EXPECT_EQ(row.responses.at(0).answer, row.presentations[1].item);
}

/// On the empty ground between two surfaces keys, clicks and buttons are refused alike.
TEST_F(WatchedSession, RefusesAnAnswerBetweenTwoSurfaces) {
  play_sound();
  begin(one_trial(small_protocol(R"(, "pause_between_surfaces_s": 0.5)")));
  PersonAtWindow person(monitor_, &loudspeakers_);
  const auto press = [&](ParticipantInput::Kind kind, int number = 0) {
    person.post({.kind = kind, .number = number, .time_ns = rig_->clock().now_ns()});
  };
  bool pressed = false;
  std::string cue{};
  std::int64_t answered_scene_ns = -1;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.scene->kind == ParticipantScene::Kind::blank && !now.scene->surfaces.empty()) {
      if (!pressed) {
        pressed = true;
        press(ParticipantInput::Kind::option, 1);
        press(ParticipantInput::Kind::click);
        press(ParticipantInput::Kind::next);  // they go on already
      }
      cue = now.scene->cue;
    }
    const bool waits = now.scene->kind == ParticipantScene::Kind::text ||
                       now.scene->kind == ParticipantScene::Kind::question ||
                       now.scene->kind == ParticipantScene::Kind::form;
    if (!waits || now.scene->shown_ns == answered_scene_ns ||
        now.now_ns - now.scene->shown_ns < 300'000'000) {
      return;
    }
    answered_scene_ns = now.scene->shown_ns;
    if (now.scene->kind != ParticipantScene::Kind::text) press(ParticipantInput::Kind::option, 2);
    press(ParticipantInput::Kind::confirm);
  };
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person, {.links = links_});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  EXPECT_EQ(cue, "Please feel surface B first.");
}

/// A person with more to say: enough of a surface, when an answer was given, buttons, a mask.
class TalkativeSession : public WatchedSession {
 protected:
  TalkativeSession() {
    person_.is_at_window = true;
    person_.at_ask = [this](const Wait& wait) -> Reply {
      const std::int64_t cue_ns = rig_->clock().now_ns();
      wait(0.5);
      person_.events.push_back({cue_ns + 150'000'000, "input", "option 1", "null"});
      return {only_answer(ChosenOption{0}), cue_ns + 200'000'000};
    };
    person_.at_form = [this](const Question& question, const Wait& wait) {
      person_.form_answered_ns = rig_->clock().now_ns() + 300'000'000;
      wait(0.5);
      return question.options.empty() ? FormAnswer{} : FormAnswer{question.options.front()};
    };
  }
};

TEST_F(TalkativeSession, LetsGoOfASurfaceOnceItWasFeltLongEnoughAndThePersonWantsSo) {
  begin(one_trial());
  person_.has_had_enough = true;
  run();
  const AttemptRow row = attempts().front();
  for (const PresentationRow& surface : row.presentations) {
    EXPECT_GE(surface.contact_s, 0.5);
    EXPECT_LT(surface.contact_s, 0.7);  // the hand needs 0.15 s to lift
  }
  EXPECT_FALSE(row.flagged);
}

TEST_F(TalkativeSession, TakesReactionTimesFromTheStampOfTheAnswer) {
  begin(one_trial());
  run();
  const AttemptRow row = attempts().front();
  const ResponseRow response = row.responses.at(0);
  EXPECT_NEAR(*response.from_cue_s, 0.2, 1e-9);  // `ask` itself took 0.5 s
  EXPECT_NEAR(static_cast<double>(row.offset_ns - response.time_ns) * 1e-9, 0.3, 1e-3);
  EXPECT_NEAR(*response.from_contact_s,
              static_cast<double>(response.time_ns - *row.presentations[0].contact_ns) * 1e-9,
              1e-9);
}

TEST_F(TalkativeSession, TakesTheTimeOfAQuestionnairesAnswerFromItsStamp) {
  begin(one_trial());
  run();
  const auto answers = study_->session_answers(session_.row.id);
  ASSERT_EQ(answers.size(), 2U);                   // the second one was left empty
  EXPECT_NEAR(*answers[0].from_cue_s, 0.3, 1e-9);  // it was heard after 0.5 s
}

TEST_F(TalkativeSession, StoresWhatThePersonDidWithTheAttempt) {
  begin(one_trial());
  person_.events.push_back({1, "input", "confirm", "null"});  // before the first attempt
  run();
  ASSERT_EQ(events_of("input").size(), 1U);
  EXPECT_EQ(events_of("input")[0].text, "confirm");
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) {
    kinds.push_back(event.kind == "phase" ? event.text : event.kind);
  }
  EXPECT_THAT(kinds, ElementsAre("fore", "contact", "fore", "contact", "response", "input"));
}

TEST_F(TalkativeSession, HandsOnTheButtonsOfTheDevice) {
  begin(one_trial());
  std::int64_t pressed_ns = 0;
  once_in(SessionPhase::response, [&] {
    pressed_ns = rig_->clock().now_ns();
    rig_->hand().press(2);
  });
  run();
  ASSERT_FALSE(person_.buttons.empty());
  EXPECT_EQ(person_.buttons[0].button, 2);
  EXPECT_TRUE(person_.buttons[0].down);
  EXPECT_EQ(person_.buttons[0].time_ns, pressed_ns + 1'000'000);  // the next tick
}

TEST_F(TalkativeSession, HasTheMaskOnWhileFeelingAndOffToLookAtPictures) {
  std::string text = with(practised_protocol("continue_flagged"), "\"textures\"",
                          R"("environment": {"vision": "blindfold"}, )");
  for (std::size_t at = text.find("\"pictures\""); at != std::string::npos;
       at = text.find("\"pictures\"", at + 80)) {
    text.insert(at, R"("pictures_after_feeling": true, "allow_revisit": false, )");
  }
  begin(with(text, R"({"run": "practice"})", R"({"screen": "Welcome."}, )"));
  run();
  ASSERT_GT(person_.calls.size(), 8U);
  person_.calls.resize(8);
  EXPECT_THAT(person_.calls, ElementsAre("read", "mask on", "surface 1", "mask off", "ask", "tell",
                                         "mask on", "surface 1"));
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) kinds.push_back(event.kind);
  EXPECT_THAT(kinds, testing::IsSupersetOf({"mask_on", "mask_off"}));
}

TEST_F(TalkativeSession, LeavesNobodyBehindTheMask) {
  std::string text =
      with(one_trial(), "\"textures\"", R"("environment": {"vision": "blindfold"}, )");
  text.replace(text.find("\"photograph\""), 12, "\"memory\"");
  const std::string ending = R"(, {"ask": ["comfort", "remarks"]}, {"screen": "Thank you."})";
  text.erase(text.find(ending), ending.size());  // nothing else takes it off
  begin(text);
  run();
  ASSERT_FALSE(person_.calls.empty());
  EXPECT_EQ(person_.calls.back(), "mask off");
}

TEST_F(TalkativeSession, HasTheExperimenterConfirmWhatOnlyTheyAreToDo) {
  begin(with(one_trial(), "\"name\": \"best\"",
             R"("experimenter_prompt": "Place sample {code}.", )"));
  std::string asked{};
  ParticipantScene seen{};
  int looks = 0;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (!now.trouble || now.trouble->remedy != SessionTrouble::Remedy::confirm) return;
    asked = now.trouble->what.english();
    seen = *now.scene;
    EXPECT_EQ(rig_->loop().status().presentation, 0U);  // nothing is rendered
    if (++looks == 10) requests_.confirm();
  };
  requests_.confirm();  // before anybody asked: means nothing
  run();
  EXPECT_GE(looks, 10);
  EXPECT_THAT(asked, testing::StartsWith("Place sample "));
  EXPECT_EQ(seen.kind, ParticipantScene::Kind::blank);
  EXPECT_EQ(seen.text, "");
  // The participant reads the two screens of the flow and nothing else.
  EXPECT_EQ(std::count(person_.calls.begin(), person_.calls.end(), "read"), 2);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) kinds.push_back(event.kind);
  EXPECT_THAT(kinds, Contains("experimenter_ready"));
}

TEST_F(TalkativeSession, AsksNobodyToPutOnAMaskWhereTheProtocolDoesNot) {
  begin(one_trial());
  run();
  EXPECT_THAT(person_.calls, testing::Not(Contains("mask on")));
}

// --- the other hand ------------------------------------------------------------------------------

TEST_F(WatchedSession, MirrorsThePlaceAndTheStrokesForALeftHand) {
  std::string text = one_trial(small_protocol("", R"(, "direction_rad": 0.5,
    "strokes": {"target": 3})"));
  begin(with(text, "\"textures\"", R"("surface": {"centre_m": [0.02, 0.01, 0]}, )"));
  session_.row.mirrored = true;
  run();
  EXPECT_TRUE(monitor_.facts()->mirrored);
  const AttemptRow row = attempts().front();
  const auto records = records_of(read_recording(study_->folder() / row.recording->path));
  double sum_x_m = 0.0;
  double sum_y_m = 0.0;
  double covariance = 0.0;
  std::size_t count = 0;
  for (const TickRecord& record : records) {
    if (record.penetration_m <= 0.0 || record.presentation != 1) continue;
    sum_x_m += record.probe.position_m.x;
    sum_y_m += record.probe.position_m.y;
    covariance += record.probe.velocity_m_per_s.x * record.probe.velocity_m_per_s.y;
    ++count;
  }
  ASSERT_GT(count, 0U);
  EXPECT_NEAR(sum_x_m / static_cast<double>(count), -0.02, 0.012);
  EXPECT_NEAR(sum_y_m / static_cast<double>(count), 0.01, 0.012);
  EXPECT_LT(covariance, 0.0);  // to the left means away from the body
  // The strokes are counted along the mirrored direction.
  for (const ComplianceRow& compliance : row.compliance) {
    if (compliance.quantity == "stroke_length_m") {
      EXPECT_NEAR(compliance.p95, 0.06, 0.01);  // the first and the last are cut short
    }
  }
}

// --- threads -------------------------------------------------------------------------------------

TEST(WatchedFromAnotherThread, ARealTimeSessionIsSteeredAndEnds) {
  const TemporaryFolder folder{};
  make_small_study(folder.path() / "study");
  const ModelRegistry models = built_in_models();
  std::string text =
      small_protocol(R"(, "pause_before_trial_s": 0, "pause_between_surfaces_s": 0)");
  text.replace(text.find("\"minimum_contact_s\": 0.5"), 24, "\"minimum_contact_s\": 0.1");
  text.replace(text.find("[1, 2, 3]"), 9, "[1, 2]");
  const Protocol protocol = read_small_protocol(
      models,
      with(text, "\"realism_standard\"",
           R"("device": {"maximum_missed_deadlines": 100000, "maximum_gaps_in_contact": 100000,
                                 "maximum_lost_records": 100000}, )"));
  Study study = Study::open(folder.path() / "study", Access::read_write);
  study.add_participant({.label = "p1", .created_utc = "2026-01-01T00:00:00.000Z"});
  StimulusBuilder builder(models, folder.path() / "study");
  RigSettings settings{};
  settings.servo = patient_servo();
  RealTimeRig rig(settings, HandHabits{}, Random(1), Scheduling::normal, 0);
  SessionConditions conditions{};
  conditions.pacing = rig.pacing();
  conditions.started_utc = rig.clock().utc();
  conditions.device = rig.capability();
  OpenSession session = begin_session(study, protocol, "p1", conditions, this_program());
  const std::int64_t id = session.row.id;
  ScriptedPerson person{};
  SessionMonitor monitor{};
  SessionRequests requests{};
  Conductor conductor(
      study, protocol, builder, rig, person,
      {.links = {.requests = &requests, .monitor = &monitor, .experimenter_is_there = true}});
  std::atomic<bool> over{false};
  SessionEnd end{};
  {
    std::jthread running([&] {
      end = conductor.run(std::move(session));
      over = true;
    });
    bool stopped = false;
    bool paused = false;
    bool noted = false;
    std::uint64_t bins_seen = 0;
    while (!over) {
      const SessionSnapshot now = monitor.snapshot();
      std::vector<LiveBin> bins{};
      bins_seen = monitor.bins_from(bins_seen, bins);
      if (now.phase == SessionPhase::contact && !stopped) {
        stopped = true;
        requests.emergency_stop();
      }
      if (now.phase == SessionPhase::fault) requests.clear_fault();
      if (now.trials_done == 1 && !paused) {
        paused = true;
        requests.pause();
      }
      if (now.phase == SessionPhase::paused) {
        if (!noted) requests.note("from another thread");
        noted = true;
        requests.resume();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_GT(bins_seen, 0U);
  }
  EXPECT_EQ(end.state, SessionState::completed) << end.reason.english();
  int valid = 0;
  int faults = 0;
  for (const AttemptRow& attempt : study.attempts(id)) {
    if (attempt.valid) ++valid;
    if (attempt.outcome == AttemptOutcome::emergency_stop) ++faults;
  }
  EXPECT_EQ(valid, 2);
  EXPECT_GE(faults, 1);
}

}  // namespace
}  // namespace asperity
