// The thread: it ticks, it counts a stall once, it never catches up, and it stops at zero force.
// Nothing here depends on how punctual the machine is.

#include "renderers/servo/servo_thread.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/calling_device.h"
#include "tests/support/eventually.h"
#include "tests/support/hanging_push.h"
#include "tests/support/patient_servo.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_device.h"
#include "tests/support/steady_push.h"

namespace asperity {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr std::int64_t kStall_ns = 30'000'000;
constexpr int kStalledRead = 40;

// Stalls once, in one reading.
void stall(ScriptedDevice& device) {
  device.at_read = [&device](ProbeState&) {
    if (device.reads != kStalledRead) return;
    const std::int64_t until_ns = monotonic_now_ns() + kStall_ns;
    while (monotonic_now_ns() < until_ns) {
    }
  };
}

// Runs the thread until the ring gave at least `count` records; a machine that cannot do that at
// all is stopped by the test's own time limit.
std::vector<TickRecord> run(ServoLoop& loop, RecordRing& ring, ScriptedDevice& device,
                            std::size_t count) {
  std::vector<TickRecord> records;
  TickRecord record;
  {
    const ServoThread thread(loop, device, Scheduling::normal);
    while (records.size() < count) {
      while (ring.pop(record)) records.push_back(record);
      std::this_thread::yield();
    }
  }
  while (ring.pop(record)) records.push_back(record);
  return records;
}

TEST(ServoThread, CountsAStallOnceAndNeverCatchesUp) {
  ScriptedDevice device;
  stall(device);
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  const std::vector<TickRecord> records = run(loop, ring, device, 120);
  ASSERT_EQ(ring.lost(), 0U);

  std::uint64_t missed = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const std::int64_t due_ns = records[i].probe.time_ns - records[i].lateness_ns;
    EXPECT_GE(records[i].lateness_ns, 0);
    EXPECT_EQ(records[i].has(TickFlag::missed_deadline), records[i].lateness_ns > kPeriod_ns);
    if (records[i].has(TickFlag::missed_deadline)) ++missed;
    if (i == 0) continue;
    const std::int64_t first_due_ns = records[0].probe.time_ns - records[0].lateness_ns;
    EXPECT_EQ((due_ns - first_due_ns) % kPeriod_ns, 0) << "off the original grid at " << i;
    // After a tick that ran over, the next waits for a point of the grid: it is no catching up.
    const auto points_passed = [&](std::int64_t time_ns) {
      return (time_ns - first_due_ns) / kPeriod_ns;
    };
    const TickRecord& before = records[i - 1];
    EXPECT_GT(points_passed(records[i].probe.time_ns),
              points_passed(before.probe.time_ns + before.execution_ns));
    // Never more ticks than points of the grid have passed: none is made up.
    EXPECT_LE(static_cast<std::int64_t>(i), points_passed(records[i].probe.time_ns));
  }
  EXPECT_EQ(loop.status().missed_deadlines, missed);
  // The reading that stalled, and the tick after it, late for the deadline that it missed.
  EXPECT_GE(records[kStalledRead - 1].execution_ns, kStall_ns);
  EXPECT_GE(records[kStalledRead].lateness_ns, kStall_ns - 2 * kPeriod_ns);
  EXPECT_TRUE(records[kStalledRead].has(TickFlag::missed_deadline));
}

TEST(ServoThread, StopsAtZeroForce) {
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  const std::vector<TickRecord> records = run(loop, ring, device, 100);
  EXPECT_EQ(records.back().sent.force_N.z, 1.0);
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
}

TEST(ServoThread, ObeysAnEmergencyStopFromAnotherThread) {
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  const ServoThread thread(loop, device, Scheduling::normal);
  while (loop.status().ticks < 60) std::this_thread::yield();
  loop.emergency_stop();
  const std::uint64_t then = loop.status().ticks;
  while (loop.status().ticks < then + 2) std::this_thread::yield();
  TickRecord record;
  TickRecord last;
  while (ring.pop(record)) last = record;
  EXPECT_TRUE(last.has(TickFlag::fault_latched));
  EXPECT_EQ(last.sent.force_N.z, 0.0);
  EXPECT_EQ(loop.status().fault, Fault::emergency_stop);
}

