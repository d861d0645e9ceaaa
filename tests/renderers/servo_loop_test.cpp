// What the servo loop promises: a gentle start, a gentle end, and zero force in every fault.

#include "renderers/servo/servo_loop.h"

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Pushes up with 1 N below z = 0, and remembers how it was asked.
class UnitPlate final : public ForceRenderer {
 public:
  struct Log {
    int resets = 0;
    std::vector<double> dt_s{};
    bool destroyed = false;
  };
  explicit UnitPlate(Log& log) : log_(log) { log_.dt_s.reserve(100'000); }
  ~UnitPlate() override { log_.destroyed = true; }

  void reset(const ProbeState&) noexcept override { ++log_.resets; }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    log_.dt_s.push_back(dt_s);
    RenderedTick tick;
    if (probe.position_m.z < 0.0) {
      tick.wrench.force_N.z = force_N;
      tick.wrench.torque_N_m.x = torque_N_m;
      tick.penetration_m = penetrations * -probe.position_m.z;
    }
    return tick;
  }
  double force_N = 1.0;
  double torque_N_m = 0.01;
  double penetrations = 1.0;

 private:
  Log& log_;
};

class ServoLoopTest : public testing::Test {
 protected:
  ServoLoopTest() { touch(); }

  void touch() { device.probe.position_m.z = -0.001; }
  void lift() { device.probe.position_m.z = 0.010; }

  UnitPlate& present(std::uint64_t id = 7) {
    auto plate = std::make_unique<UnitPlate>(log);
    UnitPlate& reference = *plate;
    loop.present({.id = id, .renderer = std::move(plate)});
    return reference;
  }

  // One tick at 1 kHz; the conductor lives unless a test says otherwise.
  TickRecord tick(std::int64_t late_ns = 0) {
    if (conductor_lives) loop.heartbeat();
    now_ns += 1'000'000;
    loop.tick(now_ns + late_ns, now_ns);
    TickRecord record;
    EXPECT_TRUE(records.pop(record));
    return record;
  }
  TickRecord ticks(int count) {
    TickRecord record;
    for (int i = 0; i < count; ++i) record = tick();
    return record;
  }
  // Felt at full strength: through free space, then down.
  void feel() {
    present();
    lift();
    ticks(60);
    touch();
    ASSERT_EQ(tick().gain, 1.0);
  }
  void expect_latched(Fault fault, const TickRecord& record) {
    EXPECT_EQ(loop.status().fault, fault) << name_of(loop.status().fault);
    EXPECT_TRUE(record.has(TickFlag::fault_latched));
    EXPECT_EQ(record.sent.force_N, glm::dvec3(0.0));
    EXPECT_EQ(record.sent.torque_N_m, glm::dvec3(0.0));
    EXPECT_EQ(record.gain, 0.0);
    EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
    EXPECT_EQ(device.last_sent.torque_N_m, glm::dvec3(0.0));
  }

