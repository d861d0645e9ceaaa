// No step of force to the motors: readings that jump, gaps between ticks.

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/servo/gap_bridge.h"
#include "renderers/servo/servo_loop.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

// An elastic plane, 1000 N/m.
class Plane final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    const double depth_m = std::max(0.0, -probe.position_m.z);
    RenderedTick tick{};
    tick.wrench.force_N.z = 1000.0 * depth_m;
    tick.penetration_m = depth_m;
    return tick;
  }
};

// The limiter is wide open: what is tested is the cause, not the limit behind it.
class ServoStepsTest : public testing::TestWithParam<double> {
 protected:
  ServoStepsTest() {
    loop.present({.id = 1, .renderer = std::make_unique<Plane>()});
    for (int i = 0; i < 0.1 * GetParam(); ++i) tick(0.001);
    for (int i = 0; i < 0.1 * GetParam(); ++i) tick(-0.001);
  }

  TickRecord tick(double z_m, std::int64_t gap_ns = 0) {
    loop.heartbeat();
    device.probe.position_m.z = z_m;
    now_ns += gap_ns > 0 ? gap_ns : period_ns;
    loop.tick(now_ns, now_ns);
    TickRecord record{};
    EXPECT_TRUE(records.pop(record));
    return record;
  }

  ScriptedDevice device{{.name = "scripted", .peak_force_N = 100.0, .may_rest_exactly = true},
                        {.force_N = 100.0, .torque_N_m = 10.0, .slew_N = 1e6, .slew_N_m = 1e6}};
  RecordRing records{16};
  std::int64_t period_ns = std::llround(1e9 / GetParam());
  std::int64_t now_ns = 1'000'000'000;
  ServoLoop loop{device, records, {.rate_Hz = GetParam()}};
};

TEST_P(ServoStepsTest, ReplacesAReadingThatJumps) {
  const TickRecord held = tick(-0.025);
  EXPECT_TRUE(held.has(TickFlag::reading_held));
  EXPECT_EQ(held.probe.position_m.z, static_cast<double>(-0.001F));
  EXPECT_EQ(held.probe.time_ns, now_ns);
  EXPECT_NEAR(held.sent.force_N.z, 1.0, 1e-6);
  const TickRecord next = tick(-0.001);
  EXPECT_FALSE(next.has(TickFlag::reading_held));
  EXPECT_NEAR(next.sent.force_N.z, 1.0, 1e-6);
  EXPECT_EQ(loop.status().fault, Fault::none);
}

TEST_P(ServoStepsTest, LosesADeviceWhoseReadingsStayImplausibleForTwoMilliseconds) {
  const std::int64_t jumped_ns = now_ns + period_ns;
  while (now_ns < jumped_ns + 4'000'000) {
    const TickRecord record = tick(-0.05);
    const bool is_lost = now_ns - jumped_ns >= 2'000'000;
    EXPECT_EQ(loop.status().fault, is_lost ? Fault::device_lost : Fault::none);
    EXPECT_NEAR(record.sent.force_N.z, is_lost ? 0.0 : 1.0, 1e-6);
  }
}

// 13.9 mm for good: the force stays as it was until the fault.
TEST_P(ServoStepsTest, NeverFollowsAJumpThatLasts) {
  const std::int64_t jumped_ns = now_ns + period_ns;
  while (now_ns < jumped_ns + 10'000'000) {
    EXPECT_LE(tick(-0.0149).sent.force_N.z, 1.0 + 1e-6);
    EXPECT_EQ(loop.status().fault,
              now_ns - jumped_ns >= 2'000'000 ? Fault::device_lost : Fault::none);
  }
  EXPECT_TRUE(loop.status().position_jumped);
}

