// The noise: its size, its clock, and where it is silent.

#include "renderers/models/stochastic.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/spectrum.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

// 2 mm deep in 500 N/m: 1 N under the noise.
constexpr double kPlate_N = 1.0;

RendererInputs inputs_with(ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.seed = 20260101;
  return inputs;
}

std::vector<double> noise_N(const Stroke& stroke, const ParameterValues& parameters = {}) {
  const auto renderer = make_renderer(stochastic_model(), inputs_with(parameters));
  std::vector<double> noise;
  for (const RenderedTick& tick : along_path(*renderer, samples_of(stroke), stroke.rate_Hz)) {
    noise.push_back(tick.wrench.force_N.z - kPlate_N);
  }
  return noise;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) moments.mean += value / static_cast<double>(values.size());
  for (const double value : values) {
    moments.deviation += std::pow(value - moments.mean, 2) / static_cast<double>(values.size());
  }
  moments.deviation = std::sqrt(moments.deviation);
  return moments;
}

TEST(Stochastic, HasTheDeclaredMeanAndStandardDeviation) {
  // 20 000 independent values: standard errors 0.1/sqrt(20000) = 0.0007 and 0.0005; 4 of each.
  const Moments moments = moments_of(noise_N({.speed_m_per_s = 0.02, .duration_s = 20.0},
                                             {{"noise_sd_N", 0.1}, {"noise_mean_N", 0.2}}));
  EXPECT_NEAR(moments.mean, 0.2, 0.0028);
  EXPECT_NEAR(moments.deviation, 0.1, 0.0020);
}

TEST(Stochastic, IsTheSameForceOverTimeAtAnyServoRate) {
  const std::vector<double> at_1kHz = noise_N({.rate_Hz = 1000.0});
  const std::vector<double> at_4kHz = noise_N({.rate_Hz = 4000.0});
  EXPECT_NEAR(moments_of(at_4kHz).deviation, moments_of(at_1kHz).deviation,
              0.01 * moments_of(at_1kHz).deviation);
  for (std::size_t i = 0; i < at_1kHz.size(); ++i) EXPECT_EQ(at_1kHz[i], at_4kHz[4 * i]) << i;
}

TEST(Stochastic, TakesOneValuePerNoiseStep) {
  // 10 kHz over 1 s at a noise rate of 1 kHz: 999 changes, each after 10 samples.
  const std::vector<double> noise = noise_N({.rate_Hz = 10000.0});
  std::size_t changes = 0;
  for (std::size_t i = 1; i < noise.size(); ++i) {
    if (noise[i] != noise[i - 1]) {
      ++changes;
      EXPECT_EQ(i % 10, 5U) << i;  // half a step before the whole millisecond
    }
  }
  EXPECT_EQ(changes, 1000U);
}

TEST(Stochastic, DoesNotStraddleItsStepsWhenTheServoIsLate) {
  std::vector<ProbeState> late = samples_of({});
  for (std::size_t i = 0; i < late.size(); ++i) late[i].time_ns += i % 3 == 0 ? 0 : 40'000;
  const auto renderer = make_renderer(stochastic_model(), inputs_with({}));
  const std::vector<double> punctual = noise_N({});
  const std::vector<RenderedTick> ticks = along_path(*renderer, late, 1000.0);
  for (std::size_t i = 0; i < late.size(); ++i) {
    EXPECT_EQ(ticks[i].wrench.force_N.z - kPlate_N, punctual[i]) << i;
  }
}

TEST(Stochastic, IsSilentBelowTheVelocityThreshold) {
  for (const double value : noise_N({.speed_m_per_s = 0.0})) EXPECT_EQ(value, 0.0);
  for (const double value : noise_N({.speed_m_per_s = 0.0049})) EXPECT_EQ(value, 0.0);
  EXPECT_GT(moments_of(noise_N({.speed_m_per_s = 0.0051})).deviation, 0.04);
}

