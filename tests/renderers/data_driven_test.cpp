// The vibration of autoregressive models: its spectrum, other servo rates, triangles, rest, friction, refusals.

#include "renderers/models/data_driven.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/spectrum.h"
#include "renderers/offline/along_path.h"
#include "renderers/vibrations/vibration_fit.h"
#include "renderers/vibrations/vibration_models.h"
#include "tests/renderers/surfaces.h"
#include "tests/renderers/vibrations.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

RendererInputs of_models(const VibrationModels& set, ParameterValues parameters = {}) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.parameters.try_emplace("axis", std::string("motion"));
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.patch.extent_m = {100.0, 100.0};
  inputs.assets = {{kVibrationModelsRole, std::make_shared<const std::string>(tsv_of(set))}};
  inputs.seed = 5;
  return inputs;
}

/// The acceleration that a force along the motion stands for, from 0.5 s on. The plate has 1 N at −2 mm.
std::vector<double> played_m_per_s2(const RendererInputs& inputs, const Stroke& stroke) {
  constexpr double kRest_m_per_s = 0.010;
  const auto renderer = make_renderer(data_driven_model(), inputs);
  const std::vector<RenderedTick> ticks = along_path(*renderer, samples_of(stroke), stroke.rate_Hz);
  std::vector<double> acceleration{};
  for (auto i = static_cast<std::size_t>(0.5 * stroke.rate_Hz); i < ticks.size(); ++i) {
    acceleration.push_back(ticks[i].wrench.force_N.x / kEffectiveMass_kg *
                           std::hypot(stroke.speed_m_per_s, kRest_m_per_s) / stroke.speed_m_per_s);
  }
  return acceleration;
}

/// Of the signal relative to the model, in third octaves of Welch's estimate with lines of 1 Hz.
double largest_difference_from_model_dB(const std::vector<double>& signal, double rate_Hz,
                                        const VibrationModel& model) {
  const PowerSpectrum spectrum = welch_spectrum(
      signal, {.rate_Hz = rate_Hz, .length = static_cast<std::size_t>(std::lround(rate_Hz))});
  double largest_dB = 0.0;
  for (const double centre_Hz : kThirdOctaves_Hz) {
    const FrequencyBand band = third_octave(centre_Hz);
    double theory = 0.0;
    for (double f = std::ceil(band.low_Hz); f <= band.high_Hz; f += 1.0) {
      theory += acceleration_density(model, f);
    }
    largest_dB =
        std::max(largest_dB, std::abs(10.0 * std::log10(band_power(spectrum, band) / theory)));
  }
  return largest_dB;
}

// 60 s each, at a model of the set and at the middle between two, where the peak is between theirs.
TEST(DataDriven, HasTheSpectrumOfItsModelInThirdOctaves) {
  const VibrationModels set = resonant_models();
  const VibrationModel& model = set.models[4];  // 60 mm/s, 1 N
  EXPECT_LT(largest_difference_from_model_dB(played_m_per_s2(of_models(set), {.duration_s = 60.5}),
                                             1000.0, model),
            1.0);
  VibrationModel between = set.models[1];
  for (std::size_t i = 0; i < between.lines_rad.size(); ++i) {
    between.lines_rad[i] = 0.5 * (set.models[1].lines_rad[i] + model.lines_rad[i]);
  }
  between.variance_m2_per_s4 =
      std::sqrt(set.models[1].variance_m2_per_s4 * model.variance_m2_per_s4);
  EXPECT_LT(largest_difference_from_model_dB(
                played_m_per_s2(of_models(set), {.speed_m_per_s = 0.045, .duration_s = 60.5}),
                1000.0, between),
            1.0);
}

// After the low-pass of the speed has settled, the same process as that of this model alone.
TEST(DataDriven, IsTheModelAtItsSpeedAndForce) {
  const VibrationModels set = resonant_models();
  const std::vector<double> of_set = played_m_per_s2(of_models(set), {.duration_s = 3.0});
  const std::vector<double> alone =
      played_m_per_s2(of_models({{set.models[4]}}), {.duration_s = 3.0});
  for (std::size_t i = of_set.size() - 500; i < of_set.size(); ++i) {
    ASSERT_NEAR(of_set[i], alone[i], 1e-8) << i;
  }
}