// Counts that are lost between two presentations would shift every later contact.
TEST_P(ServoStepsTest, LosesADeviceThatJumpsInFreeSpace) {
  loop.withdraw();
  for (int i = 0; i < 0.1 * GetParam(); ++i) tick(0.001);
  ASSERT_EQ(loop.status().presentation, 0U);
  EXPECT_TRUE(tick(0.08).has(TickFlag::reading_held));
  for (int i = 0; i < 0.01 * GetParam(); ++i) tick(0.08);
  EXPECT_EQ(loop.status().fault, Fault::device_lost);
  EXPECT_TRUE(loop.status().position_jumped);
  // The fault is cleared after the device was homed: the position is accepted as it is.
  loop.clear_fault(Fault::device_lost);
  EXPECT_FALSE(loop.status().position_jumped);
  const TickRecord cleared = tick(0.02);
  EXPECT_FALSE(cleared.has(TickFlag::reading_held));
  EXPECT_EQ(cleared.probe.position_m.z, static_cast<double>(0.02F));
  EXPECT_EQ(loop.status().fault, Fault::none);
  device.answers = false;
  tick(0.02);
  EXPECT_EQ(loop.status().fault, Fault::device_lost);
  EXPECT_FALSE(loop.status().position_jumped);
}

// The line pauses for 30 ms while the hand moves at 0.8 m/s; the driver reports this, and a surface appears meanwhile.
TEST_P(ServoStepsTest, JudgesTheMotionOverAPauseThatTheDriverReports) {
  loop.withdraw();
  for (int i = 0; i < 0.1 * GetParam(); ++i) tick(0.001);
  const std::int64_t began_ns = now_ns;
  device.at_read = [this](ProbeState&) { device.read_again(); };
  loop.collect();
  loop.present({.id = 2, .renderer = std::make_unique<Plane>()});
  while (now_ns < began_ns + 30'000'000) EXPECT_FALSE(tick(0.001).has(TickFlag::reading_held));
  device.at_read = {};
  const double moved_m = 0.8e-9 * static_cast<double>(now_ns + period_ns - began_ns);
  EXPECT_FALSE(tick(0.001 + moved_m).has(TickFlag::reading_held));
  EXPECT_EQ(loop.status().fault, Fault::none);
}

// 4.5 mm deeper after 45 ms: the force rises from 1 N to 5.5 N within the next 45 ms, evenly.
TEST_P(ServoStepsTest, ApproachesTheForceOfTheSurfaceOverTheLengthOfAGap) {
  constexpr double kGap_s = 0.045;
  TickRecord record = tick(-0.0055, 45'000'000);
  EXPECT_TRUE(record.has(TickFlag::gap_in_contact));
  const double period_s = 1.0 / GetParam();
  double passed_s = period_s;
  for (; passed_s < kGap_s - 1e-9; passed_s += period_s) {
    EXPECT_NEAR(record.sent.force_N.z, 1.0 + 4.5 * passed_s / kGap_s, 1e-5);
    EXPECT_NEAR(record.rendered.force_N.z, 5.5, 1e-5);
    EXPECT_EQ(record.gain, 1.0);
    record = tick(-0.0055);
    EXPECT_FALSE(record.has(TickFlag::gap_in_contact));
  }
  EXPECT_NEAR(record.sent.force_N.z, 5.5, 1e-5);
}

// The second gap ends in the last tick of the first one's bridge, with the hand 4 mm deeper.
TEST_P(ServoStepsTest, BridgesAGapAfterWhichTheLastTickOfABridgeComes) {
  const auto gap_ns = std::int64_t{40'000'000};
  tick(-0.001, gap_ns);
  for (std::int64_t passed_ns = period_ns; passed_ns < gap_ns - period_ns; passed_ns += period_ns) {
    tick(-0.001);
  }
  const TickRecord record = tick(-0.005, gap_ns);
  EXPECT_TRUE(record.has(TickFlag::gap_in_contact));
  EXPECT_NEAR(record.rendered.force_N.z, 5.0, 1e-5);
  // 4 N within 38 ms and more.
  EXPECT_LE(record.sent.force_N.z, 1.0 + 4.0 / (0.038 * GetParam()));
}

TEST_P(ServoStepsTest, NeverDelaysAFallAfterAGap) {
  EXPECT_NEAR(tick(-0.0004, 45'000'000).sent.force_N.z, 0.4, 1e-6);
  tick(-0.001, 45'000'000);
  const TickRecord left = tick(0.001, 45'000'000);
  EXPECT_EQ(left.sent.force_N.z, 0.0);
  EXPECT_TRUE(left.has(TickFlag::gap_in_contact));  // the force was held in it
}