TEST(Stochastic, DependsOnItsSeed) {
  RendererInputs inputs = inputs_with({});
  const auto one = make_renderer(stochastic_model(), inputs);
  const auto same = make_renderer(stochastic_model(), inputs);
  inputs.seed += 1;
  const auto other = make_renderer(stochastic_model(), inputs);
  const std::vector<ProbeState> path = samples_of({.duration_s = 0.1});
  const auto a = along_path(*one, path, 1000.0);
  const auto b = along_path(*same, path, 1000.0);
  const auto c = along_path(*other, path, 1000.0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(a[i].wrench.force_N.z, b[i].wrench.force_N.z);
    EXPECT_NE(a[i].wrench.force_N.z, c[i].wrench.force_N.z);
  }
}

TEST(Stochastic, NeverPulls) {
  // Plate 0.05 N, deviation 1 N: about half of the noise would pull.
  const auto renderer = make_renderer(stochastic_model(), inputs_with({{"noise_sd_N", 1.0}}));
  std::size_t free = 0;
  for (const RenderedTick& tick :
       along_path(*renderer, samples_of({.height_m = -0.0001}), 1000.0)) {
    EXPECT_GE(tick.wrench.force_N.z, 0.0);
    if (tick.wrench.force_N.z == 0.0) ++free;
  }
  EXPECT_GT(free, 400U);
}

// σφ(F/σ) − FΦ(−F/σ) = 0.15·0.368270 − 0.06·0.344578 = 34.57 mN; of 400 000 values with a deviation of 108 mN, 5 standard
// errors are 0.86 mN. At 0.12 mm the noise has faded in.
TEST(Stochastic, RaisesTheMeanOfALightTouchByWhatIsClipped) {
  RendererInputs wide = inputs_with({{"noise_sd_N", 0.15}});
  wide.patch.extent_m = {100.0, 100.0};
  const auto light = make_renderer(stochastic_model(), wide);
  std::vector<double> felt_N{};
  for (const RenderedTick& tick :
       along_path(*light, samples_of({.height_m = -1.2e-4, .duration_s = 400.0}), 1000.0)) {
    felt_N.push_back(tick.wrench.force_N.z);
  }
  const double clipped_N = 0.15 * std::exp(-0.5 * 0.16) / std::sqrt(2.0 * std::numbers::pi) -
                           0.06 * 0.5 * std::erfc(0.4 / std::numbers::sqrt2);
  EXPECT_NEAR(clipped_N, 0.03457, 1e-5);
  EXPECT_NEAR(moments_of(felt_N).mean, 0.06 + clipped_N, 0.00086);
  EXPECT_NEAR(moments_of(felt_N).deviation, 0.108, 0.003);
}

// At 400 Hz each tick has a new value: white up to 200 Hz, so that 5 to 200 Hz hold √(195/200) of σ; at 1 kHz √(195/500).
TEST(Stochastic, IsHeldAtTheRateOfASlowerServo) {
  const std::vector<double> slow =
      noise_N({.speed_m_per_s = 0.02, .duration_s = 20.0, .rate_Hz = 400.0});
  EXPECT_NEAR(band_rms(slow, 400.0, 5.0, 200.0), 0.05 * std::sqrt(195.0 / 200.0), 0.0015);
  const std::vector<double> even = noise_N({.speed_m_per_s = 0.02, .duration_s = 20.0});
  EXPECT_NEAR(band_rms(even, 1000.0, 5.0, 200.0), 0.05 * std::sqrt(195.0 / 500.0), 0.0015);
}

TEST(Stochastic, IsSilentOutOfContact) {
  const auto renderer = make_renderer(stochastic_model(), inputs_with({{"noise_mean_N", 1.0}}));
  for (const RenderedTick& tick : along_path(*renderer, samples_of({.height_m = 0.0}), 1000.0)) {
    EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0));
    EXPECT_EQ(tick.penetration_m, 0.0);
  }
}

TEST(Stochastic, TakesItsDeviationFromASample) {
  // k · RMS = 500 · 0.2 mm/√2 = 0.0707107 N; the mean is taken out.
  const ParameterValues suggested = stochastic_model().suggested_by(*grating(), Material{});
  EXPECT_NEAR(number_of(suggested, "noise_sd_N"), 0.0707107, 1e-5);
  EXPECT_EQ(number_of(suggested, "noise_mean_N"), 0.0);
}

}  // namespace
}  // namespace asperity
