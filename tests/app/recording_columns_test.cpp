// A tick record as its recording will give it again.

#include "app/session/rig/recording_columns.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

TickRecord random_record(Random& random) {
  const auto vector = [&random] {
    return glm::dvec3{random.normal(), random.normal(), random.normal()};
  };
  TickRecord record{};
  record.probe.time_ns = 1'234'567'890'123'456'789;
  record.probe.position_m = vector();
  record.probe.orientation =
      glm::dquat{random.normal(), random.normal(), random.normal(), random.normal()};
  record.probe.velocity_m_per_s = vector();
  record.probe.angular_velocity_rad_per_s = vector();
  record.probe.buttons = 0x00FF00FF;
  record.rendered = {vector(), vector()};
  record.sent = {vector(), vector()};
  record.penetration_m = random.uniform();
  record.gain = random.uniform();
  record.presentation = 7;
  record.flags = 0x3FF;
  record.lateness_ns = 1500;
  record.execution_ns = 250;
  return record;
}

bool is_float(double value) {
  // Through memory, so that no compiler can reason the rounding away (some do, see
  // AsperityTargets).
  volatile float rounded = static_cast<float>(value);
  return static_cast<double>(rounded) == value;
}

bool is_float(const glm::dvec3& v) { return is_float(v.x) && is_float(v.y) && is_float(v.z); }

TEST(RecordingColumns, RoundEveryComponentToWhatTheFileHolds) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const TickRecord record = as_recorded(random_record(random));
    EXPECT_TRUE(is_float(record.probe.position_m));
    EXPECT_TRUE(is_float(record.probe.orientation.w) && is_float(record.probe.orientation.x) &&
                is_float(record.probe.orientation.y) && is_float(record.probe.orientation.z));
    EXPECT_TRUE(is_float(record.probe.velocity_m_per_s));
    EXPECT_TRUE(is_float(record.probe.angular_velocity_rad_per_s));
    EXPECT_TRUE(is_float(record.rendered.force_N) && is_float(record.rendered.torque_N_m));
    EXPECT_TRUE(is_float(record.sent.force_N) && is_float(record.sent.torque_N_m));
    EXPECT_TRUE(is_float(record.penetration_m) && is_float(record.gain));
  }
}

TEST(RecordingColumns, RoundAProbeAsTheServoDoes) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const TickRecord record = random_record(random);
    const ProbeState servo = rounded_for_recording(record.probe);
    const ProbeState recorded = as_recorded(record).probe;
    EXPECT_EQ(servo.position_m, recorded.position_m);
    EXPECT_EQ(servo.orientation, recorded.orientation);
    EXPECT_EQ(servo.velocity_m_per_s, recorded.velocity_m_per_s);
    EXPECT_EQ(servo.angular_velocity_rad_per_s, recorded.angular_velocity_rad_per_s);
    EXPECT_TRUE(is_float(servo.position_m));
  }
}

TEST(RecordingColumns, GiveBackTheWholeNumbers) {
  Random random(3);
  const TickRecord record = as_recorded(random_record(random));
  EXPECT_EQ(record.probe.time_ns, 1'234'567'890'123'456'789);
  EXPECT_EQ(record.probe.buttons, 0x00FF00FFU);
  EXPECT_EQ(record.presentation, 7U);
  EXPECT_EQ(record.flags, 0x3FFU);
}

TEST(RecordingColumns, AreStableOnceRounded) {
  Random random(4);
  const TickRecord once = as_recorded(random_record(random));
  const TickRecord twice = as_recorded(once);
  EXPECT_EQ(columns_of(once), columns_of(twice));
}

TEST(RecordingColumns, NameEveryValue) { EXPECT_EQ(recording_columns().size(), kRecordingColumns); }

}  // namespace
}  // namespace asperity
