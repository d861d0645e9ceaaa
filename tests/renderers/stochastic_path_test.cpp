// Noise on the path of the hand: its spectrum, its clock, and the hand at rest.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/servo_low_pass.h"
#include "renderers/models/stochastic.h"
#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

constexpr double kNoiseLength_m = 1e-4;
constexpr double kNoiseSd_N = 0.05;
constexpr double kUnderNoise_N = 1.0;  // 2 mm in 500 N/m

std::unique_ptr<ForceRenderer> noise_on_path(ParameterValues parameters = {},
                                             double motion_scale = 1.0) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.parameters["index"] = std::string("distance");
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.patch.motion_scale = motion_scale;
  inputs.seed = 20260101;
  return make_renderer(stochastic_model(), inputs);
}

std::vector<double> path_noise_N(const Stroke& stroke, double motion_scale = 1.0) {
  const auto renderer = noise_on_path({}, motion_scale);
  std::vector<double> noise_N{};
  for (const RenderedTick& tick : along_path(*renderer, samples_of(stroke), stroke.rate_Hz)) {
    noise_N.push_back(tick.wrench.force_N.z - kUnderNoise_N);
  }
  return noise_N;
}

double in_dB(double power_ratio) { return 10.0 * std::log10(power_ratio); }

/// The power of 2σ²λ_n/v·sinc²(f·λ_n/v) in a third of an octave.
double declared_power(double centre_Hz, double speed_m_per_s) {
  const double low_Hz = centre_Hz * std::pow(2.0, -1.0 / 6.0);
  const double high_Hz = centre_Hz * std::pow(2.0, 1.0 / 6.0);
  const double per_Hz = kNoiseLength_m / speed_m_per_s;
  double power = 0.0;
  constexpr int kParts = 100;
  for (int part = 0; part < kParts; ++part) {
    const double phase =
        std::numbers::pi * per_Hz * (low_Hz + (part + 0.5) * (high_Hz - low_Hz) / kParts);
    power += 2.0 * kNoiseSd_N * kNoiseSd_N * per_Hz * std::pow(std::sin(phase) / phase, 2) *
             (high_Hz - low_Hz) / kParts;
  }
  return power;
}

double band_power_of(const std::vector<double>& signal, double rate_Hz, double centre_Hz) {
  return std::pow(band_rms(signal, rate_Hz, centre_Hz * std::pow(2.0, -1.0 / 6.0),
                           centre_Hz * std::pow(2.0, 1.0 / 6.0)),
                  2);
}

// Of 120 s, the narrowest band (40 Hz, 9 Hz wide) has 1100 lines: 4.3 dB/√1100 = 0.13 dB is one standard error.
constexpr double kBands_Hz[] = {40.0, 63.0, 80.0, 100.0, 125.0, 160.0, 200.0, 250.0};

TEST(StochasticPath, HasTheSpectrumOfItsStepsAtEverySpeed) {
  // At 200 mm/s a tick of 1 kHz has two steps: without the low-pass they would alias to + 3 dB.
  for (const double speed_m_per_s : {0.06, 0.1, 0.2}) {
    for (const double rate_Hz : {1000.0, 4000.0}) {
      const std::vector<double> noise_N =
          path_noise_N({.speed_m_per_s = speed_m_per_s, .duration_s = 120.0, .rate_Hz = rate_Hz});
      for (const double centre_Hz : kBands_Hz) {
        EXPECT_NEAR(in_dB(band_power_of(noise_N, rate_Hz, centre_Hz) /
                          declared_power(centre_Hz, speed_m_per_s)),
                    0.0, 0.5)
            << speed_m_per_s << " m/s, " << rate_Hz << " Hz, " << centre_Hz << " Hz";
      }
    }
  }
}

TEST(StochasticPath, IsTheSameInThirdOctavesAtAnyServoRate) {
  const Stroke stroke{.speed_m_per_s = 0.1, .duration_s = 60.0, .rate_Hz = 1000.0};
  const std::vector<double> slow_N = path_noise_N(stroke);
  for (const double rate_Hz : {2000.0, 4000.0}) {
    Stroke faster = stroke;
    faster.rate_Hz = rate_Hz;
    const std::vector<double> fast_N = path_noise_N(faster);
    for (const double centre_Hz : kBands_Hz) {
      EXPECT_NEAR(in_dB(band_power_of(fast_N, rate_Hz, centre_Hz) /
                        band_power_of(slow_N, 1000.0, centre_Hz)),
                  0.0, 0.5)
          << rate_Hz << " Hz, " << centre_Hz << " Hz";
    }
  }
}

TEST(StochasticPath, CountsItsStepsOnTheTexture) {
  // Twice the motion on the texture is twice the speed.
  const std::vector<double> noise_N = path_noise_N({.duration_s = 120.0, .rate_Hz = 4000.0}, 2.0);
  for (const double centre_Hz : {80.0, 160.0}) {
    EXPECT_NEAR(in_dB(band_power_of(noise_N, 4000.0, centre_Hz) / declared_power(centre_Hz, 0.12)),
                0.0, 0.5);
  }
}

TEST(StochasticPath, IsThePlateWhereAHandRestsWithinTheNoiseOfItsDevice) {
  // 60 s; readings vary by one step in both axes, of 10 µm, and of a device of 38 µm that is declared.
  for (const double step_m : {10e-6, 38e-6}) {
    const auto renderer = noise_on_path({{"device_step_m", step_m}});
    Random jitter(4);
    ProbeState probe = probe_at({0.001, 0.002, -0.002});
    renderer->reset(probe);
    for (int tick = 0; tick < 60'000; ++tick) {
      probe.time_ns += 1'000'000;
      probe.position_m.x = 0.001 + step_m * (static_cast<double>(jitter.below(3)) - 1.0);
      probe.position_m.y = 0.002 + step_m * (static_cast<double>(jitter.below(3)) - 1.0);
      probe.velocity_m_per_s = {0.02, 0.0, 0.0};  // what such readings may be taken for
      ASSERT_EQ(renderer->tick(probe, kTick_s).wrench.force_N, glm::dvec3(0.0, 0.0, 1.0)) << tick;
    }
  }
}