  UnitPlate::Log log{};
  ScriptedDevice device{{.name = "scripted",
                         .actuated_degrees_of_freedom = 6,
                         .peak_force_N = 100.0,
                         .maximum_speed_m_per_s = kInfinity,
                         .may_rest_exactly = true},
                        {.force_N = 100.0, .torque_N_m = 10.0, .slew_N = 1e6, .slew_N_m = 1e6}};
  RecordRing records{16};
  ServoLoop loop{device, records, {}};
  std::int64_t now_ns = 1'000'000'000;
  bool conductor_lives = true;
};

TEST_F(ServoLoopTest, PushesNothingInFreeSpace) {
  const TickRecord record = tick();
  EXPECT_EQ(record.presentation, 0U);
  EXPECT_FALSE(record.has(TickFlag::presenting));
  EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
}

// Between two ticks nothing hangs, whatever time passes.
TEST_F(ServoLoopTest, IsInNoTickBetweenTwo) {
  for (std::uint64_t ended = 1; ended <= 3; ++ended) {
    tick();
    const TickProgress seen = loop.progress();
    EXPECT_EQ(seen.begun, ended);
    EXPECT_EQ(seen.ended, ended);
    EXPECT_FALSE(seen.hangs_since(seen));
  }
}

TEST_F(ServoLoopTest, RaisesASurfaceOverFiftyMilliseconds) {
  present();
  lift();
  const TickRecord first = tick();  // free space: the ramp is counted from here
  EXPECT_EQ(first.gain, 0.0);
  touch();
  for (int i = 1; i < 50; ++i) {
    const TickRecord record = tick();
    EXPECT_NEAR(record.gain, i / 50.0, 1e-12);
    EXPECT_NEAR(record.sent.force_N.z, i / 50.0, 1e-12);
    EXPECT_NEAR(record.sent.torque_N_m.x, 0.01 * i / 50.0, 1e-14);
    EXPECT_EQ(record.rendered.force_N.z, 1.0);  // what was meant is kept
    EXPECT_EQ(record.rendered.torque_N_m.x, 0.01);
  }
  EXPECT_NEAR(tick().gain, 1.0, 1e-12);
  EXPECT_EQ(tick().gain, 1.0);
}

TEST_F(ServoLoopTest, KeepsASurfaceSilentThatAppearsAroundTheProbe) {
  present();
  for (int i = 0; i < 500; ++i) EXPECT_EQ(tick().sent.force_N.z, 0.0);
  lift();
  tick();
  touch();
  EXPECT_NEAR(tick().sent.force_N.z, 0.02, 1e-12);
}

TEST_F(ServoLoopTest, AsksTheRendererWithTheTimeBetweenItsSamples) {
  present();
  ticks(3);
  now_ns += 1'500'000;  // 2.5 periods
  tick();
  now_ns += 49'000'000;  // a stall of 50 periods
  tick();
  ASSERT_EQ(log.dt_s.size(), 5U);
  EXPECT_DOUBLE_EQ(log.dt_s[0], 0.001);
  EXPECT_DOUBLE_EQ(log.dt_s[1], 0.001);
  EXPECT_DOUBLE_EQ(log.dt_s[3], 0.0025);
  EXPECT_DOUBLE_EQ(log.dt_s[4], 0.004);
  EXPECT_EQ(log.resets, 1);
}

TEST_F(ServoLoopTest, MarksTheFirstRecordOfAPresentation) {
  tick();
  present(9);
  const TickRecord first = tick();
  EXPECT_TRUE(first.has(TickFlag::first_of_presentation));
  EXPECT_TRUE(first.has(TickFlag::presenting));
  EXPECT_EQ(first.presentation, 9U);
  EXPECT_FALSE(tick().has(TickFlag::first_of_presentation));
}

TEST_F(ServoLoopTest, FadesAWithdrawnSurfaceOutAndGivesItBack) {
  feel();
  loop.withdraw();
  for (int i = 1; i < 50; ++i) {
    const Wrench sent = tick().sent;
    EXPECT_NEAR(sent.force_N.z, 1.0 - i / 50.0, 1e-12);
    EXPECT_NEAR(sent.torque_N_m.x, 0.01 * (1.0 - i / 50.0), 1e-14);
  }
  EXPECT_EQ(loop.collect().renderer, nullptr);
  ticks(3);
  EXPECT_EQ(loop.status().presentation, 0U);
  EXPECT_FALSE(log.destroyed);  // not by the tick
  Presentation back = loop.collect();
  EXPECT_EQ(back.id, 7U);
  ASSERT_NE(back.renderer, nullptr);
  EXPECT_EQ(loop.collect().renderer, nullptr);
}

TEST_F(ServoLoopTest, GivesBackASurfaceThatWasWithdrawnWhileItWaited) {
  present();
  loop.withdraw();
  ticks(2);
  EXPECT_EQ(loop.collect().id, 7U);
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
  // A later one is not withdrawn by that.
  present(8);
  lift();
  ticks(60);
  touch();
  EXPECT_EQ(tick().sent.force_N.z, 1.0);
}

TEST_F(ServoLoopTest, FadesOneSurfaceOutBeforeTheNextFadesIn) {
  feel();
  present(8);
  EXPECT_NEAR(tick().gain, 0.98, 1e-12);
  ticks(49);
  EXPECT_EQ(tick().presentation, 8U);
  EXPECT_EQ(loop.collect().id, 7U);
  EXPECT_EQ(ticks(100).gain, 0.0);  // the probe has not left the surface yet
  lift();
  ticks(60);
  touch();
  EXPECT_EQ(tick().gain, 1.0);
}

// Nobody has collected the one before: it is not lost, and neither is this one.
TEST_F(ServoLoopTest, KeepsASurfaceUntilTheOneBeforeItHasBeenCollected) {
  feel();
  loop.withdraw();
  ticks(60);
  present(8);
  ticks(2);
  loop.withdraw();
  EXPECT_EQ(ticks(100).presentation, 8U);
  EXPECT_FALSE(log.destroyed);
  EXPECT_EQ(loop.collect().id, 7U);
  EXPECT_EQ(tick().presentation, 0U);
  EXPECT_EQ(loop.collect().id, 8U);
}

TEST_F(ServoLoopTest, RefusesASecondWaitingPresentation) {
  present();
  EXPECT_THROW(present(8), std::logic_error);
}

TEST_F(ServoLoopTest, RefusesAPresentationWithoutIdOrRenderer) {
  EXPECT_THROW(present(0), std::invalid_argument);
  EXPECT_THROW(loop.present({.id = 1, .renderer = nullptr}), std::invalid_argument);
}

TEST_F(ServoLoopTest, FadesASurfaceOutWhenTheConductorIsSilent) {
  feel();
  conductor_lives = false;
  EXPECT_EQ(ticks(2000).gain, 1.0);  // two seconds are forgiven
  const TickRecord fading = tick();
  EXPECT_TRUE(fading.has(TickFlag::heartbeat_lost));
  EXPECT_NEAR(fading.gain, 1.0 - 1.0 / 500.0, 1e-9);
  EXPECT_NEAR(ticks(249).gain, 0.5, 1e-9);
  EXPECT_NEAR(ticks(251).gain, 0.0, 1e-12);
  EXPECT_EQ(loop.status().fault, Fault::none);
}

TEST_F(ServoLoopTest, BringsASilencedSurfaceBackOnlyFromFreeSpace) {
  feel();
  conductor_lives = false;
  ticks(3000);
  conductor_lives = true;
  EXPECT_EQ(ticks(100).gain, 0.0);
  lift();
  ticks(60);
  touch();
  EXPECT_EQ(tick().gain, 1.0);
}

TEST_F(ServoLoopTest, FinishesAFadeThatAHeartbeatInterrupts) {
  feel();
  conductor_lives = false;
  ticks(2250);
  conductor_lives = true;
  lift();
  EXPECT_NEAR(ticks(100).gain, 0.3, 0.01);  // no jump up in mid-air
  ticks(300);
  EXPECT_EQ(ticks(60).gain, 1.0);
}

TEST_F(ServoLoopTest, LatchesAnEmergencyStopAtTheNextTick) {
  feel();
  loop.emergency_stop();
  expect_latched(Fault::emergency_stop, tick());
  expect_latched(Fault::emergency_stop, ticks(100));
}

TEST_F(ServoLoopTest, KeepsTheFirstFaultThatExplainsTheOthers) {
  feel();
  device.probe.position_m.x = 0.2;
  tick();
  device.answers = false;
  expect_latched(Fault::workspace_left, tick());
}

TEST_F(ServoLoopTest, StartsOverAfterAFaultWasCleared) {
  feel();
  loop.emergency_stop();
  EXPECT_FALSE(tick().has(TickFlag::presenting));
  loop.clear_fault(loop.status().fault);
  const TickRecord first = tick();
  EXPECT_EQ(loop.status().fault, Fault::none);
  EXPECT_TRUE(first.has(TickFlag::first_of_presentation));
  EXPECT_EQ(log.resets, 2);
  EXPECT_EQ(ticks(100).sent.force_N.z, 0.0);  // still in the surface
  lift();
  ticks(60);
  touch();
  EXPECT_EQ(tick().sent.force_N.z, 1.0);
}

TEST_F(ServoLoopTest, ClearsNoOtherFaultThanTheOneThatWasSeen) {
  feel();
  loop.lose_device();
  tick();
  const Fault seen = loop.status().fault;
  loop.emergency_stop();
  loop.clear_fault(seen);
  expect_latched(Fault::emergency_stop, tick());
  loop.clear_fault(Fault::emergency_stop);
  EXPECT_FALSE(tick().has(TickFlag::fault_latched));
}

TEST_F(ServoLoopTest, LatchesALostDevice) {
  feel();
  device.answers = false;
  const TickRecord lost = tick();
  expect_latched(Fault::device_lost, lost);
  EXPECT_TRUE(lost.has(TickFlag::device_lost));
  EXPECT_EQ(lost.presentation, 7U);  // the fault belongs to the attempt
  EXPECT_EQ(lost.probe.position_m.z, static_cast<double>(-0.001F));
  device.answers = true;
  expect_latched(Fault::device_lost, tick());
}

TEST_F(ServoLoopTest, LatchesADeviceThatDoesNotTakeForces) {
  feel();
  device.accepts = false;
  const TickRecord lost = tick();
  expect_latched(Fault::device_lost, lost);
  EXPECT_TRUE(lost.has(TickFlag::device_lost));
}

TEST_F(ServoLoopTest, LatchesAReadingOfWhichAnyNumberIsNotFinite) {
  feel();
  const ProbeState good = device.probe;
  const auto number = [this](int i) -> double& {
    ProbeState& probe = device.probe;
    if (i < 3) return probe.position_m[i];
    if (i < 6) return probe.velocity_m_per_s[i - 3];
    if (i < 9) return probe.angular_velocity_rad_per_s[i - 6];
    return probe.orientation[i - 9];
  };
  for (int i = 0; i < 13; ++i) {
    // The last is infinite only as the record has it, in single precision.
    for (const double value : {kNan, kInfinity, -kInfinity, 1e39}) {
      SCOPED_TRACE("number " + std::to_string(i) + ": " + std::to_string(value));
      number(i) = value;
      expect_latched(Fault::not_finite, tick());
      device.probe = good;
      loop.clear_fault(Fault::not_finite);
      EXPECT_FALSE(tick().has(TickFlag::fault_latched));
    }
  }
}

// A recording has floats, in which a finite number of 1e40, the penetration here, is infinite.
TEST_F(ServoLoopTest, LatchesWhatARendererGivesThatIsNotFiniteAsItIsStored) {
  for (double UnitPlate::*part :
       {&UnitPlate::force_N, &UnitPlate::torque_N_m, &UnitPlate::penetrations}) {
    for (const double number : {kNan, kInfinity, 1e43}) {
      UnitPlate& plate = present();
      lift();
      ticks(60);
      touch();
      ASSERT_EQ(tick().sent.force_N.z, 1.0);
      plate.*part = number;
      const TickRecord record = tick();
      expect_latched(Fault::not_finite, record);
      EXPECT_TRUE(record.has(TickFlag::limited_not_finite));
      loop.withdraw();
      loop.clear_fault(Fault::not_finite);
      tick();
      EXPECT_EQ(loop.collect().id, 7U);
    }
  }
}

TEST_F(ServoLoopTest, LimitsAForceThatIsFiniteAsItIsStored) {
  UnitPlate& plate = present();
  lift();
  ticks(60);
  touch();
  plate.force_N = std::numeric_limits<float>::max();
  const TickRecord record = tick();
  EXPECT_EQ(loop.status().fault, Fault::none);
  EXPECT_TRUE(record.has(TickFlag::limited_force));
  EXPECT_LE(record.sent.force_N.z, device.limits().force_N);
}

TEST_F(ServoLoopTest, LatchesAProbeThatLeavesTheWorkspaceOnAnySide) {
  feel();
  device.probe.position_m.x = 0.119;  // within the margin of 20 mm
  EXPECT_EQ(tick().sent.force_N.z, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      SCOPED_TRACE("axis " + std::to_string(axis) + ", side " + std::to_string(side));
      device.probe.position_m = {};
      device.probe.position_m[axis] = 0.119 * side;
      EXPECT_FALSE(tick().has(TickFlag::fault_latched));
      device.probe.position_m[axis] = 0.121 * side;
      expect_latched(Fault::workspace_left, tick());
      device.probe.position_m = {};
      loop.clear_fault(Fault::workspace_left);
    }
  }
}

