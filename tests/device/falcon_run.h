// A servo loop on an emulated Falcon that is unplugged now and then, in real time or step by step.

#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "device/falcon/falcon_device.h"
#include "device/haptic_device.h"
#include "device/monotonic_clock.h"
#include "renderers/servo/servo_thread.h"
#include "tests/device/emulated_falcon.h"
#include "tests/support/eventually.h"
#include "tests/support/patient_servo.h"
#include "tests/support/steady_push.h"

namespace asperity {

/// What a run's records said, read while it goes on.
class RunWatch final {
 public:
  explicit RunWatch(RecordRing& ring) : ring_(ring) {}

  void drain() {
    TickRecord record;
    while (ring_.pop(record)) {
      ++ticks;
      EXPECT_GT(record.probe.time_ns, last_.probe.time_ns);
      EXPECT_LT(glm::length(record.probe.position_m), 0.1);  // nor is it no number
      if (record.has(TickFlag::fault_latched)) {
        ++faulty;
        EXPECT_EQ(record.sent.force_N, glm::dvec3(0.0));
      }
      if (record.has(TickFlag::device_lost) && !last_.has(TickFlag::device_lost)) ++losses;
      // What comes first after a fault begins at nothing.
      if (last_.has(TickFlag::fault_latched) && !record.has(TickFlag::fault_latched)) {
        EXPECT_LT(glm::length(record.sent.force_N), 0.1 * SteadyPush::kForce_N);
      }
      last_ = record;
    }
  }
  bool is_felt() const { return last_.sent.force_N.z == SteadyPush::kForce_N; }
  bool answers() const { return !last_.has(TickFlag::device_lost); }

  std::uint64_t ticks = 0;
  std::uint64_t faulty = 0;
  int losses = 0;

 private:
  RecordRing& ring_;
  TickRecord last_{};
};

/// A Falcon, its driver and the loop on it, which the caller ticks.
class FalconRun final {
 public:
  FalconRun(EmulatedBus& bus, const EmulatedFalconSettings& falcon, double rate_Hz,
            std::function<std::int64_t()> clock)
      : clock_(std::move(clock)),
        emulated_(bus, falcon),
        device_(FalconDevice::open(settings_with(clock_))),
        loop_(std::make_unique<ServoLoop>(*device_, ring_, patient_at(rate_Hz))) {
    emulated_.circle(0.015);
    loop_->present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  }

  EmulatedFalcon& emulated() noexcept { return emulated_; }
  FalconDevice& device() noexcept { return *device_; }
  ServoLoop& loop() noexcept { return *loop_; }
  bool answers() const { return watch_.answers(); }

  /// Runs for `duration`, unplugs the device `unplugs` times at even intervals and plugs it in again, and expects after
  /// each that nothing was pushed and that it goes on. `pass` lets a little time go by, with its ticks.
  void unplug_now_and_then(std::chrono::nanoseconds duration, int unplugs,
                           const std::function<void()>& pass) {
    const std::int64_t began_ns = clock_();
    for (int i = 1; i <= unplugs + 1; ++i) {
      const std::int64_t until_ns = began_ns + duration.count() * i / (unplugs + 1);
      while (clock_() < until_ns) {
        ASSERT_TRUE(goes_on(pass));
        pass();
      }
      if (i > unplugs) break;
      const int losses = watch_.losses;
      emulated_.unplug();
      ASSERT_TRUE(reaches([&] { return watch_.losses > losses; }, pass));
      EXPECT_EQ(loop_->status().fault, Fault::device_lost);
      emulated_.plug_in();
      ASSERT_TRUE(reaches([&] { return watch_.answers(); }, pass));
      // It answers, and until the fault is lifted it gets no force.
      EXPECT_EQ(emulated_.take_strongest_word(), 0);
      EXPECT_EQ(loop_->status().fault, Fault::device_lost);
      ASSERT_TRUE(goes_on(pass));
      EXPECT_TRUE(reaches([&] { return emulated_.take_strongest_word() > 0; }, pass));
    }
  }

