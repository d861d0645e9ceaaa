// Holds the curves of a recording to the extremes, contacts and marks of made-up ticks.

#include "app/records/recording_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr std::int64_t kTick_ns = 1'000'000;

struct Samples {
  std::vector<double> time_s{};
  std::vector<double> values{};
};

/// A wave that no sampling of it in steps would hit the crests of, and one spike.
Samples spiky_samples(std::size_t n) {
  Samples samples{};
  for (std::size_t i = 0; i < n; ++i) {
    samples.time_s.push_back(1e-3 * static_cast<double>(i));
    samples.values.push_back(std::sin(0.7919 * static_cast<double>(i)));
  }
  samples.values[n / 3] = 7.0;
  samples.values[n / 2 + 1] = -5.0;
  return samples;
}

TEST(Envelope, HoldsTheExtremesOfEveryColumn) {
  const Samples samples = spiky_samples(60000);
  constexpr int kColumns = 500;
  const auto points =
      envelope_of(samples.time_s, samples.values, {0.0, samples.time_s.back()}, kColumns);
  ASSERT_EQ(points.size(), 2U * kColumns);
  for (std::size_t column = 0; column < kColumns; ++column) {
    const auto begin = samples.values.begin() + static_cast<std::ptrdiff_t>(column * 120);
    const auto [lowest, highest] = std::minmax_element(begin, begin + 120);
    const auto [first, second] =
        std::minmax(points[2 * column].value, points[2 * column + 1].value);
    EXPECT_EQ(first, *lowest);
    EXPECT_EQ(second, *highest);
  }
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                             [](const auto& a, const auto& b) { return a.time_s < b.time_s; }));
}

TEST(Envelope, IsTheSamplesThemselvesFromNearBy) {
  const Samples samples = spiky_samples(60000);
  const auto points = envelope_of(samples.time_s, samples.values, {10.0005, 10.1005}, 500);
  ASSERT_EQ(points.size(), 102U);  // 100 within, one on either side
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].time_s, samples.time_s[10000 + i]);
    EXPECT_EQ(points[i].value, samples.values[10000 + i]);
  }
}

TEST(Envelope, LeavesOutWhatIsNoNumber) {
  Samples samples = spiky_samples(1000);
  samples.values[500] = std::numeric_limits<double>::quiet_NaN();
  for (const int columns : {10, 5000}) {
    for (const CurvePoint& point :
         envelope_of(samples.time_s, samples.values, {0.0, 1.0}, columns)) {
      EXPECT_TRUE(std::isfinite(point.value));
    }
  }
  EXPECT_TRUE(envelope_of({}, {}, {0.0, 1.0}, 10).empty());
}

TickRecord tick_at(int tick, std::uint64_t presentation, double penetration_m) {
  TickRecord record{};
  record.probe.time_ns = 5'000'000'000 + tick * kTick_ns;
  record.probe.position_m = {1e-5 * tick, 0.0, -penetration_m};
  record.probe.velocity_m_per_s = {0.03, 0.04, 9.0};
  record.presentation = presentation;
  record.penetration_m = penetration_m;
  record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
  // 1 N and a vibration of 0.5 N at 100 Hz.
  record.sent.force_N.z = 1.0 + 0.5 * std::sin(2.0 * std::numbers::pi * 0.1 * tick);
  return record;
}

TEST(RecordingCurves, CutContactsWhereTheHandLiftsAndNotAtACrest) {
  std::vector<TickRecord> records{};
  for (int tick = 0; tick < 3000; ++tick) {
    const bool lifted = tick < 100 || (tick >= 1000 && tick < 1200) || tick >= 2900;
    const bool crest = tick == 500;
    records.push_back(tick_at(tick, 1, lifted || crest ? 0.0 : 1e-3));
  }
  const RecordingCurves curves = curves_of(records, 1000.0, 5'000'000'000);
  ASSERT_EQ(curves.contacts.size(), 2U);
  EXPECT_NEAR(curves.contacts[0].begin_s, 0.1, 1e-9);
  EXPECT_NEAR(curves.contacts[0].end_s, 0.999, 1e-9);
  EXPECT_NEAR(curves.contacts[1].begin_s, 1.2, 1e-9);
  // Along the surface: (0.03, 0.04) is 0.05; the 9 m/s are across it.
  EXPECT_NEAR(curves.speed_m_per_s[7], 0.05, 1e-12);
  ASSERT_EQ(curves.surfaces.size(), 1U);
  EXPECT_NEAR(curves.surfaces[0].longest_contact.begin_s, 1.2, 1e-9);
  const PowerSpectrum& spectrum = *curves.surfaces[0].spectrum;
  const auto highest = std::max_element(spectrum.density.begin(), spectrum.density.end());
  EXPECT_NEAR(spectrum.spacing_Hz * static_cast<double>(highest - spectrum.density.begin()), 100.0,
              spectrum.spacing_Hz);
}

// Of a mouse, which has no motors.
TEST(RecordingCurves, HaveTheSpectrumOfTheRenderedForceWhereNoneWasSent) {
  std::vector<TickRecord> records{};
  for (int tick = 0; tick < 2000; ++tick) {
    TickRecord& record = records.emplace_back(tick_at(tick, 1, 1e-3));
    std::swap(record.rendered, record.sent);
  }
  const RecordingCurves curves = curves_of(records, 1000.0, 5'000'000'000);
  EXPECT_TRUE(curves.surfaces[0].is_spectrum_of_rendered);
  const PowerSpectrum& spectrum = curves.surfaces[0].spectrum.value();
  const auto highest = std::max_element(spectrum.density.begin(), spectrum.density.end());
  EXPECT_GT(*highest, 0.0);
  EXPECT_NEAR(spectrum.spacing_Hz * static_cast<double>(highest - spectrum.density.begin()), 100.0,
              spectrum.spacing_Hz);
}

TEST(RecordingCurves, MarkMissedAndLimitedTicksWhereTheyWere) {
  std::vector<TickRecord> records{};
  for (int tick = 0; tick < 100; ++tick) records.push_back(tick_at(tick, 2, 0.0));
  records[30].flags |= static_cast<std::uint32_t>(TickFlag::missed_deadline);
  records[40].flags |= static_cast<std::uint32_t>(TickFlag::limited_slew);
  const RecordingCurves curves = curves_of(records, 1000.0, 5'000'000'000);
  ASSERT_EQ(curves.missed_s.size(), 1U);
  EXPECT_NEAR(curves.missed_s[0], 0.030, 1e-9);
  ASSERT_EQ(curves.limited_s.size(), 1U);
  EXPECT_NEAR(curves.limited_s[0], 0.040, 1e-9);
  EXPECT_EQ(curves.surfaces[0].position, 2);
  EXPECT_FALSE(curves.surfaces[0].spectrum);  // it was never touched
}

}  // namespace
}  // namespace asperity
