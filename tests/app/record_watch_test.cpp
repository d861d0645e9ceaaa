// What a monitor is told of the ticks of a session, and which buttons go down.

#include "app/session/rig/record_watch.h"

#include <algorithm>
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
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
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
    record.gain = 1.0;
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

/// Ticks of a hand on a surface; it strokes to and fro along −y, 50 mm each way.
class Stroking {
 public:
  explicit Stroking(RecordWatch& watch) : watch_(watch) {}

  void touch(std::uint64_t presentation, double force_N, double speed_m_per_s, double for_s,
             double gain = 1.0) {
    for (int i = 0; i < std::lround(for_s * 1e3); ++i) {
      gone_m_ += 1e-3 * speed_m_per_s;
      TickRecord record = tick_at(++tick_);
      const double to_and_fro_m = std::fmod(gone_m_, 0.1);
      record.probe.position_m = {0.01, -std::min(to_and_fro_m, 0.1 - to_and_fro_m), 0.0};
      record.presentation = presentation;
      record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
      record.penetration_m = 1e-4;
      record.gain = gain;
      record.sent.force_N = {0.3, 0.0, force_N};
      watch_.take(record);
    }
  }
  void lift(double for_s) {
    for (int i = 0; i < std::lround(for_s * 1e3); ++i) watch_.take(tick_at(++tick_));
    gone_m_ = 0.0;
  }
  void skip(double for_s) {
    for (int i = 0; i < std::lround(for_s * 1e3); ++i) watch_.take(tick_at(++tick_));
  }

 private:
  RecordWatch& watch_;
  int tick_ = 0;
  double gone_m_ = 0.0;
};

constexpr double kAlongMinusY_rad = -1.5707963267948966;

TEST(RecordWatch, CountsHowTheHandMeetsItsBandsSurfaceBySurface) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  watch.begin_attempt({.normal_force_N = {0.75, 1.25},
                       .speed_m_per_s = {0.06, {}},
                       .direction_rad = kAlongMinusY_rad});
  EXPECT_EQ(watch.hand().so_far().surface, 0);
  Stroking hand(watch);
  hand.touch(1, 0.9, 0.05, 1.0);  // one stroke
  hand.touch(1, 0.9, 0.1, 1.0);   // two
  hand.touch(1, 0.9, 0.1, 0.2);   // and one that a lift cuts off
  HandSoFar met = watch.hand().so_far();
  EXPECT_EQ(met.surface, 1);
  EXPECT_EQ(met.force_N.samples, 2200);
  EXPECT_NEAR(met.force_N.mean, 0.9, 1e-12);
  EXPECT_NEAR(met.force_N.sd, 0.0, 1e-12);
  EXPECT_EQ(met.force_N.fraction_in_band, 1.0);
  ASSERT_EQ(met.speed_m_per_s.samples, 3);
  EXPECT_NEAR(met.speed_m_per_s.mean, 0.25 / 3.0, 1e-3);
  EXPECT_NEAR(*met.speed_m_per_s.fraction_in_band, 2.0 / 3.0, 1e-12);
  hand.lift(0.5);
  EXPECT_EQ(watch.hand().so_far().speed_m_per_s.samples, 3);

  hand.touch(2, 1.5, 0.06, 0.001);
  met = watch.hand().so_far();
  EXPECT_EQ(met.surface, 2);
  EXPECT_EQ(met.force_N.samples, 1);
  EXPECT_EQ(met.force_N.fraction_in_band, 0.0);
  EXPECT_EQ(met.speed_m_per_s.samples, 0);
  EXPECT_FALSE(met.speed_m_per_s.fraction_in_band);
  hand.lift(0.5);
  hand.touch(1, 1.5, 0.06, 0.001);  // felt again: goes on counting
  EXPECT_EQ(watch.hand().so_far().force_N.samples, 2201);
  watch.begin_attempt({});
  EXPECT_EQ(watch.hand().so_far().surface, 0);
}

// A hand that lifts and sets down where it began has not stroked back.
TEST(RecordWatch, TakesTheWayThroughTheAirForNoStroke) {
  RecordWatch watch(nullptr);
  watch.begin_attempt({.speed_m_per_s = {0.06, {}}, .direction_rad = kAlongMinusY_rad});
  Stroking hand(watch);
  hand.touch(1, 0.9, 0.1, 0.4);
  hand.lift(0.2);
  hand.touch(1, 0.9, 0.05, 0.8);
  const HandSoFar met = watch.hand().so_far();
  EXPECT_EQ(met.speed_m_per_s.samples, 2);
  EXPECT_NEAR(met.speed_m_per_s.mean, 0.075, 1e-3);
  EXPECT_EQ(met.speed_m_per_s.fraction_in_band, 0.5);
}

TEST(RecordWatch, HoldsNoSurfaceAgainstTheHandThatIsNotWhollyThere) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  watch.begin_attempt({.normal_force_N = {0.75, 1.25}});
  Stroking hand(watch);
  hand.touch(1, 0.0, 0.05, 0.3, 0.0);
  hand.touch(1, 0.4, 0.05, 0.3, 0.5);
  EXPECT_EQ(watch.hand().so_far().force_N.samples, 0);
  EXPECT_EQ(watch.hand().tone(), GuideTone::none);
  std::vector<LiveBin> bins{};
  monitor.bins_from(0, bins);
  EXPECT_TRUE(bins.back().touching);
  EXPECT_FALSE(bins.back().is_felt);
  hand.touch(1, 0.9, 0.05, 0.3);
  monitor.bins_from(0, bins);
  EXPECT_TRUE(bins.back().is_felt);
  EXPECT_EQ(watch.hand().so_far().force_N.fraction_in_band, 1.0);
  hand.touch(1, 0.4, 0.05, 0.3, 0.5);  // it fades away
  EXPECT_EQ(watch.hand().so_far().force_N.fraction_in_band, 1.0);
  EXPECT_EQ(watch.hand().tone(), GuideTone::none);
}