/// Patient with everything but ticks that do not return.
ServoSettings watched_servo(double standstill_to_fault_s = 0.05) {
  ServoSettings settings = patient_servo();
  settings.standstill_to_fault_s = standstill_to_fault_s;
  settings.silence_to_fault_s = 1e6;
  return settings;
}

TEST(ServoThread, RaisesAStandstillAndThenZeroesTheForceFromOutsideWhileATickHangs) {
  const auto hang = std::make_shared<Hang>();
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, watched_servo());
  std::atomic<int> zeroed{0};
  std::atomic<bool> is_fault_first{true};
  device.at_zero_from_outside = [&] {
    if (loop.status().fault == Fault::none) is_fault_first = false;
    ++zeroed;
  };
  loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
  hang->is_wanted = true;
  const ServoThread thread(loop, device, Scheduling::normal);
  const HangEnds at_the_end(hang);
  ASSERT_TRUE(eventually([&] { return hang->is_under_way.load(); }));
  const auto began = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually([&] { return zeroed > 0; }));
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(1));
  EXPECT_EQ(loop.status().fault, Fault::standstill);

  // At every look: a fault that was cleared is found again.
  const int before = zeroed;
  loop.clear_fault(Fault::standstill);
  EXPECT_TRUE(eventually([&] { return loop.status().fault == Fault::standstill; }));
  EXPECT_TRUE(eventually([&] { return zeroed > before + 3; }));
  EXPECT_TRUE(is_fault_first);

  // It returns: its tick sends zero, and the watch leaves the device alone.
  hang->is_wanted = false;
  const std::uint64_t ticks = loop.status().ticks;
  EXPECT_TRUE(eventually([&] { return loop.status().ticks > ticks + 20; }));
  EXPECT_EQ(loop.status().fault, Fault::standstill);
  TickRecord record;
  while (ring.pop(record)) EXPECT_EQ(record.sent.force_N.z, 0.0);
}

/// What a servo thread keeps.
struct KeptLoop {
  ScriptedDevice device{};
  RecordRing ring{};
  ServoLoop loop{device, ring, watched_servo(0.01)};
};

TEST(ServoThread, LeavesATickThatDoesNotReturnBehindAndReleasesWhatItUsesWhenItReturns) {
  const auto hang = std::make_shared<Hang>();
  const HangEnds at_the_end(hang);
  std::atomic<int> zeroed{0};
  std::atomic<bool> is_closed{false};
  {
    auto kept = std::make_shared<KeptLoop>();
    kept->device.at_zero_from_outside = [&] { ++zeroed; };
    kept->device.at_close = [&] { is_closed = true; };
    kept->loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
    hang->is_wanted = true;
    const ServoThread thread(kept->loop, kept->device, Scheduling::normal, kept);
    ASSERT_TRUE(eventually([&] { return hang->is_under_way.load(); }));
  }
  EXPECT_FALSE(is_closed);
  const int before = zeroed;
  EXPECT_TRUE(eventually([&] { return zeroed > before + 3; })) << "nobody watches it any more";
  hang->is_wanted = false;
  EXPECT_TRUE(eventually([&] { return is_closed.load(); }));
}

TEST(ServoThread, WaitsForATickOnAnythingThatItDoesNotKeep) {
  const auto hang = std::make_shared<Hang>();
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, watched_servo(0.01));
  std::atomic<int> zeroed{0};
  device.at_zero_from_outside = [&] { ++zeroed; };
  loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
  hang->is_wanted = true;
  auto thread = std::make_unique<ServoThread>(loop, device, Scheduling::normal);
  ASSERT_TRUE(eventually([&] { return hang->is_under_way.load(); }));
  std::atomic<bool> has_ended{false};
  std::thread ending([&] {
    thread.reset();
    has_ended = true;
  });
  // Every 5 ms, for longer than a kept one is waited for.
  const int before = zeroed;
  EXPECT_TRUE(eventually([&] { return zeroed > before + 100; }));
  EXPECT_FALSE(has_ended);
  hang->is_wanted = false;
  ending.join();
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
}