// Binary fractions: what is compared is exact.
TEST(ServoLoop, LetsAProbeReachTheMarginOfTheWorkspaceExactly) {
  constexpr double kReach_m = 0.125;
  constexpr double kMargin_m = 0.015625;
  ScriptedDevice device({.name = "scripted",
                         .workspace_minimum_m = glm::dvec3(-kReach_m),
                         .workspace_maximum_m = glm::dvec3(kReach_m),
                         .peak_force_N = 100.0,
                         .maximum_speed_m_per_s = kInfinity,
                         .may_rest_exactly = true});
  RecordRing records{16};
  ServoLoop loop(device, records, {.workspace_margin_m = kMargin_m});
  std::int64_t now_ns = 0;
  const auto fault_at = [&](double z_m) {
    device.probe.position_m.z = z_m;
    now_ns += 1'000'000;
    loop.tick(now_ns, now_ns);
    return loop.status().fault;
  };
  EXPECT_EQ(fault_at(kReach_m + kMargin_m), Fault::none);
  EXPECT_EQ(fault_at(-kReach_m - kMargin_m), Fault::none);
  EXPECT_EQ(fault_at(-kReach_m - kMargin_m - 0x1p-20), Fault::workspace_left);
}

TEST_F(ServoLoopTest, CountsATickThatBeginsMoreThanAPeriodLate) {
  feel();
  EXPECT_FALSE(tick(1'000'000).has(TickFlag::missed_deadline));
  const TickRecord late = tick(20'300'000);
  EXPECT_TRUE(late.has(TickFlag::missed_deadline));
  EXPECT_EQ(late.lateness_ns, 20'300'000);
  EXPECT_EQ(loop.status().missed_deadlines, 1U);
  EXPECT_EQ(loop.status().fault, Fault::none);
}

