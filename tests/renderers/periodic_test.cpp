// The double Fourier series against its closed forms.

#include "renderers/models/periodic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/models/sinusoid.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kRelief_N_per_m = 800.0;
constexpr double kBelow_m = 0.003;

RendererInputs wave_inputs(ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.material = {.stiffness_N_per_m = kRelief_N_per_m, .friction = 0.0};
  inputs.patch = wide_patch();
  return inputs;
}

std::unique_ptr<ForceRenderer> periodic_with(const ParameterValues& parameters) {
  return make_renderer(periodic_model(), wave_inputs(parameters));
}

/// Two waves that are not along an axis, one that is, and periods of 2 and 3 mm.
ParameterValues oblique_waves() {
  return {{"period_x_m", 0.002},
          {"period_y_m", 0.003},
          {"waves_x_1", 1.0},
          {"waves_y_1", 2.0},
          {"cosine_amplitude_1_m", 3e-5},
          {"sine_amplitude_1_m", -5e-5},
          {"waves_x_2", 1.0},
          {"waves_y_2", -2.0},
          {"cosine_amplitude_2_m", 4e-5},
          {"sine_amplitude_2_m", 2e-5},
          {"waves_x_3", 0.0},
          {"waves_y_3", 3.0},
          {"cosine_amplitude_3_m", 0.0},
          {"sine_amplitude_3_m", 6e-5},
          {"height_scale", 1.5}};
}

double height_m(ForceRenderer& renderer, double x_m, double y_m) {
  return answer(renderer, probe_at({x_m, y_m, -kBelow_m})).wrench.force_N.z / kRelief_N_per_m -
         kBelow_m;
}

TEST(Periodic, IsTheSinusoidWithOneTerm) {
  for (const char* const direction : {"fixed", "local_normal", "gradient"}) {
    for (const double motion_scale : {1.0, 0.7}) {
      RendererInputs one = wave_inputs({{"sine_amplitude_1_m", 2e-4},
                                        {"period_x_m", 0.0015},
                                        {"force_direction", std::string(direction)}});
      RendererInputs other = wave_inputs({{"amplitude_m", 2e-4},
                                          {"wavelength_m", 0.0015},
                                          {"force_direction", std::string(direction)}});
      one.material.friction = other.material.friction = 0.3;
      one.patch.motion_scale = other.patch.motion_scale = motion_scale;
      const auto waves = make_renderer(periodic_model(), one);
      const auto sinusoid = make_renderer(sinusoid_model(), other);
      for (int place = -60; place < 60; ++place) {
        ProbeState probe = probe_at({7.1e-5 * place, 1e-3, 1e-5 * (place % 17) - 1e-4});
        probe.velocity_m_per_s = {0.05, -0.02, 0.0};
        const glm::dvec3 found_N = answer(*waves, probe).wrench.force_N;
        probe.position_m.z += 2e-4;  // the plane of the sinusoid is that of its troughs
        const glm::dvec3 expected_N = answer(*sinusoid, probe).wrench.force_N;
        EXPECT_LT(glm::length(found_N - expected_N), 1e-12) << direction << ' ' << place;
      }
    }
  }
}

TEST(Periodic, HasTheHeightsOfItsTerms) {
  const auto relief = periodic_with(oblique_waves());
  const double x_m = 3e-4;
  const double y_m = -7e-4;
  const auto phase_rad = [&](double m, double n) {
    return 2.0 * std::numbers::pi * (m * x_m / 0.002 + n * y_m / 0.003);
  };
  const double expected_m =
      1.5 * (3e-5 * std::cos(phase_rad(1, 2)) - 5e-5 * std::sin(phase_rad(1, 2)) +
             4e-5 * std::cos(phase_rad(1, -2)) + 2e-5 * std::sin(phase_rad(1, -2)) +
             6e-5 * std::sin(phase_rad(0, 3)));
  EXPECT_NEAR(height_m(*relief, x_m, y_m), expected_m, 1e-15);
}

TEST(Periodic, HasTheRmsAndTheSlopeOfItsAmplitudes) {
  ParameterValues values = oblique_waves();
  values["force_direction"] = std::string("gradient");
  const auto relief = periodic_with(values);
  constexpr int kPlaces = 48;
  double heights_m2 = 0.0;
  double slopes = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    for (int j = 0; j < kPlaces; ++j) {
      const glm::dvec3 force_N =
          answer(*relief, probe_at({0.002 * i / kPlaces, 0.003 * j / kPlaces, -kBelow_m}))
              .wrench.force_N;
      heights_m2 += std::pow(force_N.z / kRelief_N_per_m - kBelow_m, 2) / (kPlaces * kPlaces);
      slopes += (force_N.x * force_N.x + force_N.y * force_N.y) / (force_N.z * force_N.z) /
                (kPlaces * kPlaces);
    }
  }
  const double one_m2 = 3e-5 * 3e-5 + 5e-5 * 5e-5;
  const double two_m2 = 4e-5 * 4e-5 + 2e-5 * 2e-5;
  const double three_m2 = 6e-5 * 6e-5;
  const double turn = std::pow(2.0 * std::numbers::pi, 2);
  const double tilted_per_m2 = 1.0 / (0.002 * 0.002) + 4.0 / (0.003 * 0.003);
  const double upright_per_m2 = 9.0 / (0.003 * 0.003);
  const double expected_m2 = 2.25 * (one_m2 + two_m2 + three_m2) / 2.0;
  EXPECT_NEAR(heights_m2, expected_m2, 1e-9 * expected_m2);
  const double expected_slopes =
      2.25 * turn * (tilted_per_m2 * (one_m2 + two_m2) + upright_per_m2 * three_m2) / 2.0;
  EXPECT_NEAR(slopes, expected_slopes, 1e-9 * expected_slopes);
}

