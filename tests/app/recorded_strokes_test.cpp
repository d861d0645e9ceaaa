// The strokes in the recording of a hand.

#include "app/records/recorded_strokes.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr std::uint64_t kPatch = 2;

/// To and fro over ±30 mm with up to 94 mm/s, with 1 N on a plate with a friction of 0.2 and a vibration of 0.1 N along
/// the normal.
std::vector<TickRecord> hand_to_and_fro() {
  std::vector<TickRecord> records{};
  for (int i = 0; i < 4000; ++i) {
    const double time_s = i / 1000.0;
    const double rate = 3.1416;
    TickRecord record{.presentation = kPatch,
                      .flags = static_cast<std::uint32_t>(TickFlag::presenting)};
    record.probe.time_ns = i * 1'000'000LL;
    record.probe.position_m = {0.03 * std::sin(rate * time_s), 0.0, -0.002};
    record.probe.velocity_m_per_s = {0.03 * rate * std::cos(rate * time_s), 0.0, 0.0};
    record.penetration_m = 0.002;
    record.gain = 1.0;
    record.sent.force_N = {record.probe.velocity_m_per_s.x > 0.0 ? -0.2 : 0.2, 0.0,
                           1.0 + 0.1 * std::sin(300.0 * time_s)};
    records.push_back(record);
  }
  return records;
}

TEST(StrokesOfAHand, AreUninterruptedInOneDirectionAndHaveTheForceAgainstTheMotion) {
  const std::vector<TickRecord> records = hand_to_and_fro();
  const TextureRecording recording = strokes_of_hand({.records = records, .presentation = kPatch});
  // 0.87 s of each half period of 1 s are faster than 20 mm/s: three strokes of 0.25 s in each, in the first and the
  // last half of them one.
  ASSERT_EQ(recording.strokes.size(), 11U);
  for (const RecordedStroke& stroke : recording.strokes) {
    EXPECT_EQ(stroke.time_s.size(), 250U);
    EXPECT_GE(stroke.speed_m_per_s(), 0.02);
    EXPECT_LE(stroke.speed_m_per_s(), 0.0943);
    EXPECT_NEAR(stroke.mean_normal_N(), 1.0, 0.02);
    for (const double force_N : stroke.force_N) ASSERT_EQ(force_N, 0.2);
  }
  EXPECT_NO_THROW(require_strokes(recording, "the hand"));
}

TEST(StrokesOfAHand, HaveTheNormalForceOnRequest) {
  const std::vector<TickRecord> records = hand_to_and_fro();
  const TextureRecording recording = strokes_of_hand(
      {.records = records, .presentation = kPatch, .component = TextureComponent::normal});
  ASSERT_FALSE(recording.strokes.empty());
  EXPECT_EQ(recording.strokes[0].force_N, recording.strokes[0].normal_N);
}

TEST(StrokesOfAHand, LeaveOutOtherSurfacesLiftsGapsAndFadingSurfaces) {
  const std::vector<TickRecord> records = hand_to_and_fro();
  EXPECT_TRUE(strokes_of_hand({.records = records, .presentation = 1}).strokes.empty());
  const auto without = [&records](const auto& change) {
    std::vector<TickRecord> changed = records;
    for (std::size_t i = 0; i < changed.size(); i += 200) change(changed[i]);
    return strokes_of_hand({.records = changed, .presentation = kPatch}).strokes.size();
  };
  EXPECT_EQ(without([](TickRecord& record) { record.penetration_m = 0.0; }), 0U);
  EXPECT_EQ(without([](TickRecord& record) { record.gain = 0.5; }), 0U);
  EXPECT_EQ(without([](TickRecord& record) { record.flags = 0; }), 0U);
  std::vector<TickRecord> late = records;
  for (std::size_t i = 0; i < late.size(); ++i) {
    late[i].probe.time_ns += static_cast<std::int64_t>(i / 200) * 10'000'000LL;
  }
  EXPECT_TRUE(strokes_of_hand({.records = late, .presentation = kPatch}).strokes.empty());
}

}  // namespace
}  // namespace asperity