TEST_F(ServoLoopTest, LatchesMoreThanAHundredMissesWithinASecond) {
  feel();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(tick(1'000'001).sent.force_N.z, 1.0) << i;
  expect_latched(Fault::repeated_misses, tick(1'000'001));
}

// A hundred and one misses: the first and the last a second apart, and before that a nanosecond more.
TEST_F(ServoLoopTest, CountsTheMissesOfExactlyASecond) {
  for (const std::int64_t longer_ns : {1, 0}) {
    ticks(1100);
    tick(1'000'001);
    ticks(900);
    for (int i = 0; i < 99; ++i) tick(1'000'001);
    EXPECT_EQ(loop.status().fault, Fault::none);
    tick(1'000'001 + longer_ns);
    EXPECT_EQ(loop.status().fault, longer_ns > 0 ? Fault::none : Fault::repeated_misses);
  }
}

TEST_F(ServoLoopTest, ForgivesMissesThatAreRare) {
  feel();
  for (int i = 0; i < 300; ++i) {
    ticks(10);  // 91 misses a second
    tick(1'000'001);
  }
  EXPECT_EQ(loop.status().fault, Fault::none);
  EXPECT_EQ(loop.status().missed_deadlines, 300U);
}

constexpr std::int64_t kStandstill_ns = 50'000'000;  // longer is a fault

