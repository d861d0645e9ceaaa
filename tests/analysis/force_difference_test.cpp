// The difference of two forces, in all and in nine bands of frequency.

#include "analysis/signals/force_difference.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kServoRate_Hz = 1000.0;
constexpr std::size_t kSamples =
    2000;  // 2 s: a whole number of periods of every multiple of 0.5 Hz

std::vector<double> sinusoid_N(double amplitude_N, double frequency_Hz) {
  std::vector<double> force_N(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    force_N[i] = amplitude_N * std::sin(2.0 * std::numbers::pi * frequency_Hz *
                                        static_cast<double>(i) / kServoRate_Hz);
  }
  return force_N;
}

ForceDifference normal_difference(const std::vector<double>& recorded_N,
                                  const std::vector<double>& compared_N) {
  const std::vector<double> none_N(kSamples);
  return force_difference({.x_N = none_N, .y_N = none_N, .z_N = recorded_N},
                          {.x_N = none_N, .y_N = none_N, .z_N = compared_N}, kServoRate_Hz);
}

double in_bands_N2_s(const ForceEnergy& energy) {
  return std::accumulate(energy.bands_N2_s.begin(), energy.bands_N2_s.end(), 0.0);
}

TEST(ForceDifference, OfTwiceAForceIsTheForce) {
  const ForceDifference found = normal_difference(sinusoid_N(0.3, 90.0), sinusoid_N(0.6, 90.0));
  const double rms_N = 0.3 / std::numbers::sqrt2;
  EXPECT_EQ(found.samples, kSamples);
  EXPECT_NEAR(found.duration_s, 2.0, 1e-12);
  EXPECT_NEAR(found.rms_N(found.recorded), rms_N, 1e-12);
  EXPECT_NEAR(found.rms_N(found.compared), 2.0 * rms_N, 1e-12);
  EXPECT_NEAR(found.rms_N(found.difference), rms_N, 1e-12);
  // After 25 samples 2.25 periods have passed: a crest.
  EXPECT_NEAR(found.largest_N, 0.3, 1e-12);
}

TEST(ForceDifference, OfEqualForcesIsExactlyZero) {
  const std::vector<double> force_N = sinusoid_N(0.3, 91.7);
  const ForceDifference found = normal_difference(force_N, force_N);
  EXPECT_EQ(found.difference.total_N2_s, 0.0);
  EXPECT_EQ(in_bands_N2_s(found.difference), 0.0);
  EXPECT_EQ(found.largest_N, 0.0);
  EXPECT_GT(found.recorded.total_N2_s, 0.0);
}

// A sinusoid of amplitude A that lasts T seconds has the energy A²·T/2, all of it in the band of its frequency.
TEST(ForceDifference, HasTheEnergyOfASinusoidInTheBandOfItsFrequency) {
  struct Case {
    double frequency_Hz = 0.0;
    std::size_t band = 0;
  };
  for (const Case& each : {Case{8.0, 0}, Case{12.0, 0}, Case{12.5, 1}, Case{25.0, 2}, Case{40.0, 3},
                           Case{49.5, 3}, Case{50.0, 4}, Case{100.0, 5}, Case{160.0, 6},
                           Case{250.0, 7}, Case{315.0, 8}, Case{499.5, 8}}) {
    SCOPED_TRACE(each.frequency_Hz);
    const ForceDifference found =
        normal_difference(std::vector<double>(kSamples), sinusoid_N(0.2, each.frequency_Hz));
    const double energy_N2_s = 0.2 * 0.2 * 2.0 / 2.0;
    EXPECT_NEAR(found.difference.total_N2_s, energy_N2_s, 1e-12);
    for (std::size_t band = 0; band < kCriticalBands; ++band) {
      EXPECT_NEAR(found.difference.bands_N2_s[band], band == each.band ? energy_N2_s : 0.0, 1e-12)
          << band;
    }
  }
}

// The line at half the rate has no twin: alternating ±A has the energy A²·T, in the last band.
TEST(ForceDifference, CountsTheLineAtHalfTheRateOnce) {
  std::vector<double> alternating_N(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) alternating_N[i] = i % 2 == 0 ? 0.5 : -0.5;
  const ForceDifference found = normal_difference(std::vector<double>(kSamples), alternating_N);
  EXPECT_NEAR(found.difference.bands_N2_s.back(), 0.5 * 0.5 * 2.0, 1e-12);
  EXPECT_NEAR(found.difference.total_N2_s, 0.5 * 0.5 * 2.0, 1e-12);
}

TEST(ForceDifference, LeavesTheMeanAndSlowChangesOutOfTheBands) {
  std::vector<double> pressed_N = sinusoid_N(0.1, 7.5);
  for (double& force_N : pressed_N) force_N += 2.0;
  const ForceDifference found = normal_difference(std::vector<double>(kSamples), pressed_N);
  EXPECT_NEAR(found.difference.total_N2_s, 2.0 * (2.0 * 2.0 + 0.1 * 0.1 / 2.0), 1e-9);
  EXPECT_NEAR(in_bands_N2_s(found.difference), 0.0, 1e-12);
}

// √(3² + 4² + 12²) = 13, and the energies of the components add up.
TEST(ForceDifference, IsThatOfVectors) {
  const std::vector<double> none_N(4);
  const std::vector<double> x_N(4, 3.0);
  const std::vector<double> y_N(4, -4.0);
  const std::vector<double> z_N(4, 12.0);
  const ForceDifference found =
      force_difference({.x_N = none_N, .y_N = none_N, .z_N = none_N},
                       {.x_N = x_N, .y_N = y_N, .z_N = z_N}, kServoRate_Hz);
  EXPECT_DOUBLE_EQ(found.largest_N, 13.0);
  EXPECT_NEAR(found.rms_N(found.difference), 13.0, 1e-12);
}

TEST(ForceDifference, OfSeveralStretchesIsPooledByTheirDurations) {
  ForceDifference pooled =
      normal_difference(std::vector<double>(kSamples), std::vector<double>(kSamples, 1.0));
  const std::vector<double> none_N(6000);
  const std::vector<double> strong_N(6000, 3.0);
  pooled.add(force_difference({.x_N = none_N, .y_N = none_N, .z_N = none_N},
                              {.x_N = strong_N, .y_N = none_N, .z_N = none_N}, kServoRate_Hz));
  EXPECT_EQ(pooled.samples, 8000U);
  EXPECT_NEAR(pooled.rms_N(pooled.difference), std::sqrt((2.0 * 1.0 + 6.0 * 9.0) / 8.0), 1e-12);
  EXPECT_DOUBLE_EQ(pooled.largest_N, 3.0);
}

TEST(ForceDifference, OfNothingIsNothing) {
  const ForceDifference found = force_difference({}, {}, kServoRate_Hz);
  EXPECT_EQ(found.samples, 0U);
  EXPECT_EQ(found.rms_N(found.difference), 0.0);
}

TEST(ForceDifference, RefusesDifferentLengthsAndRatesThatAreNone) {
  const std::vector<double> one_N(1);
  EXPECT_THROW(force_difference({.x_N = one_N}, {}, kServoRate_Hz), std::invalid_argument);
  EXPECT_THROW(force_difference({}, {}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