  /// After the last tick: ends the run, expects that none of its records was lost, and returns how often the device was.
  int end() {
    watch_.drain();
    EXPECT_EQ(watch_.ticks, loop_->status().ticks);
    EXPECT_EQ(ring_.lost(), 0U);
    loop_.reset();
    device_.reset();
    EXPECT_EQ(emulated_.motor_words(), (std::array<std::int16_t, 3>{}));
    return watch_.losses;
  }

 private:
  static ServoSettings patient_at(double rate_Hz) {
    ServoSettings settings = patient_servo();
    settings.rate_Hz = rate_Hz;
    return settings;
  }
  static FalconSettings settings_with(const std::function<std::int64_t()>& clock) {
    FalconSettings settings{};
    settings.line.place = "usb 1-2";
    settings.line.wants_fifo = false;  // the test bed's other end has to get its turn too
    settings.line.clock = clock;
    return settings;
  }
  template <typename Condition>
  bool reaches(const Condition& condition, const std::function<void()>& pass) {
    const auto until = std::chrono::steady_clock::now() + kPatience;
    for (watch_.drain(); !condition(); watch_.drain()) {
      if (std::chrono::steady_clock::now() > until) return false;
      pass();
    }
    return true;
  }
  // A busy machine may keep the emulated device from answering at any time: that is a loss like another, and lifted
  // as a person would lift it.
  bool goes_on(const std::function<void()>& pass) {
    return reaches(
        [&] {
          if (loop_->status().fault != Fault::none && watch_.answers())
            loop_->clear_fault(loop_->status().fault);
          return watch_.is_felt();
        },
        pass);
  }

  std::function<std::int64_t()> clock_{};
  EmulatedFalcon emulated_;
  std::unique_ptr<FalconDevice> device_;
  RecordRing ring_{32768};
  RunWatch watch_{ring_};
  std::unique_ptr<ServoLoop> loop_;
};

/// On a servo thread and the machine's clock.
inline void run_in_real_time(EmulatedBus& bus, std::chrono::nanoseconds duration, int unplugs) {
  FalconRun run(bus, {}, 1000.0, monotonic_now_ns);
  {
    const ServoThread thread(run.loop(), run.device(), Scheduling::normal);
    run.unplug_now_and_then(duration, unplugs,
                            [] { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
  }
  EXPECT_GE(run.end(), unplugs);  // a busy machine may be one more loss
}

/// A step of a clock that a test moves. The first reading of a device that was plugged in may be two steps old, which is
/// no silence.
inline constexpr std::int64_t kStep_ns = 24'000'000;
static_assert(2 * kStep_ns < HapticDevice::kLongestSilence_ns);

/// Moves the driver's clock on and waits for the device, so that no machine is too busy for it to answer in time.
inline void pass_step(std::atomic<std::int64_t>& now_ns, const EmulatedFalcon& emulated) {
  now_ns += kStep_ns;
  // With the next frame the answer to the one before has come, which is at most a step old.
  const std::int64_t before = emulated.frames();
  EXPECT_TRUE(eventually([&] { return emulated.frames() > before || !emulated.is_held(); }));
}

/// On a clock that only ticks move. Returns how often the device was lost.
inline int losses_when_stepped(EmulatedBus& bus, std::chrono::nanoseconds duration, int unplugs) {
  constexpr std::int64_t kMoment_ns = 1'000;
  std::atomic<std::int64_t> now_ns{3'600'000'000'000};
  FalconRun run(bus, {.rate_Hz = 1e6}, 1e9 / kStep_ns, [&now_ns] { return now_ns.load(); });
  run.unplug_now_and_then(duration, unplugs, [&] {
    if (run.answers()) {
      pass_step(now_ns, run.emulated());
    } else {
      // It is looked for in real time, for which the clock all but waits.
      now_ns += kMoment_ns;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    run.loop().tick(now_ns);
  });
  return run.end();
}

/// A busy machine may keep the emulated device from answering for longer than the driver waits for a transfer: a run
/// with such a loss is made again.
inline void run_stepped(EmulatedBus& bus, std::chrono::nanoseconds duration, int unplugs) {
  constexpr int kRuns = 4;
  int losses = 0;
  for (int run = 0; run < kRuns && losses != unplugs; ++run) {
    losses = losses_when_stepped(bus, duration, unplugs);
  }
  EXPECT_EQ(losses, unplugs);
}

}  // namespace asperity