TEST(Periodic, OvershootsASquareGratingAsGibbsSays) {
  constexpr double kHalfStep_m = 1e-4;
  ParameterValues values{};
  for (int wave = 1; wave <= 4; ++wave) {
    const double order = 2.0 * wave - 1.0;
    values["waves_x_" + std::to_string(wave)] = order;
    values["sine_amplitude_" + std::to_string(wave) + "_m"] =
        4.0 * kHalfStep_m / (std::numbers::pi * order);
  }
  const auto square = periodic_with(values);
  double highest_m = 0.0;
  for (int place = 0; place < 20000; ++place) {
    highest_m = std::max(highest_m, height_m(*square, 1e-7 * place, 0.0));
  }
  EXPECT_NEAR((highest_m - kHalfStep_m) / (2.0 * kHalfStep_m), 0.0921, 5e-5);
  // At the middle of the crest: 4/π·(1 − 1/3 + 1/5 − 1/7) = 0.921583.
  EXPECT_NEAR(height_m(*square, 5e-4, 0.0), 0.921583 * kHalfStep_m, 1e-10);
}

TEST(Periodic, IsTheGradientOfItsEnergyOnRequest) {
  ParameterValues values = oblique_waves();
  values["force_direction"] = std::string("gradient");
  const auto relief = periodic_with(values);
  const auto energy_J = [&](const glm::dvec3& at_m) {
    return 0.5 * kRelief_N_per_m * std::pow(answer(*relief, probe_at(at_m)).penetration_m, 2);
  };
  const glm::dvec3 at_m{2.3e-4, 6.1e-4, -4e-4};
  const glm::dvec3 force_N = answer(*relief, probe_at(at_m)).wrench.force_N;
  EXPECT_GT(std::abs(force_N.x), 0.01);
  EXPECT_GT(std::abs(force_N.y), 0.01);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step_m{0.0};
    step_m[axis] = 1e-7;
    EXPECT_NEAR(force_N[axis], (energy_J(at_m - step_m) - energy_J(at_m + step_m)) / 2e-7, 1e-6)
        << axis;
  }
}

TEST(Periodic, IsNotFeltAboveItsWaves) {
  const auto relief = periodic_with({});
  const RenderedTick above = answer(*relief, probe_at({5e-4, 0.0, 1.001e-4}));
  EXPECT_EQ(above.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(above.penetration_m, 0.0);
  EXPECT_NEAR(answer(*relief, probe_at({5e-4, 0.0, 0.9e-4})).penetration_m, 1e-5, 1e-12);
}

TEST(Periodic, TakesOneWaveFromASample) {
  const ParameterValues suggested =
      periodic_model().suggested_by(*grating({.rows = 320}), Material{});
  EXPECT_NEAR(number_of(suggested, "sine_amplitude_1_m"), 0.0002, 1e-8);
  EXPECT_NEAR(number_of(suggested, "period_x_m"), 0.004, 0.1 * 0.004);
  EXPECT_EQ(periodic_model().suggested_by(*level(0.0F), Material{}).count("period_x_m"), 0U);
}

TEST(Periodic, RefusesAWaveThatIsGivenTwice) {
  const auto refusal = [](const ParameterValues& values) {
    return refusal_of<std::invalid_argument>([&] { periodic_with(values); });
  };
  EXPECT_THAT(refusal({{"waves_x_2", 1.0}, {"sine_amplitude_2_m", 1e-5}}),
              testing::HasSubstr("The terms 1 and 2 are the same wave"));
  EXPECT_THAT(refusal({{"waves_x_1", 0.0}, {"waves_y_1", -1.0}}),
              testing::HasSubstr("waves_x_1 is 0 and waves_y_1 is -1"));
  EXPECT_THAT(refusal({{"waves_x_1", 0.0}}), testing::HasSubstr("a wave needs"));
  // Without an amplitude there is no wave.
  EXPECT_EQ(refusal({{"waves_x_2", 1.0}}), "");
  EXPECT_EQ(refusal({{"waves_x_1", 0.0}, {"waves_y_1", 1.0}}), "");
  const std::optional<ParameterConflict> conflict =
      periodic_model().declaration.conflict_among(complete_values(
          periodic_model().declaration, {{"waves_x_3", 1.0}, {"cosine_amplitude_3_m", 1e-5}}));
  ASSERT_TRUE(conflict);
  EXPECT_THAT(conflict->parameters, testing::ElementsAre("waves_y_3", "waves_x_3"));
}

}  // namespace
}  // namespace asperity