// Of 500 Hz up to 0.43 of it, beyond which the interpolation fades.
TEST(DataDriven, IsTheSameAtOtherServoRatesInThirdOctaves) {
  const RendererInputs inputs = of_models(resonant_models());
  Stroke stroke{.speed_m_per_s = 0.08, .duration_s = 10.5};
  const std::vector<double> reference = played_m_per_s2(inputs, stroke);
  for (const double rate_Hz : {500.0, 1500.0, 2000.0, 4000.0, 10000.0}) {
    stroke.rate_Hz = rate_Hz;
    const std::vector<double> other = played_m_per_s2(inputs, stroke);
    for (const double centre_Hz : kThirdOctaves_Hz) {
      const FrequencyBand band = third_octave(centre_Hz);
      if (band.high_Hz > 0.45 * rate_Hz) continue;
      EXPECT_NEAR(20.0 * std::log10(band_rms(other, rate_Hz, band.low_Hz, band.high_Hz) /
                                    band_rms(reference, 1000.0, band.low_Hz, band.high_Hz)),
                  0.0, 0.5)
          << rate_Hz << ' ' << centre_Hz;
    }
    // Neither images above half the rate of the models nor aliases.
    if (rate_Hz > 1200.0) {
      EXPECT_LT(band_rms(other, rate_Hz, 580.0, 0.5 * rate_Hz),
                0.01 * band_rms(other, rate_Hz, 5.0, 500.0));
    }
  }
}

// A loop whose ticks are early and late by up to 20 %.
TEST(DataDriven, IsTheSameInALoopWithJitter) {
  const RendererInputs inputs = of_models(resonant_models());
  const auto renderer = make_renderer(data_driven_model(), inputs);
  std::vector<ProbeState> path = samples_of({.duration_s = 20.5});
  Random jitter(8);
  renderer->reset(path.front());
  std::vector<double> played{};
  for (const ProbeState& probe : path) {
    const double dt_s = 0.001 * (1.0 + 0.4 * (jitter.uniform() - 0.5));
    played.push_back(renderer->tick(probe, dt_s).wrench.force_N.x);
  }
  played.erase(played.begin(), played.begin() + 500);
  const std::vector<double> steady = played_m_per_s2(inputs, {.duration_s = 20.5});
  const double scale = kEffectiveMass_kg * 0.06 / std::hypot(0.06, 0.01);
  for (const double centre_Hz : {31.5, 63.0, 125.0}) {
    const FrequencyBand band = third_octave(centre_Hz);
    EXPECT_NEAR(20.0 * std::log10(band_rms(played, 1000.0, band.low_Hz, band.high_Hz) /
                                  (scale * band_rms(steady, 1000.0, band.low_Hz, band.high_Hz))),
                0.0, 0.5)
        << centre_Hz;
  }
}

/// Slow vibrations, so that a tick changes the force little: a step of the state would stand out.
TEST(DataDriven, IsContinuousWhereAHandPassesFromTriangleToTriangle) {
  VibrationModels set{};
  for (const double speed_m_per_s : {0.03, 0.06, 0.15}) {
    for (const double normal_N : {0.5, 1.0, 2.0}) {
      const double angle = 2.0 * std::numbers::pi * (0.006 + 0.04 * speed_m_per_s);
      const double p = 1.98 * std::cos(angle);
      const double q = -0.9801;
      // (1 − p·z⁻¹ − q·z⁻²)·(1 − 0.9·z⁻¹): peaks of 7 to 12 Hz, and little above.
      set.models.push_back(
          {.speed_m_per_s = speed_m_per_s,
           .normal_N = normal_N,
           .variance_m2_per_s4 = 1e-4 * normal_N,
           .lines_rad = line_spectral_frequencies(std::vector{p + 0.9, q - 0.9 * p, -0.9 * q})});
    }
  }
  const auto renderer = make_renderer(data_driven_model(), of_models(set));
  std::vector<ProbeState> path{};
  double x_m = 0.0;
  for (int i = 0; i < 8000; ++i) {
    const double time_s = i / 1000.0;
    ProbeState probe;
    probe.time_ns = i * 1'000'000LL;
    probe.velocity_m_per_s.x = 0.09 + 0.07 * std::sin(2.0 * time_s);  // 20 to 160 mm/s
    x_m += probe.velocity_m_per_s.x / 1000.0;
    probe.position_m = {x_m, 0.0, -0.0026 + 0.0018 * std::sin(3.1 * time_s)};  // 0.4 to 2.2 N
    path.push_back(probe);
  }
  const std::vector<RenderedTick> ticks = along_path(*renderer, path, 1000.0);
  double largest = 0.0;
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 501; i < ticks.size(); ++i) {
    const double change = ticks[i].wrench.force_N.x - ticks[i - 1].wrench.force_N.x;
    largest = std::max(largest, std::abs(change));
    sum += change * change;
    square += ticks[i].wrench.force_N.x * ticks[i].wrench.force_N.x;
  }
  EXPECT_LT(largest, 6.0 * std::sqrt(sum / 7500.0));
  EXPECT_GT(std::sqrt(square / 7500.0), 10.0 * std::sqrt(sum / 7500.0));
}

