// The deadlines of the servo, without a clock.

#include "renderers/servo/servo_time.h"

#include <gtest/gtest.h>

#include "renderers/servo/tick_record.h"

namespace asperity {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr DeadlineGrid kGrid{.first_ns = 100 * kMs, .period_ns = kMs};

TEST(DeadlineGrid, ContinuesAfterAPunctualTick) {
  const NextTick next = kGrid.after(105 * kMs + 20'000, 105 * kMs + 90'000);
  EXPECT_EQ(next.due_ns, 106 * kMs);
  EXPECT_EQ(next.wake_ns, 106 * kMs);
}

TEST(DeadlineGrid, StaysOnTheOriginalGridAfterALateStart) {
  // Due at 105 ms, woken at 108.4 ms: that lateness is already counted; the next is due at 109 ms.
  const NextTick next = kGrid.after(108 * kMs + 400'000, 108 * kMs + 450'000);
  EXPECT_EQ(next.due_ns, 109 * kMs);
  EXPECT_EQ(next.wake_ns, 109 * kMs);
}

TEST(DeadlineGrid, CountsTheDeadlineThatALongTickMissedAndSkipsTheRest) {
  // Began at 105 ms, took 20.3 ms: wakes at 126 ms for the deadline of 106 ms, 20 periods late.
  const NextTick next = kGrid.after(105 * kMs, 125 * kMs + 300'000);
  EXPECT_EQ(next.due_ns, 106 * kMs);
  EXPECT_EQ(next.wake_ns, 126 * kMs);
  // And from there on punctually again: no burst.
  const NextTick after_that = kGrid.after(126 * kMs + 1'000, 126 * kMs + 50'000);
  EXPECT_EQ(after_that.due_ns, 127 * kMs);
  EXPECT_EQ(after_that.wake_ns, 127 * kMs);
}

TEST(ClampedDt, StaysWithinHalfAPeriodAndFour) {
  EXPECT_DOUBLE_EQ(clamped_dt_s(0, kMs, 1000.0), 0.001);
  EXPECT_DOUBLE_EQ(clamped_dt_s(0, 2'500'000, 1000.0), 0.0025);
  EXPECT_DOUBLE_EQ(clamped_dt_s(0, 0, 1000.0), 0.0005);
  EXPECT_DOUBLE_EQ(clamped_dt_s(kMs, 0, 1000.0), 0.0005);
  EXPECT_DOUBLE_EQ(clamped_dt_s(0, 300 * kMs, 1000.0), 0.004);
  EXPECT_DOUBLE_EQ(clamped_dt_s(0, 300 * kMs, 4000.0), 0.001);
}

TEST(RoundedForRecording, IsWhatFloatsGiveBack) {
  ProbeState probe;
  probe.time_ns = 123'456'789'012'345'678;
  probe.position_m = {0.1, -0.2, 1.0 / 3.0};
  probe.velocity_m_per_s.y = 0.3;
  probe.angular_velocity_rad_per_s.z = 0.7;
  probe.orientation = {0.1, 0.2, 0.3, 0.4};
  probe.buttons = 5;
  const ProbeState rounded = rounded_for_recording(probe);
  EXPECT_EQ(rounded.time_ns, probe.time_ns);
  EXPECT_EQ(rounded.buttons, 5U);
  EXPECT_EQ(rounded.position_m, glm::dvec3(0.1F, -0.2F, static_cast<float>(1.0 / 3.0)));
  EXPECT_EQ(rounded.velocity_m_per_s.y, static_cast<double>(0.3F));
  EXPECT_EQ(rounded.angular_velocity_rad_per_s.z, static_cast<double>(0.7F));
  EXPECT_EQ(rounded.orientation.w, static_cast<double>(0.1F));
  EXPECT_EQ(rounded.orientation.z, static_cast<double>(0.4F));
}

}  // namespace
}  // namespace asperity
