// A session for a test: the real loop and store, a person and a rig that do what the test says.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/conductor.h"
#include "app/study_files/program.h"
#include "app/tasks/unfinished_session.h"
#include "renderers/built_in_models.h"
#include "results_schema/sqlite.h"
#include "tests/app/small_study.h"
#include "tests/support/scripted_person.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

/// Does something in each slice of time that goes by.
class WatchedRig final : public Rig {
 public:
  WatchedRig(const RigSettings& settings, std::int64_t session_index)
      : rig_(settings, session_index) {}
  std::function<void()> at_pass{};
  /// Another hand than the one that does what the protocol asks for.
  std::function<void(HandHabits&)> at_prepare{};
  std::string complains{};

  std::string complaint() const override { return complains; }
  const Clock& clock() const noexcept override { return rig_.clock(); }
  ServoLoop& loop() noexcept override { return rig_.loop(); }
  RecordRing& records() noexcept override { return rig_.records(); }
  VirtualHand& hand() noexcept override { return rig_.hand(); }
  const DeviceCapability& capability() const noexcept override { return rig_.capability(); }
  const ForceLimits& limits() const noexcept override { return rig_.limits(); }
  std::string pacing() const override { return rig_.pacing(); }
  std::string scheduling() const override { return rig_.scheduling(); }
  void prepare_attempt(const HandHabits& habits, const Random& random) override {
    HandHabits own = habits;
    if (at_prepare) at_prepare(own);
    rig_.prepare_attempt(own, random);
  }
  void pass(double duration_s, Recorder& recorder) override {
    rig_.pass(duration_s, recorder);
    // What a test waits for may never come; a session in simulated time would wait for it at full speed, without an end.
    if ((passed_s_ += duration_s) > kLongest_s) {
      throw std::runtime_error("The session has lasted ten minutes of simulated time.");
    }
    if (at_pass) at_pass();
  }
  void emergency_stop() noexcept override { rig_.emergency_stop(); }
  void clear_fault(Fault seen) noexcept override { rig_.clear_fault(seen); }
  void move_clock_to(std::int64_t now_ns) { rig_.move_clock_to(now_ns); }

 private:
  static constexpr double kLongest_s = 600.0;
  SteppedRig rig_;
  double passed_s_ = 0.0;
};

/// A recognition whose practice asks for three right answers in a row, of five trials at most.
inline std::string practised_protocol(const std::string& on_failure) {
  return R"({
  "format": "asperity.protocol/1", "kind": "recognition", "design": "improved",
  "name": "practised", "version": "1.0.0", "title": "With practice",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "textures": {"grain": {"height_field": "stimuli/grain.png", "picture": "stimuli/grain_photo.png"},
               "other": {"picture": "stimuli/grain_photo.png"}},
  "factors": {"texture": {"levels": ["grain"]}},
  "stimuli": {"rendered": {"model": "height_map", "texture": {"factor": "texture"}}},
  "explorations": {"short": {"minimum_contact_s": 0.3, "maximum_contact_s": 2}},
  "blocks": {
    "practice": {
      "phase": "practice", "crossed": ["texture"], "repetitions": 5,
      "presented": [{"stimulus": "rendered"}],
      "question": {"name": "which", "prompt": "Which was it?", "pictures": ["grain", "other"],
                   "correct_factor": "texture"},
      "exploration": "short", "feedback": "correctness",
      "until": {"correct": 3, "of_last": 3, "maximum_trials": 5, "on_failure": ")" +
         on_failure + R"("}},
    "main": {
      "crossed": ["texture"], "presented": [{"stimulus": "rendered"}],
      "question": {"name": "which", "prompt": "Which was it?", "pictures": ["grain", "other"],
                   "correct_factor": "texture"},
      "exploration": "short"}
  },
  "flow": [{"run": "practice"}, {"run": "main"}]
})";
}

/// Numbers for three spacings under two conditions, twice each, after an anchor.
inline std::string estimated_protocol() {
  return R"({
  "format": "asperity.protocol/1", "kind": "magnitude", "design": "improved",
  "name": "estimated", "version": "1.0.0", "title": "How rough",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "estimation": {"spacing": "spacing", "condition": "tip"},
  "textures": {"grain": {"height_field": "stimuli/grain.png"}},
  "factors": {"spacing": {"levels": [0.001, 0.002, 0.004]}, "tip": {"levels": ["small", "large"]}},
  "stimuli": {"rendered": {"model": "height_map", "texture": "grain"}},
  "explorations": {"short": {"minimum_contact_s": 0.2, "maximum_contact_s": 2}},
  "blocks": {
    "main": {
      "crossed": ["spacing"], "repetitions": 2, "anchor": {"spacing": 0.002},
      "presented": [{"stimulus": "rendered"}],
      "question": {"name": "roughness", "prompt": "How rough was it?"},
      "exploration": "short"}
  },
  "counterbalance": "latin",
  "flow": [{"run": "main", "for_each": "tip"}]
})";
}

class SessionTest : public testing::Test {
 protected:
  void begin(const std::string& text, const std::vector<ScriptedFault>& faults = {}) {
    make_small_study(folder_.path() / "study");
    protocol_ = read_small_protocol(models_, text);
    study_.emplace(Study::open(folder_.path() / "study", Access::read_write));
    study_->add_participant({.label = "p1", .created_utc = "2026-01-01T00:00:00.000Z"});
    builder_ = std::make_unique<StimulusBuilder>(models_, folder_.path() / "study");
    make_rig(faults);
    begin_session_of("p1", 7);
  }

