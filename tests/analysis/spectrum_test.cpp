// Holds the spectra to the definition of the Fourier transform and to signals of known power.

#include "analysis/signals/spectrum.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

std::vector<double> noise(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> signal(count);
  for (double& value : signal) {
    value = random.normal();
  }
  return signal;
}

std::vector<double> sampled_tone(std::size_t count, double frequency_Hz) {
  std::vector<double> signal(count);
  for (std::size_t i = 0; i < count; ++i) {
    signal[i] = std::sin(kTurn_rad * frequency_Hz * static_cast<double>(i) / 1000.0);
  }
  return signal;
}

// Small factors, a prime, twice a prime, and primes beyond 100, which go another way.
TEST(RealSpectrum, IsTheFourierSumForEveryKindOfLength) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 16U, 45U, 97U, 101U, 202U, 1009U}) {
    const std::vector<double> signal = noise(count, count);
    const auto lines = real_spectrum(signal);
    ASSERT_EQ(lines.size(), count / 2 + 1);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      std::complex<double> sum;
      for (std::size_t n = 0; n < count; ++n) {
        sum += signal[n] * std::polar(1.0, -kTurn_rad * static_cast<double>((k * n) % count) /
                                               static_cast<double>(count));
      }
      EXPECT_LT(std::abs(lines[k] - sum), 1e-11 * static_cast<double>(count))
          << "line " << k << " of " << count;
    }
  }
}

TEST(BandRms, OfASinusoidIsItsAmplitudeOverRootTwo) {
  const std::vector<double> signal = sampled_tone(1800, 100.0);
  EXPECT_NEAR(band_rms(signal, 1000.0), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(band_rms(signal, 1000.0, 100.0, 100.0), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(band_rms(signal, 1000.0, 101.0, 500.0), 0.0, 1e-12);
}

TEST(BandRms, CountsHalfTheRateOnce) {
  std::vector<double> signal(1800);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] = i % 2 == 0 ? 1.0 : -1.0;
  }
  EXPECT_NEAR(band_rms(signal, 1000.0), 1.0, 1e-12);
  EXPECT_NEAR(band_rms(signal, 1000.0, 5.0, 499.9), 0.0, 1e-12);
}

