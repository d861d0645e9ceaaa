// Stochastic resonance: the size, spectrum and clock of its noise, and the detection of a weak signal with it.

#include "renderers/force/resonance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/spectrum.h"
#include "renderers/models/sinusoid.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kDetected_N = 0.05;
constexpr double kResonantPlate_N = 1.0;  // 2 mm deep in 500 N/m

ParameterValues resonance_of(double ratio, double threshold_N = kDetected_N) {
  return {{"resonance_ratio", ratio}, {"resonance_threshold_N", threshold_N}};
}

RendererInputs resonant_plate(ParameterValues parameters) {
  RendererInputs inputs{};
  inputs.parameters = std::move(parameters);
  inputs.parameters["amplitude_m"] = 0.0;
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.seed = 20260101;
  return inputs;
}

std::vector<double> resonant_noise_N(const Stroke& stroke, const RendererInputs& inputs) {
  const auto renderer = make_renderer(sinusoid_model(), inputs);
  std::vector<double> noise_N;
  for (const RenderedTick& tick : along_path(*renderer, samples_of(stroke), stroke.rate_Hz)) {
    noise_N.push_back(tick.wrench.force_N.z - kResonantPlate_N);
  }
  return noise_N;
}

/// At rest: the noise belongs to the time.
Stroke held_still(double duration_s, double rate_Hz = 1000.0) {
  return {.speed_m_per_s = 0.0, .duration_s = duration_s, .rate_Hz = rate_Hz};
}

double deviation_of(const std::vector<double>& values) {
  double power = 0.0;
  for (const double value : values) power += value * value;
  return std::sqrt(power / static_cast<double>(values.size()));
}

double gain_squared(double frequency_Hz) {
  const double warped = std::tan(std::numbers::pi * frequency_Hz / 6000.0) /
                        std::tan(std::numbers::pi * kResonanceCutoff_Hz / 6000.0);
  return 1.0 / (1.0 + std::pow(warped, 8));
}

TEST(Resonance, IsALayerOfEveryPointModelThatIsOffByDefault) {
  for (const ForceModel& model : point_models()) {
    RendererInputs inputs = resonant_plate({});
    inputs.parameters = {};
    inputs.height_field = grating();
    inputs.assets = files_of_models();
    const auto off = make_renderer(model, inputs);
    inputs.parameters = resonance_of(0.5);
    const auto on = make_renderer(model, inputs);
    const std::vector<ProbeState> samples = samples_of({.duration_s = 2.0});
    const auto without = along_path(*off, samples, 1000.0);
    const auto with = along_path(*on, samples, 1000.0);
    std::vector<double> added_N;
    for (std::size_t i = 0; i < with.size(); ++i) {
      added_N.push_back(with[i].wrench.force_N.z - without[i].wrench.force_N.z);
      ASSERT_EQ(with[i].wrench.force_N.x, without[i].wrench.force_N.x) << model.declaration.id;
    }
    EXPECT_NEAR(deviation_of(added_N), 0.5 * kDetected_N, 0.05 * 0.5 * kDetected_N)
        << model.declaration.id;
  }
}

// 60 s have about 2 · 308 Hz · 60 s = 37 000 independent values: the standard error of the deviation is 0.4 %.
TEST(Resonance, HasTheDeclaredDeviationAndTheSpectrumOfItsLowPass) {
  const std::vector<double> noise_N =
      resonant_noise_N(held_still(60.0, 4000.0), resonant_plate(resonance_of(2.0)));
  const double sd_N = 2.0 * kDetected_N;
  EXPECT_NEAR(deviation_of(noise_N), sd_N, 0.015 * sd_N);
  // Σh_i² by Parseval's theorem, ∫|L|² over half of the steps' rate.
  double power = 0.0;
  for (double f_Hz = 0.5; f_Hz < 3000.0; f_Hz += 1.0) power += gain_squared(f_Hz);
  const PowerSpectrum spectrum = welch_spectrum(noise_N, {.rate_Hz = 4000.0, .length = 4000});
  for (double centre_Hz = 20.0; centre_Hz < 510.0; centre_Hz *= std::cbrt(2.0)) {
    const FrequencyBand third{centre_Hz / std::pow(2.0, 1.0 / 6.0),
                              centre_Hz * std::pow(2.0, 1.0 / 6.0)};
    double expected = 0.0;
    for (double f_Hz = std::ceil(third.low_Hz); f_Hz <= third.high_Hz; f_Hz += 1.0) {
      expected += sd_N * sd_N * gain_squared(f_Hz) / power;
    }
    EXPECT_NEAR(10.0 * std::log10(band_power(spectrum, third) / expected), 0.0, 1.0) << centre_Hz;
  }
}

