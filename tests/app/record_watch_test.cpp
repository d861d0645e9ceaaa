// What a monitor is told of the ticks of a session, and which buttons go down.

#include "app/conductor/record_watch.h"

#include <cmath>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;

TickRecord tick_at(int number) {
  TickRecord record{};
  record.probe.time_ns = number * kTick_ns;
  return record;
}

TEST(RecordWatch, KeepsEveryPeakInABinOfASixtiethOfASecond) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  for (int i = 0; i < 100; ++i) {
    TickRecord record = tick_at(i);
    record.sent.force_N = {0.0, 0.0, i == 40 ? 5.0 : 1.0};
    record.probe.velocity_m_per_s = {0.03, i == 60 ? 0.04 : 0.0, 9.0};  // z is no speed along
    record.probe.position_m = {1e-3 * i, 0.0, 0.0};
    record.penetration_m = 1e-3;
    record.presentation = 2;
    watch.take(record);
  }
  std::vector<LiveBin> bins{};
  EXPECT_EQ(monitor.bins_from(0, bins), 5U);
  ASSERT_EQ(bins.size(), 5U);
  EXPECT_EQ(bins[0].time_ns, 16 * kTick_ns);  // ticks 0 to 16 lie in the first 16.7 ms
  EXPECT_EQ(bins[1].time_ns, 33 * kTick_ns);
  EXPECT_FLOAT_EQ(bins[1].force_maximum_N, 1.0F);
  EXPECT_FLOAT_EQ(bins[2].force_maximum_N, 5.0F);
  EXPECT_FLOAT_EQ(bins[2].force_minimum_N, 1.0F);
  EXPECT_FLOAT_EQ(bins[3].speed_minimum_m_per_s, 0.03F);
  EXPECT_FLOAT_EQ(bins[3].speed_maximum_m_per_s, 0.05F);
  EXPECT_FLOAT_EQ(bins[1].x_m, 0.033F);
  EXPECT_TRUE(bins[0].touching);
  EXPECT_EQ(bins[0].surface, 2);
}

TEST(RecordWatch, ShowsThePressWithoutTheTexture) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  for (int i = 0; i < 3000; ++i) {
    TickRecord record = tick_at(i);
    record.sent.force_N = {0.0, 0.0, 1.0 + 0.5 * std::sin(2.0 * 3.14159265 * 100.0 * 1e-3 * i)};
    record.penetration_m = 1e-4;
    record.presentation = 1;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    watch.take(record);
  }
  std::vector<LiveBin> bins{};
  monitor.bins_from(0, bins);
  // A first-order low-pass of 0.2 s leaves 1 / (2π · 100 Hz · 0.2 s) = 0.8 % of 100 Hz.
  EXPECT_NEAR(bins.back().pressing_N, 1.0, 0.006);
  EXPECT_GT(bins.back().force_maximum_N, 1.4F);
}

/// A tick on surface `presentation`, pressed with so many newtons at so many metres per second.
TickRecord touch_at(int number, std::uint64_t presentation, double force_N, double speed_m_per_s) {
  TickRecord record = tick_at(number);
  record.presentation = presentation;
  record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
  record.penetration_m = 1e-4;
  record.sent.force_N = {0.3, 0.0, force_N};
  record.probe.velocity_m_per_s = {0.0, -speed_m_per_s, 0.5};
  return record;
}

TEST(RecordWatch, CountsHowTheHandMeetsItsBandsSurfaceBySurface) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  watch.begin_attempt({.normal_force_N = {0.75, 1.25}, .speed_m_per_s = {0.05, {}}});
  EXPECT_EQ(watch.hand().surface, 0);
  int tick = 0;
  for (int i = 0; i < 100; ++i) watch.take(touch_at(++tick, 1, 0.9, i < 30 ? 0.04 : 0.06));
  for (int i = 0; i < 50; ++i) watch.take(touch_at(++tick, 1, 0.9, 0.005));  // a turn
  HandSoFar hand = watch.hand();
  EXPECT_EQ(hand.surface, 1);
  EXPECT_EQ(hand.force_N.samples, 150);
  EXPECT_NEAR(hand.force_N.mean, 0.9, 1e-12);
  EXPECT_NEAR(hand.force_N.sd, 0.0, 1e-12);
  EXPECT_EQ(hand.force_N.fraction_in_band, 1.0);
  EXPECT_EQ(hand.speed_m_per_s.samples, 100);
  EXPECT_NEAR(hand.speed_m_per_s.mean, 0.054, 1e-12);
  // √(100 · 0.3 · 0.7 · 0.02² / 99)
  EXPECT_NEAR(hand.speed_m_per_s.sd, 0.02 * std::sqrt(21.0 / 99.0), 1e-12);
  EXPECT_EQ(hand.speed_m_per_s.fraction_in_band, 0.7);

  watch.take(touch_at(++tick, 2, 1.5, 0.06));
  hand = watch.hand();
  EXPECT_EQ(hand.surface, 2);
  EXPECT_EQ(hand.force_N.samples, 1);
  EXPECT_EQ(hand.force_N.fraction_in_band, 0.0);
  watch.take(touch_at(++tick, 1, 1.5, 0.06));  // felt again: goes on counting
  EXPECT_EQ(watch.hand().force_N.samples, 151);
  watch.begin_attempt({});
  EXPECT_EQ(watch.hand().surface, 0);
}

