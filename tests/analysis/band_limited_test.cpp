// Band-limited interpolation: waves between their samples, and what a lower rate does not keep.

#include "analysis/signals/band_limited.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

std::vector<double> sampled_wave(double frequency) {
  std::vector<double> wave{};
  for (int i = 0; i < 200; ++i) {
    wave.push_back(std::cos(2.0 * std::numbers::pi * frequency * i + 0.4));
  }
  return wave;
}

/// The RMS of the values, divided by that of the wave.
double relative_rms(double frequency, double rate) {
  const BandLimitedInterpolation between;
  const std::vector<double> wave = sampled_wave(frequency);
  double sum = 0.0;
  constexpr int kPlaces = 1700;
  for (int i = 0; i < kPlaces; ++i) {
    sum += std::pow(between.value(wave, 50.0 + 0.0577 * i, rate), 2);
  }
  return std::sqrt(2.0 * sum / kPlaces);
}

TEST(BandLimited, IsTheSampleAtASample) {
  const BandLimitedInterpolation between;
  const std::vector<double> wave = sampled_wave(0.31);
  for (std::size_t i = 0; i < wave.size(); ++i) {
    EXPECT_NEAR(between.value(wave, static_cast<double>(i)), wave[i], 1e-12);
  }
}

TEST(BandLimited, ContinuesAWaveBetweenItsSamples) {
  const BandLimitedInterpolation between;
  for (const double frequency : {0.01, 0.1, 0.3, 0.42}) {
    const std::vector<double> wave = sampled_wave(frequency);
    for (double place = 50.0; place < 150.0; place += 0.37) {
      EXPECT_NEAR(between.value(wave, place),
                  std::cos(2.0 * std::numbers::pi * frequency * place + 0.4), 0.006)
          << frequency;
    }
  }
}

TEST(BandLimited, KeepsWhatIsBelowHalfOfALowerRateOnly) {
  EXPECT_NEAR(relative_rms(0.20, 0.5), 1.0, 0.006);
  EXPECT_NEAR(relative_rms(0.25, 0.5), 0.5, 0.02);
  EXPECT_LT(relative_rms(0.29, 0.5), 0.004);
  EXPECT_LT(relative_rms(0.45, 0.5), 0.004);
}

}  // namespace
}  // namespace asperity
