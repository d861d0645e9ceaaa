// No step of force to the motors: readings that jump.

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

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

TEST_P(ServoStepsTest, AcceptsAnyReadingWhileNoSurfaceIsFelt) {
  loop.withdraw();
  for (int i = 0; i < 0.1 * GetParam(); ++i) tick(-0.001);
  EXPECT_FALSE(tick(0.08).has(TickFlag::reading_held));
  EXPECT_EQ(loop.status().fault, Fault::none);
}

INSTANTIATE_TEST_SUITE_P(Rates, ServoStepsTest, testing::Values(500.0, 1000.0, 2000.0, 4000.0));

}  // namespace
}  // namespace asperity
