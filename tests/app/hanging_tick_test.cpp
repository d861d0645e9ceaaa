// A session in real time with a force model that does not return from a tick.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/run_session.h"
#include "app/words/coded_phrases.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/support/eventually.h"
#include "tests/support/hanging_push.h"
#include "tests/support/patient_servo.h"
#include "tests/support/scripted_device.h"
#include "tests/support/scripted_person.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// What happened, in order, and when.
class EventLog final {
 public:
  void note(const std::string& what) {
    const std::lock_guard lock(mutex_);
    const auto same = [&what](const auto& event) { return event.first == what; };
    if (std::any_of(events_.begin(), events_.end(), same)) return;  // the first of each
    events_.emplace_back(what, std::chrono::steady_clock::now());
  }
  std::vector<std::string> names() const {
    const std::lock_guard lock(mutex_);
    std::vector<std::string> names{};
    for (const auto& [name, time] : events_) names.push_back(name);
    return names;
  }
  std::chrono::steady_clock::duration between(std::size_t first, std::size_t last) const {
    const std::lock_guard lock(mutex_);
    return events_.at(last).second - events_.at(first).second;
  }

 private:
  mutable std::mutex mutex_{};
  std::vector<std::pair<std::string, std::chrono::steady_clock::time_point>> events_{};
};

/// Called in each tick of a model, wherever it is computed; the tick does not return before it does.
using AtTick = std::function<void()>;

class WatchedModel final : public ForceRenderer {
 public:
  WatchedModel(std::unique_ptr<ForceRenderer> inner, AtTick at_tick)
      : inner_(std::move(inner)), at_tick_(std::move(at_tick)) {}
  void reset(const ProbeState& first) noexcept override { inner_->reset(first); }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    at_tick_();
    return inner_->tick(probe, dt_s);
  }

 private:
  std::unique_ptr<ForceRenderer> inner_;
  AtTick at_tick_;
};

ModelRegistry models_with(const AtTick& at_tick) {
  ModelRegistry models = built_in_models();
  ForceModel model = *models.find("height_map");
  model.make = [make = model.make, at_tick](const RendererInputs& inputs) {
    return std::make_unique<WatchedModel>(make(inputs), at_tick);
  };
  models.replace(std::move(model));
  return models;
}

/// Two trials of two contacts, whatever a busy machine does to their timing.
std::string hanging_protocol() {
  std::string text =
      small_protocol(R"(, "pause_before_trial_s": 0, "pause_between_surfaces_s": 0)");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"minimum_contact_s\": 0.5", "\"minimum_contact_s\": 0.2");
  replace("[1, 2, 3]", "[1, 2]");
  replace("\"realism_standard\"",
          "\"device\": {\"maximum_missed_deadlines\": 100000, \"maximum_gaps_in_contact\": 100000, "
          "\"maximum_lost_records\": 100000},"
          "\"realism_standard\"");
  return text;
}

class HangingTick : public testing::Test {
 protected:
  HangingTick() {
    inputs_.study = folder_.path() / "study";
    make_small_study(inputs_.study);
    inputs_.protocol = inputs_.study / "protocols" / "small.json";
    write_file(inputs_.protocol, hanging_protocol(), Overwrite::refuse);
    inputs_.participant = "p1";
    inputs_.mode = SessionMode::pilot;
    inputs_.seed = 5;
    inputs_.pacing = RunPacing::real_time;
    inputs_.device = "swinging";
    // A busy machine may keep the loop from running for a while; a second is allowed in all.
    inputs_.servo = patient_servo();
    inputs_.servo.standstill_to_fault_s = 0.4;
    drivers_.add({.id = "swinging",
                  .open = [this](const std::string&, const DriverOptions&) { return device(); }});
    links_.tell = [this](const std::string& line) {
      if (line.find("The servo loop stalled") != std::string::npos) log_.note("told");
    };
  }
  /// The device that is left to the tick goes when that returns.
  ~HangingTick() override {
    hang_->is_wanted = false;
    EXPECT_TRUE(eventually([this] { return opened_ == closed_; }));
  }

  /// Swings through the surface by itself. Once it has exerted a force, the ticks do not return where they are to hang.
  std::unique_ptr<HapticDevice> device() {
    ++opened_;
    auto device =
        std::make_unique<ScriptedDevice>(DeviceCapability{.name = "swinging", .peak_force_N = 6.0});
    device->at_read = [](ProbeState& state) {
      const double turn = 2.0 * std::numbers::pi * 1e-9 * static_cast<double>(state.time_ns);
      state.position_m = {0.010 * std::sin(turn), 0.0, 0.002 * std::sin(1.3 * turn)};
      state.velocity_m_per_s = {0.010 * 2.0 * std::numbers::pi * std::cos(turn), 0.0, 0.0};
    };
    device->at_send = [this](const Wrench& wrench) {
      loop_ = std::this_thread::get_id();
      exerts_ = glm::length(wrench.force_N) >= 0.1;
    };
    device->at_zero_from_outside = [this] { log_.note("zero"); };
    device->at_close = [this] { ++closed_; };
    return device;
  }

