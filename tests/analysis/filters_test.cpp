// Holds the filters to Butterworth's formula and to a response worked out by hand.

#include "analysis/signals/filters.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr double kRate_Hz = 1000.0;

double warped(double frequency_Hz) { return std::tan(std::numbers::pi * frequency_Hz / kRate_Hz); }

TEST(ButterworthFilter, HasTheGainOfButterworthsFormula) {
  for (int order = 1; order <= 8; ++order) {
    const ButterworthFilter low(LowPass{.order = order, .cutoff_Hz = 80.0}, kRate_Hz);
    const ButterworthFilter high(HighPass{.order = order, .cutoff_Hz = 80.0}, kRate_Hz);
    const ButterworthFilter band(BandPass{.order = order, .low_Hz = 30.0, .high_Hz = 200.0},
                                 kRate_Hz);
    for (const double frequency_Hz : {1.0, 20.0, 80.0, 150.0, 333.0, 499.0}) {
      const double w = warped(frequency_Hz);
      const double ratio = std::pow(w / warped(80.0), 2 * order);
      EXPECT_NEAR(low.gain(frequency_Hz), 1.0 / std::sqrt(1.0 + ratio), 1e-9);
      EXPECT_NEAR(high.gain(frequency_Hz), 1.0 / std::sqrt(1.0 + 1.0 / ratio), 1e-9);
      const double x =
          (w * w - warped(30.0) * warped(200.0)) / (w * (warped(200.0) - warped(30.0)));
      EXPECT_NEAR(band.gain(frequency_Hz), 1.0 / std::sqrt(1.0 + std::pow(x, 2 * order)), 1e-9);
    }
  }
}

TEST(ButterworthFilter, PassesSqrtHalfAtItsCutoffs) {
  const ButterworthFilter band(BandPass{.order = 3, .low_Hz = 5.0, .high_Hz = 50.0}, kRate_Hz);
  EXPECT_NEAR(band.gain(5.0), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(band.gain(50.0), std::sqrt(0.5), 1e-9);
}

// At a quarter of the rate tan(π/4) = 1: b = (1, 2, 1)/(2 + √2), a₁ = 0, a₂ = (2 − √2)/(2 + √2).
TEST(ButterworthFilter, AnswersAnImpulseAsWorkedOutByHand) {
  const double b0 = 1.0 / (2.0 + std::numbers::sqrt2);
  const double a2 = (2.0 - std::numbers::sqrt2) / (2.0 + std::numbers::sqrt2);
  const std::vector<double> response =
      filtered(ButterworthFilter(LowPass{.order = 2, .cutoff_Hz = 250.0}, kRate_Hz),
               std::vector{1.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(response[0], b0, 1e-15);
  EXPECT_NEAR(response[1], 2.0 * b0, 1e-15);
  EXPECT_NEAR(response[2], b0 - a2 * b0, 1e-15);
  EXPECT_NEAR(response[3], -a2 * 2.0 * b0, 1e-15);
}

TEST(ButterworthFilter, GivesASinusoidItsGain) {
  ButterworthFilter filter(BandPass{.order = 2, .low_Hz = 20.0, .high_Hz = 100.0}, kRate_Hz);
  double squares = 0.0;
  for (int i = 0; i < 4000; ++i) {
    const double out = filter.next(std::sin(2.0 * std::numbers::pi * 120.0 * i / kRate_Hz));
    squares += i >= 2000 ? out * out : 0.0;
  }
  EXPECT_NEAR(std::sqrt(2.0 * squares / 2000.0), filter.gain(120.0), 1e-6);
}

TEST(ButterworthFilter, ForgetsThePastWhenReset) {
  ButterworthFilter filter(HighPass{.order = 3, .cutoff_Hz = 10.0}, kRate_Hz);
  const double first = filter.next(1.0);
  EXPECT_NE(filter.next(1.0), first);
  filter.reset();
  EXPECT_EQ(filter.next(1.0), first);
}

// |H|² is ½ at the cut-off and 1/(1 + w⁴) of order 2, w = tan(π·120/rate)/tan(π·30/rate); the phase is 0.
TEST(FilteredWithoutDelay, HasTheSquaredGainAndNoPhase) {
  constexpr LowPass kBand{.order = 2, .cutoff_Hz = 30.0};
  for (const double frequency_Hz : {30.0, 120.0}) {
    std::vector<double> wave(2000);
    for (std::size_t i = 0; i < wave.size(); ++i) {
      wave[i] = std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / kRate_Hz);
    }
    const double gain = ButterworthFilter(kBand, kRate_Hz).gain(frequency_Hz);
    const std::vector<double> out = filtered_without_delay(kBand, kRate_Hz, wave);
    for (std::size_t i = 300; i < 1700; ++i) EXPECT_NEAR(out[i], gain * gain * wave[i], 1e-6);
  }
}

TEST(FilteredWithoutDelay, PassesASlopeUnchanged) {
  std::vector<double> slope(400);
  for (std::size_t i = 0; i < slope.size(); ++i) slope[i] = 7.0 + 0.01 * static_cast<double>(i);
  const std::vector<double> out =
      filtered_without_delay({.order = 2, .cutoff_Hz = 30.0}, kRate_Hz, slope);
  for (std::size_t i = 0; i < slope.size(); ++i) EXPECT_NEAR(out[i], slope[i], 2e-3) << i;
  EXPECT_TRUE(filtered_without_delay({.order = 2, .cutoff_Hz = 30.0}, kRate_Hz, {}).empty());
}

TEST(ButterworthFilter, RefusesImpossibleBands) {
  EXPECT_THROW(ButterworthFilter(LowPass{.order = 0, .cutoff_Hz = 10.0}, kRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(ButterworthFilter(LowPass{.order = 9, .cutoff_Hz = 10.0}, kRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(ButterworthFilter(LowPass{.order = 2, .cutoff_Hz = 500.0}, kRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(ButterworthFilter(HighPass{.order = 2, .cutoff_Hz = 0.0}, kRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(ButterworthFilter(BandPass{.order = 2, .low_Hz = 50.0, .high_Hz = 50.0}, kRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(
      ButterworthFilter(LowPass{.order = 2, .cutoff_Hz = std::numeric_limits<double>::quiet_NaN()},
                        kRate_Hz),
      std::invalid_argument);
}

}  // namespace
}  // namespace asperity