TEST_P(ServoStepsTest, BridgesAShortGapOverTwoMillisecondsAndNoneOfTwoPeriods) {
  EXPECT_FALSE(tick(-0.0011, 2 * period_ns).has(TickFlag::gap_in_contact));
  EXPECT_TRUE(tick(-0.0012, 2 * period_ns + 1000).has(TickFlag::gap_in_contact));
  const std::int64_t least_ns = std::max<std::int64_t>(2'000'000, 2 * period_ns + 1000);
  for (std::int64_t passed_ns = period_ns; passed_ns < least_ns; passed_ns += period_ns) {
    if (passed_ns > period_ns) tick(-0.0012);
    EXPECT_LT(device.last_sent.force_N.z, 1.2 - 1e-5);
  }
  EXPECT_NEAR(tick(-0.0012).sent.force_N.z, 1.2, 1e-6);
}

TEST_P(ServoStepsTest, CountsNoGapInFreeSpace) {
  for (int i = 0; i < 0.1 * GetParam(); ++i) tick(0.001);
  EXPECT_FALSE(tick(0.001, 45'000'000).has(TickFlag::gap_in_contact));
}

INSTANTIATE_TEST_SUITE_P(Rates, ServoStepsTest, testing::Values(500.0, 1000.0, 2000.0, 4000.0));

TEST(GapBridge, TurnsFromTheFallenForceToTheNewOne) {
  GapBridge bridge{};
  bridge.begin({.force_N = {0.0, 0.0, 4.0}}, 0.010);
  // 4 N upwards falls to 2 N; 3 N across grow over 10 ms.
  const Wrench wanted{.force_N = {3.0, 0.0, 2.0}};
  for (int i = 1; i <= 12; ++i) {
    const Wrench sent = bridge.approach(wanted, 0.001);
    EXPECT_NEAR(sent.force_N.x, 0.3 * std::min(i, 10), 1e-12);
    EXPECT_NEAR(sent.force_N.z, 2.0, 1e-12);
  }
  EXPECT_EQ(bridge.approach(wanted, 0.001).force_N, wanted.force_N);
}

TEST(GapBridge, HoldsWhileTheClockIsSetBack) {
  const Wrench wanted{.force_N = {0.0, 0.0, 5.0}};
  GapBridge idle{};
  EXPECT_EQ(idle.approach(wanted, -0.5).force_N, wanted.force_N);
  GapBridge bridge{};
  bridge.begin({.force_N = {0.0, 0.0, 1.0}}, 0.010);
  bridge.approach(wanted, 0.001);
  EXPECT_NEAR(bridge.approach(wanted, -0.5).force_N.z, 1.4, 1e-12);
  EXPECT_NEAR(bridge.approach(wanted, 0.001).force_N.z, 1.8, 1e-12);
}

// A gap of 9 ticks before each tick: T = 5 ticks, so that a force that rises by 0.2 N in each gap lags by 4 of them. If each
// bridge began anew, T = 9 and the lag is 8.
TEST(GapBridge, DelaysTheGrowthAfterGapsInARowByHalfTheirLength) {
  GapBridge bridge{};
  Wrench sent{};
  Wrench wanted{};
  for (int i = 1; i <= 60; ++i) {
    bridge.begin(sent, 0.009);
    wanted.force_N.z = 0.2 * i;
    sent = bridge.approach(wanted, 0.001);
  }
  EXPECT_NEAR(wanted.force_N.z - sent.force_N.z, 4.0 * 0.2, 1e-3);
}

TEST(GapBridge, BridgesAGapInTheLastTickOfABridge) {
  const Wrench wanted{.force_N = {0.0, 0.0, 5.0}};
  GapBridge bridge{};
  Wrench sent{.force_N = {0.0, 0.0, 1.0}};
  bridge.begin(sent, 0.040);
  for (int i = 1; i < 40; ++i) sent = bridge.approach(sent, 0.001);
  EXPECT_NEAR(sent.force_N.z, 1.0, 1e-12);
  // T = 1/40 · 1 ms + 39/40 · 40 ms.
  bridge.begin(sent, 0.040);
  EXPECT_NEAR(bridge.approach(wanted, 0.001).force_N.z, 1.0 + 4.0 / 39.025, 1e-9);
  // A longer one is bridged over its own length.
  bridge.begin({.force_N = {0.0, 0.0, 1.0}}, 0.050);
  EXPECT_NEAR(bridge.approach(wanted, 0.001).force_N.z, 1.0 + 4.0 / 50.0, 1e-9);
}

}  // namespace
}  // namespace asperity