  /// In the servo loop only: a replay of the model is no tick that exerts a force.
  void at_tick() {
    if (std::this_thread::get_id() != loop_) return;
    if (exerts_ && may_hang_.exchange(false)) {
      log_.note("hangs with force");
      hang_->is_wanted = true;
    }
    hang_->pass();
  }

  SessionEnd run() {
    return run_session(
        inputs_, models_, &person_, {},
        [this](const AttemptDone& done) {
          if (!done.counts) log_.note("stored");
        },
        links_, drivers_);
  }
  std::vector<AttemptRow> attempts() const {
    const Study study = Study::open(inputs_.study, Access::read_only);
    return study.attempts(study.sessions().at(0).id);
  }

  EventLog log_{};
  std::atomic<int> opened_{0};
  std::atomic<int> closed_{0};
  std::atomic<bool> may_hang_{true};
  std::shared_ptr<Hang> hang_ = std::make_shared<Hang>();
  TemporaryFolder folder_{};
  RunInputs inputs_{};
  DriverRegistry drivers_{};
  std::atomic<std::thread::id> loop_{};
  std::atomic<bool> exerts_{false};
  ModelRegistry models_ = models_with([this] { at_tick(); });
  ScriptedPerson person_{{.reading_s = 0.0, .answering_s = 0.05}};
  SessionLinks links_{};
};

TEST_F(HangingTick, LosesItsForceIsToldAndStoredAndTheSessionCanBeResumed) {
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(),
              HasSubstr("a tick of the force model height_map did not return"));
  EXPECT_THAT(end.reason.english(), HasSubstr("end this program and start it again"));
  ASSERT_THAT(log_.names(), ElementsAre("hangs with force", "zero", "told", "stored"));
  EXPECT_LT(log_.between(0, 1), std::chrono::seconds(1));
  EXPECT_LT(log_.between(0, 2), std::chrono::seconds(1));
  {
    const std::vector<AttemptRow> made = attempts();
    ASSERT_FALSE(made.empty());
    const AttemptRow& failed = made.back();
    EXPECT_FALSE(failed.valid);
    EXPECT_EQ(failed.outcome, AttemptOutcome::device_fault);
    EXPECT_EQ(failed.servo->fault, "standstill");
    EXPECT_THAT(codes_of(failed.invalid_reason.value()), HasSubstr("model_does_not_return"));
    ASSERT_TRUE(failed.recording.has_value());
    const Study study = Study::open(inputs_.study, Access::read_only);
    EXPECT_EQ(study.sessions().at(0).state, SessionState::stopped);
  }

  hang_->is_wanted = false;
  inputs_.resume = true;
  const SessionEnd resumed = run();
  EXPECT_EQ(resumed.state, SessionState::completed) << resumed.reason.english();
  const std::vector<AttemptRow> all = attempts();
  EXPECT_EQ(
      std::count_if(all.begin(), all.end(), [](const AttemptRow& each) { return each.valid; }), 2);
}

// With an experimenter, the session waits and states what to do, and no request clears the fault.
TEST_F(HangingTick, IsWaitedOutByTheExperimenterWhoCanOnlyEndTheSession) {
  links_.experimenter_is_there = true;
  int asked = 0;
  person_.at_fault = [this, &asked] {
    constexpr int kClearedInVain = 2;
    log_.note("informed");  // the request was shown before
    return ++asked <= kClearedInVain ? Respondent::AfterFault::go_on : Respondent::AfterFault::end;
  };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  ASSERT_THAT(log_.names(), ElementsAre("hangs with force", "zero", "told", "stored", "informed"))
      << testing::PrintToString(person_.faults_heard);
  EXPECT_LT(log_.between(0, 4), std::chrono::seconds(1));
  ASSERT_GE(person_.faults_heard.size(), 2U);
  EXPECT_THAT(person_.faults_heard.front(), HasSubstr("end this program and start it again"));
  EXPECT_THAT(person_.faults_heard.back(), HasSubstr("The device is not ready yet"));
  EXPECT_EQ(attempts().back().servo->fault, "standstill");
}

}  // namespace
}  // namespace asperity