  /// Another session of this protocol, of a new participant.
  void start(const std::string& participant, std::uint64_t seed) {
    study_->add_participant({.label = participant, .created_utc = "2026-01-01T00:00:00.000Z"});
    make_rig({});
    begin_session_of(participant, seed);
    done_.clear();
  }

  void make_rig(const std::vector<ScriptedFault>& faults) {
    RigSettings settings{};
    settings.device.faults = faults;
    rig_ = std::make_unique<WatchedRig>(settings, 0);
  }

  static constexpr int kToItsEnd = 1000;

  SessionEnd run() { return conduct({.record = true}); }

  /// Runs the session with these settings, and stops it after this number of attempts in this run.
  SessionEnd conduct(ConductorSettings settings, int most = kToItsEnd) {
    settings.links = links_;
    settings.done = [this, made = 0, most](const AttemptDone& done) mutable {
      done_.push_back(done);
      if (++made == most) conductor_->requests().stop_after(StopAfter::trial);
    };
    conductor_ =
        std::make_unique<Conductor>(*study_, protocol_, *builder_, *rig_, person_, settings);
    return conductor_->run(session_);
  }

  std::vector<AttemptRow> attempts() const { return study_->attempts(session_.row.id); }

  std::vector<std::string> stored_plan() const {
    std::vector<std::string> plan{};
    for (const PlannedTrialRow& row : study_->plan(session_.row.id)) plan.push_back(row.plan_json);
    return plan;
  }

  SessionRow stored_session() const { return study_->session(session_.row.id); }

  /// Made again from the stored responses.
  Plan verified_plan() const { return plan_of(*study_, stored_session(), models_); }

  /// The interrupted session, with a new rig.
  void reopen_session() {
    make_rig({});
    rig_->move_clock_to(last_time_ns(*study_, stored_session()));
    session_ = reopen(*study_, protocol_, stored_session());
  }

  TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
  Protocol protocol_{};
  std::optional<Study> study_{};
  std::unique_ptr<StimulusBuilder> builder_{};
  std::unique_ptr<WatchedRig> rig_{};
  ScriptedPerson person_{};
  std::unique_ptr<Conductor> conductor_{};
  OpenSession session_{};
  std::vector<AttemptDone> done_{};
  SessionLinks links_{};

 private:
  void begin_session_of(const std::string& participant, std::uint64_t seed) {
    SessionConditions conditions{};
    conditions.seed = seed;
    conditions.pacing = rig_->pacing();
    conditions.started_utc = rig_->clock().utc();
    conditions.device = rig_->capability();
    conditions.limits = rig_->limits();
    session_ = begin_session(*study_, protocol_, participant, conditions, this_program());
  }
};

/// Sessions that a test stops after a number of attempts and resumes, each of a new participant.
class ResumableSession : public SessionTest {
 protected:
  /// A new session, in which the participant replies as `reply_to` determines.
  void start(std::uint64_t seed) {
    SessionTest::start("p" + std::to_string(++participants_), seed);
    person_.at_question = [this, seed](int, const Trial& trial) { return reply_to(trial, seed); };
  }

  /// A trial has the same reply in every session of this seed.
  virtual Reply reply_to(const Trial& trial, std::uint64_t seed) const {
    Random random = Random(seed).split("answers").split(static_cast<std::uint64_t>(trial.ordinal));
    return reply_that_is(trial, random.uniform() < proportion_correct_);
  }

  virtual ConductorSettings settings() const { return {.record = false}; }

  SessionEnd run_attempts(int most = kToItsEnd) { return conduct(settings(), most); }

  SessionEnd resume(int most = kToItsEnd) {
    reopen_session();
    person_.texts.clear();
    done_.clear();
    return run_attempts(most);
  }

  /// The plan of a session that was not interrupted.
  std::vector<std::string> uninterrupted(std::uint64_t seed) {
    start(seed);
    EXPECT_EQ(run_attempts().state, SessionState::completed);
    return stored_plan();
  }

  /// Completes the session that was started, with an interruption after every attempt.
  void interrupt_after_every_attempt() {
    SessionEnd end = run_attempts(1);
    for (int i = 0; i < kToItsEnd && end.state == SessionState::stopped; ++i) {
      EXPECT_EQ(verified_trials(), stored_plan().size());
      end = resume(1);
    }
    EXPECT_EQ(end.state, SessionState::completed);
  }

  /// Sessions that are interrupted after every attempt, and once after the first, the middle or the last but one, have the
  /// plan of an uninterrupted one, which is returned.
  std::vector<std::string> same_plan_after_interruptions(std::uint64_t seed) {
    const std::vector<std::string> expected = uninterrupted(seed);
    start(seed);
    interrupt_after_every_attempt();
    EXPECT_EQ(stored_plan(), expected);
    const int attempts = static_cast<int>(expected.size());
    for (const int position : {1, attempts / 2, attempts - 1}) {
      SCOPED_TRACE("after " + std::to_string(position));
      start(seed);
      EXPECT_EQ(run_attempts(position).state, SessionState::stopped);
      EXPECT_EQ(verified_trials(), stored_plan().size());
      EXPECT_EQ(resume().state, SessionState::completed);
      EXPECT_EQ(stored_plan(), expected);
      EXPECT_EQ(verified_trials(), expected.size());
    }
    return expected;
  }

  std::size_t verified_trials() const { return verified_plan().trials.size(); }

  void change_store(const std::string& statements) {
    const std::filesystem::path folder = folder_.path() / "study";
    Database database(folder, folder / "study.sqlite", Database::Mode::read_write);
    database.execute(statements);
  }
  /// The condition of SQL for rows of the session.
  std::string of_session() const { return " session_id = " + std::to_string(session_.row.id); }

  double proportion_correct_ = 0.8;

 private:
  int participants_ = 1;
};

}  // namespace asperity