// Readings that vary about a place, with a velocity to match.
TEST(DataDriven, IsThePlateAtRest) {
  for (const char* axis : {"binormal", "motion", "normal"}) {
    const auto renderer = make_renderer(
        data_driven_model(), of_models(resonant_models(), {{"axis", std::string(axis)}}));
    std::vector<ProbeState> path = samples_of({.duration_s = 0.5});
    const std::size_t stopped = path.size();
    add_rest(path, 60'000);
    const auto ticks = along_path(*renderer, path, 1000.0);
    double strongest_N = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double texture_N = glm::length(ticks[i].wrench.force_N - glm::dvec3(0.0, 0.0, 1.0));
      if (i < stopped) strongest_N = std::max(strongest_N, texture_N);
      if (i <= stopped + 60) continue;
      ASSERT_LT(texture_N, 1e-15) << axis << ' ' << i;
    }
    EXPECT_GT(strongest_N, 0.02) << axis;
  }
}

TEST(DataDriven, ActsAlongItsAxis) {
  const auto forces_N = [](const char* axis, const glm::dvec3& velocity_m_per_s) {
    const auto renderer = make_renderer(
        data_driven_model(), of_models(resonant_models(), {{"axis", std::string(axis)}}));
    std::vector<ProbeState> path = samples_of({.duration_s = 1.0});
    for (ProbeState& probe : path) {
      const double time_s = static_cast<double>(probe.time_ns) / 1e9;
      probe.velocity_m_per_s = velocity_m_per_s;
      probe.position_m = glm::dvec3(0.0, 0.0, -0.002) + time_s * velocity_m_per_s;
    }
    return along_path(*renderer, path, 1000.0).back().wrench.force_N - glm::dvec3(0.0, 0.0, 1.0);
  };
  const glm::dvec3 velocity_m_per_s{0.048, 0.036, 0.0};  // 60 mm/s
  const glm::dvec3 along = forces_N("motion", velocity_m_per_s);
  const double size_N = glm::length(along);
  EXPECT_GT(size_N, 1e-4);
  EXPECT_NEAR(std::abs(glm::dot(along, velocity_m_per_s)), size_N * 0.06, 1e-12);
  // t × n: a quarter of a turn clockwise, seen from above.
  const glm::dvec3 across = forces_N("binormal", velocity_m_per_s);
  EXPECT_LT(glm::length(across - glm::dvec3(along.y, -along.x, 0.0)), 1e-12);
  const glm::dvec3 up = forces_N("normal", velocity_m_per_s);
  EXPECT_EQ(up.x, 0.0);
  EXPECT_EQ(up.y, 0.0);
  EXPECT_NEAR(std::abs(up.z) * 0.06 / std::hypot(0.06, 0.01), size_N, 1e-12);
}

// The toolkit's friction in a published adaptation jumps from μ²·F_n to μ·F_n at μ/0.004 mm/s.
TEST(DataDriven, HasAFrictionWithoutAJump) {
  RendererInputs inputs =
      of_models(resonant_models(), {{"gain", 0.0}, {"friction_law", std::string("rounded")}});
  inputs.material.friction = 0.33;
  const auto renderer = make_renderer(data_driven_model(), inputs);
  ProbeState probe = probe_at({0.0, 0.0, -0.002});
  renderer->reset(probe);
  double before_N = 0.0;
  double largest_N = 0.0;
  for (int step = 1; step <= 2000; ++step) {
    probe.time_ns += 1'000'000;
    probe.velocity_m_per_s.x = 1e-4 * step;
    const double force_N = renderer->tick(probe, 0.001).wrench.force_N.x;
    largest_N = std::max(largest_N, std::abs(force_N - before_N));
    before_N = force_N;
  }
  EXPECT_LT(largest_N, 0.011 * 0.33);
  EXPECT_NEAR(before_N, -0.33, 0.001);
}

TEST(DataDriven, RefusesModelsThatItCannotInterpolate) {
  VibrationModels set = resonant_models();
  set.models[0].variance_m2_per_s4 = 0.0;
  EXPECT_THAT(refusal_of<std::invalid_argument>(
                  [&] { make_renderer(data_driven_model(), of_models(set)); }),
              testing::AllOf(testing::HasSubstr("vibration_models: model 1 at 0.03 m/s and 0.5 N"),
                             testing::HasSubstr("set variance to linear")));
  EXPECT_NE(
      make_renderer(data_driven_model(), of_models(set, {{"variance", std::string("linear")}})),
      nullptr);
  RendererInputs inputs = of_models(set);
  inputs.assets[kVibrationModelsRole] = std::make_shared<const std::string>("a list\n");
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { make_renderer(data_driven_model(), inputs); }),
      testing::HasSubstr("vibration_models:1: the column speed_m_per_s is missing"));
}

TEST(DataDriven, NamesTheFileOfItsModelsInMessages) {
  RendererInputs inputs = of_models(resonant_models());
  inputs.asset_names[kVibrationModelsRole] = "stimuli/wood.tsv";
  inputs.assets[kVibrationModelsRole] = std::make_shared<const std::string>("a list\n");
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { make_renderer(data_driven_model(), inputs); }),
      testing::StartsWith("stimuli/wood.tsv:1: the column speed_m_per_s is missing"));
}

}  // namespace
}  // namespace asperity