TEST(StochasticPath, HoldsItsForceWhereTheHandStops) {
  const auto renderer = noise_on_path();
  std::vector<ProbeState> path = samples_of({.duration_s = 0.5});
  for (const ProbeState& probe : path) renderer->tick(probe, kTick_s);
  ProbeState still = path.back();
  double first_N = 0.0;
  Random jitter(5);
  const double stopped_m = still.position_m.x;
  for (int tick = 0; tick < 10'000; ++tick) {
    still.time_ns += 1'000'000;
    still.position_m.x = stopped_m + 5e-6 * (static_cast<double>(jitter.below(3)) - 1.0);
    const double felt_N = renderer->tick(still, kTick_s).wrench.force_N.z;
    if (tick == 30) first_N = felt_N;  // the low-pass has settled
    if (tick > 30) {
      ASSERT_NEAR(felt_N, first_N, 1e-9) << tick;
    }
  }
  EXPECT_GT(std::abs(first_N - kUnderNoise_N), 1e-3);
}

TEST(StochasticPath, DependsOnItsSeedAndItsPathOnly) {
  const std::vector<ProbeState> path = samples_of({.duration_s = 0.3});
  const auto one = noise_on_path();
  const auto same = noise_on_path();
  const auto a = along_path(*one, path, 1000.0);
  std::vector<ProbeState> later = path;  // another time and another velocity, the same places
  for (ProbeState& probe : later) {
    probe.time_ns += 77'000'000;
    probe.velocity_m_per_s = glm::dvec3(0.0);
  }
  const auto b = along_path(*same, later, 1000.0);
  const auto again = along_path(*one, path, 1000.0);  // after a reset
  double largest_N = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(a[i].wrench.force_N, b[i].wrench.force_N) << i;
    ASSERT_EQ(a[i].wrench.force_N, again[i].wrench.force_N) << i;
    largest_N = std::max(largest_N, std::abs(a[i].wrench.force_N.z - kUnderNoise_N));
  }
  EXPECT_GT(largest_N, kNoiseSd_N);
}

TEST(StochasticPath, NeverPulls) {
  const auto renderer = noise_on_path({{"noise_sd_N", 1.0}});
  for (const RenderedTick& tick :
       along_path(*renderer, samples_of({.height_m = -0.0001}), 1000.0)) {
    EXPECT_GE(tick.wrench.force_N.z, 0.0);
  }
}

TEST(PathClock, AddsChordsBeyondItsDeadZone) {
  PathClock clock(15e-6);  // two steps are 30 µm
  clock.reset({0.0, 0.0});
  EXPECT_EQ(clock.advance({30e-6, -30e-6}), 0.0);
  EXPECT_NEAR(clock.advance({30e-6, 40e-6}), 50e-6, 1e-18);
  EXPECT_NEAR(clock.advance({30e-6 + 29e-6, 40e-6}), 50e-6, 1e-18);
  EXPECT_NEAR(clock.advance({30e-6 + 60e-6, 40e-6}), 110e-6, 1e-18);
  PathClock fine(1e-6);  // 20 µm at the least
  fine.reset({0.0, 0.0});
  EXPECT_EQ(fine.advance({19e-6, 0.0}), 0.0);
  EXPECT_NEAR(fine.advance({21e-6, 0.0}), 21e-6, 1e-18);
  fine.reset({21e-6, 0.0});
  EXPECT_EQ(fine.advance({21e-6, 0.0}), 0.0);
}

/// The gain of a filter at a share of the servo rate, from its answer to a sine.
double gain_dB(double share) {
  ServoLowPass low_pass{};
  low_pass.reset(0.0);
  double in = 0.0;
  double out = 0.0;
  constexpr int kSteps = 80'000;
  for (int step = 0; step < kSteps; ++step) {
    const double value =
        std::sin(2.0 * std::numbers::pi * share * step / ServoLowPass::kStepsPerTick);
    const double filtered = low_pass.step(value);
    if (step < kSteps / 2) continue;
    in += value * value;
    out += filtered * filtered;
  }
  return in_dB(out / in);
}

TEST(ServoLowPass, IsAButterworthOfFourthOrder) {
  // −10·log10(1 + (f/0.4)⁸), but for the warp of the bilinear transform, 1 % of the frequency.
  EXPECT_NEAR(gain_dB(0.1), 0.0, 0.01);
  EXPECT_NEAR(gain_dB(0.3), -0.414, 0.03);
  EXPECT_NEAR(gain_dB(0.4), -3.01, 0.01);
  EXPECT_NEAR(gain_dB(0.5), -8.43, 0.2);
  EXPECT_LT(gain_dB(1.0), -31.0);
}

TEST(ServoLowPass, KeepsAConstant) {
  ServoLowPass low_pass{};
  low_pass.reset(0.7);
  for (int step = 0; step < 100; ++step) EXPECT_NEAR(low_pass.step(0.7), 0.7, 1e-12);
  for (int step = 0; step < 400; ++step) low_pass.step(-0.2);
  EXPECT_NEAR(low_pass.step(-0.2), -0.2, 1e-9);
}

}  // namespace
}  // namespace asperity
