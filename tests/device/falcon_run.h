// A servo thread on an emulated Falcon that is unplugged now and then.

#pragma once

#include <chrono>
#include <cmath>
#include <memory>
#include <thread>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "device/falcon/falcon_device.h"
#include "renderers/servo_thread.h"
#include "tests/device/emulated_falcon.h"
#include "tests/support/eventually.h"
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

/// Runs for `duration`, unplugs the device `unplugs` times at even intervals and plugs it in again, and
/// expects after each that nothing was lost, nothing pushed, and that it goes on.
inline void run_with_unplugs(EmulatedBus& bus, std::chrono::milliseconds duration, int unplugs) {
  EmulatedFalcon emulated(bus, {});
  emulated.circle(0.015);
  FalconSettings settings{};
  settings.line.place = "usb 1-2";
  settings.line.wants_fifo = false;  // the test bed's other end has to get its turn too
  auto device = FalconDevice::open(settings);
  RecordRing ring(32768);
  RunWatch watch(ring);
  {
    // However late this busy machine makes the thread, that is not what is tested.
    ServoLoop loop(*device, ring, {.heartbeat_timeout_s = 1e6, .misses_to_fault = 1'000'000});
    loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
    {
      const ServoThread thread(loop, *device, Scheduling::normal);
      const auto reached = [&watch](const auto& condition) {
        return eventually([&] {
          watch.drain();
          return condition();
        });
      };
      // A busy machine may keep the emulated device from answering for 50 ms at any time: that is a
      // loss like another, and lifted as a person would lift it.
      const auto go_on = [&] {
        return reached([&] {
          if (loop.status().fault != Fault::none && watch.answers()) loop.clear_fault();
          return watch.is_felt();
        });
      };
      const auto began = std::chrono::steady_clock::now();
      for (int i = 1; i <= unplugs + 1; ++i) {
        const auto until = began + duration * i / (unplugs + 1);
        while (std::chrono::steady_clock::now() < until) {
          ASSERT_TRUE(go_on());
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (i > unplugs) break;
        const int losses = watch.losses;
        emulated.unplug();
        ASSERT_TRUE(reached([&] { return watch.losses > losses; }));
        EXPECT_EQ(loop.status().fault, Fault::device_lost);
        emulated.plug_in();
        ASSERT_TRUE(reached([&] { return watch.answers(); }));
        // It answers, and until somebody lifts the fault it gets no force.
        EXPECT_EQ(emulated.take_strongest_word(), 0);
        EXPECT_EQ(loop.status().fault, Fault::device_lost);
        ASSERT_TRUE(go_on());
        EXPECT_TRUE(eventually([&] { return emulated.take_strongest_word() > 0; }));
      }
    }
    watch.drain();
    EXPECT_EQ(watch.ticks, loop.status().ticks);
  }
  EXPECT_EQ(ring.lost(), 0U);
  EXPECT_GE(watch.losses, unplugs);
  device.reset();
  EXPECT_EQ(emulated.motor_words(), (std::array<std::int16_t, 3>{}));
}

}  // namespace asperity