TEST(RecordWatch, TellsTheHandOfItsForceFirstAndLeavesATurnAlone) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  watch.begin_attempt({.normal_force_N = {0.75, 1.25}, .speed_m_per_s = {0.05, 0.08}});
  int tick = 0;
  // Between contacts, so that the force of one is forgotten in the next.
  const auto tone_at = [&](double force_N, double speed_m_per_s) {
    watch.take(tick_at(++tick));
    EXPECT_EQ(watch.tone(), GuideTone::none);
    watch.take(touch_at(++tick, 1, force_N, speed_m_per_s));
    return watch.tone();
  };
  EXPECT_EQ(tone_at(0.9, 0.06), GuideTone::none);
  EXPECT_EQ(tone_at(0.7, 0.06), GuideTone::press_more);
  EXPECT_EQ(tone_at(1.5, 0.06), GuideTone::press_less);
  EXPECT_EQ(tone_at(1.5, 0.09), GuideTone::press_less);
  EXPECT_EQ(tone_at(0.9, 0.09), GuideTone::slower);
  EXPECT_EQ(tone_at(0.9, 0.04), GuideTone::faster);
  EXPECT_EQ(tone_at(0.9, 0.005), GuideTone::none);  // a turn
  for (int i = 0; i < 490; ++i) watch.take(touch_at(++tick, 1, 0.9, 0.005));
  EXPECT_EQ(watch.tone(), GuideTone::none);
  for (int i = 0; i < 20; ++i) watch.take(touch_at(++tick, 1, 0.9, 0.005));
  EXPECT_EQ(watch.tone(), GuideTone::faster);  // no turn takes so long
}

TEST(RecordWatch, SaysHowTheLoopHasKeptTimeInTheLastTwoSeconds) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  for (int i = 0; i < 10'000; ++i) {
    TickRecord record = tick_at(i);
    record.lateness_ns = i < 7000 ? 900'000 : i % 100 == 0 ? 50'000 : 10'000;
    if (i < 3) record.flags = static_cast<std::uint32_t>(TickFlag::missed_deadline);
    watch.take(record);
  }
  const LoopHealth health = watch.health();
  EXPECT_NEAR(health.rate_Hz, 1000.0, 1e-6);
  EXPECT_DOUBLE_EQ(health.lateness_p50_s, 10e-6);
  EXPECT_DOUBLE_EQ(health.lateness_p99_s, 10e-6);
  EXPECT_DOUBLE_EQ(health.lateness_maximum_s, 50e-6);  // what was before is over
  EXPECT_EQ(health.missed_deadlines, 3U);              // but is counted
}

TEST(RecordWatch, NoticesButtonsWithTheTimeOfTheirTick) {
  RecordWatch watch(nullptr);
  for (int i = 0; i < 10; ++i) {
    TickRecord record = tick_at(i);
    record.probe.buttons = i >= 3 && i < 7 ? 0b10U : 0U;
    watch.take(record);
  }
  const std::vector<ButtonChange> changes = watch.take_button_changes();
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].button, 2);
  EXPECT_TRUE(changes[0].down);
  EXPECT_EQ(changes[0].time_ns, 3 * kTick_ns);
  EXPECT_FALSE(changes[1].down);
  EXPECT_EQ(changes[1].time_ns, 7 * kTick_ns);
  EXPECT_TRUE(watch.take_button_changes().empty());
}

}  // namespace
}  // namespace asperity