TEST(ServoThread, SaysHowItIsScheduled) {
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  {
    const ServoThread thread(loop, device, Scheduling::normal);
    EXPECT_THAT(thread.scheduling(), testing::StartsWith("SCHED_OTHER, memory "));
  }
  const ServoThread thread(loop, device, Scheduling::fifo_if_permitted);
  EXPECT_THAT(thread.scheduling(),
              testing::AnyOf(testing::StartsWith("SCHED_FIFO 80, memory "),
                             testing::StartsWith("SCHED_OTHER (SCHED_FIFO was refused: ")));
}

TEST(ServoThread, EitherGetsFifoOrSaysWhichLimitToRaise) {
  ScriptedDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  try {
    const ServoThread thread(loop, device, Scheduling::fifo);
    EXPECT_THAT(thread.scheduling(), testing::StartsWith("SCHED_FIFO 80"));
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("rtprio"));
  }
}

ServoSettings patient_with_silence() {
  ServoSettings settings = patient_servo();
  settings.silence_to_fault_s = 1e6;
  return settings;
}

TEST(CalledServo, TicksWheneverTheDevicesThreadCalls) {
  CallingDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_with_silence());
  loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  {
    const ServoThread thread(loop, device, Scheduling::fifo_if_permitted);
    EXPECT_THAT(thread.scheduling(),
                testing::StartsWith("called by the thread of calling, memory "));
    EXPECT_EQ(device.rate_Hz, 1000.0);
    while (loop.status().ticks < 120) std::this_thread::yield();
  }
  TickRecord record;
  std::int64_t began_ns = 0;
  int records = 0;
  double strongest_N = 0.0;
  while (ring.pop(record)) {
    if (records++ > 0) {  // due one period after the last one began
      EXPECT_EQ(record.lateness_ns, record.probe.time_ns - began_ns - kPeriod_ns);
      EXPECT_EQ(record.has(TickFlag::missed_deadline), record.lateness_ns > kPeriod_ns);
    }
    began_ns = record.probe.time_ns;
    strongest_N = std::max(strongest_N, record.sent.force_N.z);
  }
  EXPECT_EQ(strongest_N, 1.0);
  EXPECT_EQ(device.last_force_N.load(), 0.0);  // the thread leaves it so
}

TEST(CalledServo, TakesASilentDeviceForLostWithoutATick) {
  CallingDevice device;
  device.is_silent = true;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_servo());
  loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  const ServoThread thread(loop, device, Scheduling::normal);
  while (loop.status().fault == Fault::none) std::this_thread::yield();
  EXPECT_EQ(loop.status().fault, Fault::device_lost);
  EXPECT_EQ(loop.status().ticks, 0U);

  loop.clear_fault(loop.status().fault);  // too early: it is silent still
  while (loop.status().fault == Fault::none) std::this_thread::yield();
  EXPECT_EQ(loop.status().fault, Fault::device_lost);

  device.is_silent = false;  // calls again: at zero force, until somebody clears the fault
  while (loop.status().ticks < 5) std::this_thread::yield();
  EXPECT_EQ(loop.status().fault, Fault::device_lost);
  TickRecord record;
  ASSERT_TRUE(ring.pop(record));
  EXPECT_TRUE(record.has(TickFlag::fault_latched));
  EXPECT_EQ(record.sent.force_N.z, 0.0);
}

TEST(CalledServo, SendsNoForceInTheCallThatEndsASilence) {
  CallingDevice device;
  RecordRing ring(65536);
  ServoLoop loop(device, ring, patient_servo());
  loop.present({.id = 1, .renderer = std::make_unique<SteadyPush>()});
  {
    const ServoThread thread(loop, device, Scheduling::normal);
    const auto wait_for_ticks = [&loop](std::uint64_t more) {
      const std::uint64_t until = loop.status().ticks + more;
      while (loop.status().ticks < until) std::this_thread::yield();
    };
    // A little longer than it may be silent: in most rounds the call comes before the watch looks.
    for (int round = 0; round < 12; ++round) {
      wait_for_ticks(5);
      device.is_silent = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(52));
      device.is_silent = false;
      wait_for_ticks(2);
      loop.clear_fault(loop.status().fault);
    }
  }
  TickRecord record;
  std::int64_t last_ns = 0;
  int silences = 0;
  while (ring.pop(record)) {
    if (last_ns != 0 && record.probe.time_ns - last_ns > 50'000'000) {
      ++silences;
      EXPECT_TRUE(record.has(TickFlag::fault_latched));
    }
    last_ns = record.probe.time_ns;
  }
  EXPECT_GT(silences, 0);
}