// A stiff surface throws the tip off its crests: 10 ms in the air, 20 ms pressed with half as much again.
TEST(RecordWatch, TakesATipThatSkipsOverATextureForAHandThatStrokesOn) {
  SessionMonitor monitor;
  RecordWatch watch(&monitor);
  watch.begin_attempt({.normal_force_N = {0.75, 1.25},
                       .speed_m_per_s = {0.08, 0.12},
                       .direction_rad = kAlongMinusY_rad});
  Stroking hand(watch);
  for (int i = 0; i < 100; ++i) {
    hand.touch(1, 1.5, 0.15, 0.02);  // 0.1 m/s with what it goes in the air
    hand.skip(0.01);
    if (i < 30) continue;
    EXPECT_TRUE(watch.hand().now());
    EXPECT_EQ(watch.hand().tone(), GuideTone::none) << i;
  }
  const HandSoFar met = watch.hand().so_far();
  EXPECT_EQ(met.speed_m_per_s.samples, 5);
  EXPECT_NEAR(met.speed_m_per_s.mean, 0.1, 0.003);
  EXPECT_NEAR(watch.hand().now()->pressing_N, 1.0, 0.06);
}

TEST(RecordWatch, TellsTheHandOfItsForceFirstAndOfItsSpeedByTheStroke) {
  RecordWatch watch(nullptr);  // whoever hears tones needs no monitor
  watch.begin_attempt({.normal_force_N = {0.75, 1.25},
                       .speed_m_per_s = {0.05, 0.08},
                       .direction_rad = kAlongMinusY_rad,
                       .usual_stroke_m = 0.05});
  Stroking hand(watch);
  // Between contacts, so that the force of one is forgotten in the next.
  const auto tone_at = [&](double force_N, double speed_m_per_s) {
    hand.lift(0.2);
    EXPECT_EQ(watch.hand().tone(), GuideTone::none);
    hand.touch(1, force_N, speed_m_per_s, 0.04 / speed_m_per_s);
    return watch.hand().tone();
  };
  EXPECT_EQ(tone_at(0.9, 0.06), GuideTone::none);
  EXPECT_EQ(tone_at(0.7, 0.06), GuideTone::press_more);
  EXPECT_EQ(tone_at(1.5, 0.06), GuideTone::press_less);
  EXPECT_EQ(tone_at(1.5, 0.09), GuideTone::press_less);
  EXPECT_EQ(tone_at(0.9, 0.09), GuideTone::slower);
  EXPECT_EQ(tone_at(0.9, 0.04), GuideTone::faster);
  EXPECT_EQ(tone_at(0.9, 0.06), GuideTone::none);
  hand.touch(1, 0.9, 0.0, 0.74);  // a turn
  EXPECT_EQ(watch.hand().tone(), GuideTone::none);
  hand.touch(1, 0.9, 0.0, 0.02);
  EXPECT_EQ(watch.hand().tone(), GuideTone::faster);  // no turn takes so long
}

// A hand that speeds up from rest and slows down to it, as fast on the whole as is asked.
TEST(RecordWatch, TellsAHandThatIsOnTargetNothingWhileItTurns) {
  RecordWatch watch(nullptr);
  watch.begin_attempt({.speed_m_per_s = {0.08, 0.12}, .usual_stroke_m = 0.05});
  for (int i = 0; i < 4000; ++i) {
    TickRecord record = tick_at(i);
    record.probe.position_m.x = -0.025 * std::cos(3.14159265 * i / 500.0);  // 50 mm in 0.5 s
    record.presentation = 1;
    record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
    record.penetration_m = 1e-4;
    record.gain = 1.0;
    watch.take(record);
    EXPECT_EQ(watch.hand().tone(), GuideTone::none) << i;
  }
  EXPECT_EQ(watch.hand().so_far().speed_m_per_s.fraction_in_band, 1.0);
}

TEST(RecordWatch, KeepsAToneUntilTheHandIsWellInsideItsBand) {
  RecordWatch watch(nullptr);
  watch.begin_attempt({.normal_force_N = {0.5, 1.5}});
  Stroking hand(watch);
  const auto tone_at = [&](double force_N) {
    hand.touch(1, force_N, 0.05, 3.0);
    return watch.hand().tone();
  };
  EXPECT_EQ(tone_at(0.52), GuideTone::none);
  EXPECT_EQ(tone_at(0.48), GuideTone::press_more);
  EXPECT_EQ(tone_at(0.58), GuideTone::press_more);
  EXPECT_EQ(tone_at(0.62), GuideTone::none);
  EXPECT_EQ(tone_at(0.52), GuideTone::none);
  EXPECT_EQ(tone_at(1.52), GuideTone::press_less);
  EXPECT_EQ(tone_at(1.42), GuideTone::press_less);
  EXPECT_EQ(tone_at(1.38), GuideTone::none);
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