TEST(BandRms, IncludesItsLowerBorder) {
  EXPECT_NEAR(band_rms(sampled_tone(1800, 5.0), 1000.0), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(band_rms(sampled_tone(1800, 5.0 - 1000.0 / 1800.0), 1000.0), 0.0, 1e-12);
}

// Parseval: all lines together are the variance, for even, odd and prime lengths, whatever the
// mean.
TEST(BandRms, OfTheWholeBandIsTheStandardDeviation) {
  for (const std::size_t count : {1800U, 1801U, 1575U}) {
    std::vector<double> signal = noise(count, 3);
    double mean = 0.0;
    for (double& value : signal) {
      value += 7.0;
      mean += value / static_cast<double>(count);
    }
    double variance = 0.0;
    for (const double value : signal) {
      variance += (value - mean) * (value - mean) / static_cast<double>(count);
    }
    EXPECT_NEAR(band_rms(signal, 1000.0, 0.0, 500.0), std::sqrt(variance), 1e-10);
  }
}

TEST(BandRms, RefusesWhatIsNoBandOrRecord) {
  const std::vector<double> signal = sampled_tone(100, 50.0);
  EXPECT_THROW(band_rms({}, 1000.0), std::invalid_argument);
  EXPECT_THROW(band_rms(signal, 0.0), std::invalid_argument);
  EXPECT_THROW(band_rms(signal, 1000.0, 50.0, 5.0), std::invalid_argument);
}

TEST(WelchSpectrum, HasThePowerOfASinusoidAtItsPlace) {
  const PowerSpectrum spectrum =
      welch_spectrum(sampled_tone(4096, 125.0), {.rate_Hz = 1000.0, .length = 256});
  EXPECT_NEAR(band_power(spectrum, {.low_Hz = 110.0, .high_Hz = 140.0}), 0.5, 1e-6);
  EXPECT_NEAR(band_power(spectrum, {.low_Hz = 0.0, .high_Hz = 500.0}), 0.5, 1e-6);
  EXPECT_NEAR(band_power(spectrum, {.low_Hz = 200.0, .high_Hz = 500.0}), 0.0, 1e-6);
}

// White noise of variance 1 at 1 kHz has the one-sided density 1/500 per hertz everywhere.
TEST(WelchSpectrum, OfWhiteNoiseIsFlat) {
  const PowerSpectrum spectrum =
      welch_spectrum(noise(200000, 5), {.rate_Hz = 1000.0, .length = 200});
  EXPECT_DOUBLE_EQ(spectrum.spacing_Hz, 5.0);
  for (std::size_t k = 2; k + 1 < spectrum.density.size(); ++k) {
    EXPECT_NEAR(spectrum.density[k] * 500.0, 1.0, 0.2);
  }
  EXPECT_NEAR(band_power(spectrum, {.low_Hz = 0.0, .high_Hz = 500.0}), 1.0, 0.02);
}

TEST(WelchSpectrum, RefusesASignalShorterThanItsWindow) {
  EXPECT_THROW(welch_spectrum(sampled_tone(255, 50.0), {}), std::invalid_argument);
}

struct Field {
  std::size_t rows = 256;
  std::size_t columns = 256;
  double pitch_m = 0.1e-3;
};

std::optional<double> dominant_m(const Field& field,
                                 const std::function<double(double, double)>& height_m) {
  std::vector<float> heights_m;
  for (std::size_t r = 0; r < field.rows; ++r) {
    for (std::size_t c = 0; c < field.columns; ++c) {
      heights_m.push_back(static_cast<float>(height_m(static_cast<double>(c) * field.pitch_m,
                                                      static_cast<double>(r) * field.pitch_m)));
    }
  }
  return dominant_wavelength_m({heights_m, field.rows, field.columns, field.pitch_m});
}

TEST(DominantWavelength, IsThatOfASinusoidInAnyDirection) {
  for (const double wavelength_m : {0.3e-3, 1e-3, 2.3e-3, 6e-3}) {
    for (const double angle_rad : {0.0, 0.5, std::numbers::pi / 4.0, std::numbers::pi / 2.0}) {
      const auto found_m = dominant_m({}, [&](double x_m, double y_m) {
        const double along_m = x_m * std::cos(angle_rad) + y_m * std::sin(angle_rad);
        return 1e-4 * std::sin(kTurn_rad * along_m / wavelength_m);
      });
      ASSERT_TRUE(found_m);
      EXPECT_NEAR(*found_m / wavelength_m, 1.0, 0.06) << wavelength_m << " at " << angle_rad;
    }
  }
}

TEST(DominantWavelength, IsThatOfTheStrongerWave) {
  const auto two_waves = [](double long_m, double short_m) {
    return [=](double x_m, double y_m) {
      return long_m * std::sin(kTurn_rad * x_m / 4e-3) +
             short_m * std::sin(kTurn_rad * y_m / 0.8e-3);
    };
  };
  EXPECT_NEAR(dominant_m({}, two_waves(2e-5, 1e-5)).value(), 4e-3, 0.2e-3);
  EXPECT_NEAR(dominant_m({}, two_waves(1e-5, 2e-5)).value(), 0.8e-3, 0.04e-3);
}

TEST(DominantWavelength, DoesNotDependOnAPlaneUnderIt) {
  const auto found_m = dominant_m({}, [](double x_m, double y_m) {
    return 3e-3 + 0.05 * x_m - 0.1 * y_m + 1e-5 * std::sin(kTurn_rad * x_m / 1e-3);
  });
  EXPECT_NEAR(found_m.value(), 1e-3, 0.05e-3);
}

// Sides of 1031 and 337, both prime: cut to 1024 and 324 with the same answer.
TEST(DominantWavelength, TakesAnySize) {
  const auto wave = [](double x_m, double) { return 1e-5 * std::sin(kTurn_rad * x_m / 1.5e-3); };
  EXPECT_NEAR(dominant_m({.rows = 337, .columns = 1031}, wave).value(), 1.5e-3, 0.05e-3);
  EXPECT_NEAR(dominant_m({.rows = 1031, .columns = 337}, wave).value(), 1.5e-3, 0.05e-3);
}

TEST(DominantWavelength, IsAbsentOnAPlane) {
  EXPECT_FALSE(dominant_m({}, [](double, double) { return 0.0; }));
  EXPECT_FALSE(dominant_m({}, [](double x_m, double y_m) { return 1e-3 + 0.1 * x_m - y_m; }));
}

TEST(DominantWavelength, RefusesWhatIsNoHeightField) {
  std::vector<float> heights_m(256, 0.0F);
  EXPECT_THROW(dominant_wavelength_m({heights_m, 15, 17, 1e-4}), std::invalid_argument);
  EXPECT_THROW(dominant_wavelength_m({heights_m, 16, 17, 1e-4}), std::invalid_argument);
  EXPECT_THROW(dominant_wavelength_m({heights_m, 16, 16, 0.0}), std::invalid_argument);
  heights_m[77] = std::numeric_limits<float>::infinity();
  EXPECT_THROW(dominant_wavelength_m({heights_m, 16, 16, 1e-4}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