TEST_F(ServoLoopTest, LatchesAStandstillWhileASurfaceIsPresented) {
  feel();
  now_ns += kStandstill_ns - 1'000'000;
  EXPECT_EQ(tick().sent.force_N.z, 1.0);  // just not
  now_ns += kStandstill_ns - 999'999;
  expect_latched(Fault::standstill, tick());
  // The hand may be anywhere by now: it is felt as a new surface.
  loop.clear_fault(loop.status().fault);
  EXPECT_EQ(ticks(100).sent.force_N.z, 0.0);
  EXPECT_EQ(log.resets, 2);
  lift();
  tick();
  touch();
  EXPECT_NEAR(tick().sent.force_N.z, 0.02, 1e-12);
}

TEST_F(ServoLoopTest, LatchesAStandstillThatTheDeviceFollowsAsAStandstill) {
  feel();
  now_ns += 4'000'000'000;
  device.answers = false;
  expect_latched(Fault::standstill, tick());
}

TEST_F(ServoLoopTest, LatchesAStandstillOfASurfaceThatHasJustBegunOrIsLeaving) {
  present();
  lift();
  tick();
  now_ns += kStandstill_ns;
  expect_latched(Fault::standstill, tick());
  loop.clear_fault(loop.status().fault);
  ticks(60);
  loop.withdraw();
  tick();
  now_ns += kStandstill_ns;
  expect_latched(Fault::standstill, tick());
}

// Between reading the hand and pushing it, the clock tells.
TEST_F(ServoLoopTest, LatchesAStandstillWithinATick) {
  feel();
  static std::int64_t at_end_ns = 0;
  now_ns += 1'000'000;
  at_end_ns = now_ns + kStandstill_ns + 1;
  loop.heartbeat();
  loop.tick(now_ns, now_ns, []() noexcept { return at_end_ns; });
  TickRecord record;
  ASSERT_TRUE(records.pop(record));
  expect_latched(Fault::standstill, record);
}

