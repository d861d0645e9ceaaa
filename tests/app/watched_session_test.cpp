// A session that is watched from outside: its phases, its scenes, its progress, the other hand, another thread.

#include "tests/app/watched_session.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/rig/recording_columns.h"
#include "renderers/built_in_models.h"
#include "tests/support/patient_servo.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;

TEST_F(WatchedSession, StoresEveryChangeOfPhaseInOrder) {
  begin(one_trial());
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(phases(), ElementsAre("ready", "iti", "fore", "contact", "fore", "contact",
                                    "response", "questions", "ready", "ended"));
  EXPECT_EQ(monitor_.snapshot().phase, SessionPhase::ended);
}

class ShownObject : public WatchedSession {
 protected:
  /// The slices in which a surface was felt, by whether the object was shown.
  std::map<bool, int> slices_of_contact(const std::string& protocol) {
    std::map<bool, int> slices{};
    begin(protocol);
    rig_->at_pass = [&] {
      const SessionSnapshot snapshot = monitor_.snapshot();
      if (snapshot.phase == SessionPhase::contact) ++slices[snapshot.scene->show_workspace];
    };
    run();
    return slices;
  }
};

TEST_F(ShownObject, IsSeenWhileItIsFeltWhereTheProtocolHasAScene) {
  const std::map<bool, int> slices = slices_of_contact(
      with(one_trial(), "\"textures\"", R"("environment": {"scene": {"visual_texture": "on"}}, )"));
  EXPECT_GT(slices.at(true), 20);
  EXPECT_FALSE(slices.contains(false));
}

TEST_F(ShownObject, IsNotSeenOtherwise) {
  const std::map<bool, int> slices = slices_of_contact(one_trial());
  EXPECT_GT(slices.at(false), 20);
  EXPECT_FALSE(slices.contains(true));
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
    EXPECT_EQ(now.scene->text_message.what,
              is_over ? ParticipantMessage::What::lift : ParticipantMessage::What::feel_surface);
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