TEST(Resonance, IsTheSameForceOverTimeAtAnyServoRate) {
  const std::vector<double> at_1kHz =
      resonant_noise_N(held_still(1.0), resonant_plate(resonance_of(1.0)));
  const std::vector<double> at_4kHz =
      resonant_noise_N(held_still(1.0, 4000.0), resonant_plate(resonance_of(1.0)));
  for (std::size_t i = 0; i < at_1kHz.size(); ++i) ASSERT_EQ(at_1kHz[i], at_4kHz[4 * i]) << i;
}

TEST(Resonance, IsSilentOutOfContactAndNeverPulls) {
  const auto renderer = make_renderer(sinusoid_model(), resonant_plate(resonance_of(10.0)));
  for (const RenderedTick& tick : along_path(*renderer, samples_of({.height_m = 0.001}), 1000.0)) {
    ASSERT_EQ(tick.wrench.force_N.z, 0.0);
  }
  // 0.05 N under noise of 0.5 N.
  double greatest_N = 0.0;
  for (const RenderedTick& tick :
       along_path(*renderer, samples_of({.height_m = -0.0001}), 1000.0)) {
    ASSERT_GE(tick.wrench.force_N.z, 0.0);
    greatest_N = std::max(greatest_N, tick.wrench.force_N.z);
  }
  EXPECT_GT(greatest_N, 0.5);
}

double normal_distribution(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// An observer with a hard threshold, who looks once at each of two intervals: with the noise of the layer the signal of
// 0.6 thresholds is found as often as the closed form of the header states, most often at the ratio of its maximum.
TEST(Resonance, LetsAHardThresholdDetectAWeakSignalMostOftenAtItsMaximum) {
  constexpr double kSignal = 0.6;
  const double best =
      std::sqrt(kSignal * (2.0 - kSignal) / (2.0 * std::log(1.0 / (1.0 - kSignal))));
  EXPECT_NEAR(best, 0.677, 0.001);
  constexpr std::size_t kApart = 10;  // ticks: 10 ms, after which the noise is independent
  constexpr double kTrials = 10'000;
  const auto correct = [&](double ratio) {
    const std::vector<double> noise_N = resonant_noise_N(
        held_still(2.0 * kTrials * kApart / 1000.0), resonant_plate(resonance_of(ratio)));
    double sum = 0.0;
    for (std::size_t i = 0; i + kApart < noise_N.size(); i += 2 * kApart) {
      const bool with = noise_N[i] / kDetected_N + kSignal > 1.0;
      const bool without = noise_N[i + kApart] / kDetected_N > 1.0;
      sum += with == without ? 0.5 : with ? 1.0 : 0.0;
    }
    return sum / kTrials;
  };
  const auto expected = [](double ratio) {
    return 0.5 +
           0.5 * (normal_distribution((kSignal - 1.0) / ratio) - normal_distribution(-1.0 / ratio));
  };
  EXPECT_NEAR(expected(best), 0.604, 0.001);
  for (const double ratio : {0.2, 0.4, best, 1.2, 3.0}) {
    // The standard error of a proportion is at most 0.005; responses by guessing count as halves.
    EXPECT_NEAR(correct(ratio), expected(ratio), 0.015) << ratio;
    if (ratio != best) {
      EXPECT_LT(expected(ratio), expected(best)) << ratio;
    }
  }
  EXPECT_GT(correct(best), correct(0.2) + 0.05);
  EXPECT_GT(correct(best), correct(3.0) + 0.02);
}

TEST(Resonance, RequiresAMeasuredThreshold) {
  EXPECT_THROW(make_renderer(sinusoid_model(), resonant_plate(resonance_of(0.5, 0.0))),
               std::invalid_argument);
  EXPECT_NO_THROW(make_renderer(sinusoid_model(), resonant_plate(resonance_of(0.0, 0.0))));
}

TEST(Resonance, MovesByItselfAndIsNoPotential) {
  const ForceModel model = sinusoid_model();
  ParameterValues gradient{{"force_direction", std::string("gradient")}};
  EXPECT_TRUE(is_potential(model, gradient));
  EXPECT_FALSE(moves_by_itself(model, gradient));
  gradient.merge(resonance_of(0.5));
  EXPECT_FALSE(is_potential(model, gradient));
  EXPECT_TRUE(moves_by_itself(model, gradient));
  EXPECT_EQ(band_Hz(model, resonant_plate(resonance_of(0.5)), 0.1), kResonanceCutoff_Hz);
}

}  // namespace
}  // namespace asperity
