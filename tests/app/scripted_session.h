// A session for a test: the real loop and store, a person and a rig that do what the test says.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/conductor.h"
#include "app/study_files/program.h"
#include "renderers/built_in_models.h"
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

  SessionEnd run() {
    conductor_ = std::make_unique<Conductor>(
        *study_, protocol_, *builder_, *rig_, person_,
        ConductorSettings{.record = true,
                          .done = [this](const AttemptDone& done) { done_.push_back(done); },
                          .links = links_});
    return conductor_->run(session_);
  }

  std::vector<AttemptRow> attempts() const { return study_->attempts(session_.row.id); }

  std::vector<std::string> stored_plan() const {
    std::vector<std::string> plan{};
    for (const PlannedTrialRow& row : study_->plan(session_.row.id)) plan.push_back(row.plan_json);
    return plan;
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
    session_ = begin_session(*study_, protocol_, participant, conditions, this_program());
  }
};

}  // namespace asperity