TEST_F(ServoLoopTest, StandsStillWithoutFaultWhereNothingIsPresented) {
  ticks(3);
  now_ns += 4'000'000'000;
  EXPECT_FALSE(tick().has(TickFlag::fault_latched));
  // One that waited meanwhile has not pushed anybody.
  now_ns += 4'000'000'000;
  present();
  EXPECT_EQ(tick().gain, 0.0);
  EXPECT_EQ(loop.status().fault, Fault::none);
  EXPECT_EQ(log.dt_s, std::vector<double>{0.001});
}

TEST_F(ServoLoopTest, SaysHowLongATickTookWhenItHasAClock) {
  loop.tick(now_ns, now_ns, []() noexcept -> std::int64_t { return 1'000'000'000 + 1'234; });
  TickRecord record;
  ASSERT_TRUE(records.pop(record));
  EXPECT_EQ(record.execution_ns, 1'234);
  EXPECT_EQ(tick().execution_ns, 0);
}

TEST_F(ServoLoopTest, RoundsTheProbeBeforeTheRendererSeesIt) {
  device.probe.position_m.x = 0.1;
  EXPECT_EQ(tick().probe.position_m.x, static_cast<double>(0.1F));
}

TEST(ServoLoop, LeavesTheDeviceAtZeroForce) {
  ScriptedDevice device;
  RecordRing records(256);
  UnitPlate::Log log;
  {
    ServoLoop loop(device, records, {});
    loop.present({.id = 1, .renderer = std::make_unique<UnitPlate>(log)});
    std::int64_t now_ns = 0;
    device.probe.position_m.z = 0.01;
    for (int i = 0; i < 60; ++i) loop.tick(now_ns += 1'000'000);
    device.probe.position_m.z = -0.01;
    loop.tick(now_ns += 1'000'000);
    EXPECT_GT(device.last_sent.force_N.z, 0.9);
  }
  EXPECT_EQ(device.last_sent.force_N.z, 0.0);
  EXPECT_TRUE(log.destroyed);
}

TEST(ServoLoop, RefusesSettingsThatAreNotPositive) {
  ScriptedDevice device;
  RecordRing records;
  EXPECT_THROW(ServoLoop(device, records, {.rate_Hz = 0.0}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.ramp_s = -1.0}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.heartbeat_timeout_s = kNan}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.heartbeat_fade_s = 0.0}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.misses_to_fault = 0}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.workspace_margin_m = -0.1}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.silence_to_fault_s = 0.0}), std::invalid_argument);
  EXPECT_THROW(ServoLoop(device, records, {.standstill_to_fault_s = 0.0}), std::invalid_argument);
}

// At 4 kHz the four steps of a millisecond grow by 1 N together, and a gap counts as one of them.
TEST(ServoLoop, GrowsNoFasterAfterAGap) {
  for (const std::int64_t gap_ns : {250'000, 2'000'000}) {
    UnitPlate::Log log{};
    ScriptedDevice device({.name = "scripted",
                           .peak_force_N = 100.0,
                           .maximum_speed_m_per_s = kInfinity,
                           .may_rest_exactly = true},
                          ForceLimits{});
    RecordRing records{16};
    ServoLoop loop{device, records, {.rate_Hz = 4000.0, .ramp_s = 1e-9}};
    auto plate = std::make_unique<UnitPlate>(log);
    plate->force_N = 5.0;
    loop.present({.id = 7, .renderer = std::move(plate)});
    std::int64_t now_ns = 1'000'000'000;
    const auto sent_N = [&](double z_m, std::int64_t step_ns) {
      device.probe.position_m.z = z_m;
      loop.tick(now_ns += step_ns);
      return device.last_sent.force_N.z;
    };
    for (int i = 0; i < 8; ++i) sent_N(0.01, 250'000);
    EXPECT_NEAR(sent_N(-0.001, 250'000), 1.0, 1e-12);
    EXPECT_NEAR(sent_N(-0.001, gap_ns), 1.0, 1e-12) << gap_ns;
    EXPECT_NEAR(sent_N(-0.001, 250'000), 1.0, 1e-12);
    EXPECT_NEAR(sent_N(-0.001, 250'000), 1.0, 1e-12);
    EXPECT_NEAR(sent_N(-0.001, 250'000), 2.0, 1e-12);
  }
}

}  // namespace
}  // namespace asperity