// It called, and its call is what does not return: the device is not the cause.
TEST(CalledServo, TakesATickThatDoesNotReturnForAStandstill) {
  const auto hang = std::make_shared<Hang>();
  CallingDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, watched_servo());
  loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
  const ServoThread thread(loop, device, Scheduling::normal);
  const HangEnds at_the_end(hang);
  ASSERT_TRUE(eventually([&] {
    if (const Fault fault = loop.status().fault; fault != Fault::none) loop.clear_fault(fault);
    return device.last_force_N.load() > 0.0;
  }));
  hang->is_wanted = true;
  EXPECT_TRUE(eventually([&] { return device.last_force_N.load() == 0.0; }));
  EXPECT_EQ(loop.status().fault, Fault::standstill);
}

/// The same for a device that keeps time itself.
struct KeptCalledLoop {
  CallingDevice device{};
  RecordRing ring{};
  ServoLoop loop{device, ring, watched_servo(0.01)};
};

TEST(CalledServo, LeavesATickThatDoesNotReturnBehind) {
  const auto hang = std::make_shared<Hang>();
  const HangEnds at_the_end(hang);
  std::weak_ptr<KeptCalledLoop> left{};
  {
    auto kept = std::make_shared<KeptCalledLoop>();
    left = kept;
    kept->loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
    hang->is_wanted = true;
    const ServoThread thread(kept->loop, kept->device, Scheduling::normal, kept);
    ASSERT_TRUE(eventually([&] { return hang->is_under_way.load(); }));
  }
  EXPECT_FALSE(left.expired());
  hang->is_wanted = false;
  EXPECT_TRUE(eventually([&] { return left.expired(); }));
}

TEST(CalledServo, LeavesAWatchToWhichTheDriverDoesNotReturnBehind) {
  const auto hang = std::make_shared<Hang>();
  const HangEnds at_the_end(hang);
  auto kept = std::make_shared<KeptCalledLoop>();
  const std::weak_ptr<KeptCalledLoop> left = kept;
  CallingDevice* const device = &kept->device;
  ServoLoop& loop = kept->loop;
  loop.present({.id = 1, .renderer = std::make_unique<HangingPush>(hang)});
  hang->is_wanted = true;
  device->holds_calls_from_outside = true;
  {
    const ServoThread thread(loop, *device, Scheduling::normal, std::move(kept));
    ASSERT_TRUE(eventually([&] { return device->is_called_from_outside.load(); }));
    hang->is_wanted = false;  // the tick returns, the watch does not
  }
  EXPECT_FALSE(left.expired());
  device->holds_calls_from_outside = false;
  EXPECT_TRUE(eventually([&] { return left.expired(); }));
}

TEST(CalledServo, EndsThoughTheDevicesThreadHangsAndTurnsItAwayAfterwards) {
  CallingDevice device;
  RecordRing ring;
  std::uint64_t ticks = 0;
  {
    ServoLoop loop(device, ring, patient_with_silence());
    {
      const ServoThread thread(loop, device, Scheduling::normal);
      while (loop.status().ticks < 3) std::this_thread::yield();
      device.hang();
    }
    ticks = loop.status().ticks;
    device.release();
    while (device.turned_away.load() == 0) std::this_thread::yield();
    EXPECT_EQ(loop.status().ticks, ticks);
  }
  EXPECT_EQ(device.last_force_N.load(), 0.0);
}

TEST(CalledServo, RefusesADemandForFifoThatIsNotItsToMeet) {
  CallingDevice device;
  RecordRing ring;
  ServoLoop loop(device, ring, patient_with_silence());
  EXPECT_THAT(refusal_of<std::runtime_error>(
                  [&] { const ServoThread thread(loop, device, Scheduling::fifo); }),
              testing::HasSubstr("calling"));
}

TEST(CalledServo, IsNothingForADeviceThatIsPaced) {
  ScriptedDevice device;
  EXPECT_THROW(device.start_calls({}), std::logic_error);
}

}  // namespace
}  // namespace asperity
