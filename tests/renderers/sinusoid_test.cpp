// The grating against values worked out by hand.

#include "renderers/models/sinusoid.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

// A = 0.5 mm, L = 2 mm, k = 500 N/m.
std::unique_ptr<ForceRenderer> sinusoid_with(ParameterValues parameters) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.parameters["amplitude_m"] = 0.0005;
  inputs.parameters["wavelength_m"] = 0.002;
  inputs.patch = wide_patch();
  return make_renderer(sinusoid_model(), inputs);
}

TEST(Sinusoid, FollowsEquationFour) {
  const auto renderer = sinusoid_with({});
  // h = A at x = 0, 2A at L/4, 0 at −L/4. Tip on the plane: F = 500·0.5 mm, 500·1 mm, 0.
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, 0.0})).wrench.force_N.z, 0.25, 1e-12);
  EXPECT_NEAR(answer(*renderer, probe_at({0.0005, 0.0, 0.0})).wrench.force_N.z, 0.5, 1e-12);
  EXPECT_NEAR(answer(*renderer, probe_at({-0.0005, 0.0, 1e-9})).wrench.force_N.z, 0.0, 1e-12);
  // 0.3 mm over the plane at x = 0: w = 0.2 mm.
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, 0.0003})).penetration_m, 0.0002, 1e-15);
}

TEST(Sinusoid, IsNotFeltAboveItsHeight) {
  const auto renderer = sinusoid_with({});
  const RenderedTick tick = answer(*renderer, probe_at({0.0, 0.0, 0.00051}));
  EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(tick.penetration_m, 0.0);
}

TEST(Sinusoid, PointsUpByDefault) {
  const glm::dvec3 force_N = answer(*sinusoid_with({}), probe_at({0.0, 0.0, 0.0})).wrench.force_N;
  EXPECT_EQ(force_N.x, 0.0);
  EXPECT_EQ(force_N.y, 0.0);
}

TEST(Sinusoid, KeepsItsMagnitudeAlongTheLocalNormal) {
  // Slope at x = 0: 2πA/L = π/2 = 1.5708; |n| un-normalised = sqrt(1 + π²/4) = 1.86210.
  // F = 0.25 N: F_z = 0.25/1.86210 = 0.134257, F_x = −1.5708·0.134257 = −0.210891.
  const auto renderer = sinusoid_with({{"force_direction", std::string("local_normal")}});
  const glm::dvec3 force_N = answer(*renderer, probe_at({0.0, 0.0, 0.0})).wrench.force_N;
  EXPECT_NEAR(force_N.z, 0.134257, 1e-6);
  EXPECT_NEAR(force_N.x, -0.210891, 1e-6);
  EXPECT_NEAR(glm::length(force_N), 0.25, 1e-12);
}

TEST(Sinusoid, IsTheGradientOfItsEnergyOnRequest) {
  // At x = 0: w = 0.5 mm, slope π/2: F_z = k·w = 0.25 N and F_x = −0.25·π/2 = −0.392699 N.
  const auto renderer = sinusoid_with({{"force_direction", std::string("gradient")}});
  const glm::dvec3 force_N = answer(*renderer, probe_at({0.0, 0.0, 0.0})).wrench.force_N;
  EXPECT_NEAR(force_N.z, 0.25, 1e-12);
  EXPECT_NEAR(force_N.x, -0.392699, 1e-6);
  // −∇U of U = ½·k·w² by differences, away from the axis, with a slope in x and y.
  const auto oblique =
      sinusoid_with({{"force_direction", std::string("gradient")}, {"direction_rad", 0.6}});
  const auto energy_J = [&](const glm::dvec3& at_m) {
    return 0.5 * 500.0 * std::pow(answer(*oblique, probe_at(at_m)).penetration_m, 2);
  };
  const glm::dvec3 at_m{0.0003, 0.0001, 0.0001};
  const glm::dvec3 oblique_N = answer(*oblique, probe_at(at_m)).wrench.force_N;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step_m{0.0};
    step_m[axis] = 1e-7;
    EXPECT_NEAR(oblique_N[axis], (energy_J(at_m - step_m) - energy_J(at_m + step_m)) / 2e-7, 1e-6)
        << axis;
  }
}

TEST(Sinusoid, VariesAlongItsDirection) {
  // θ = 90°: the crest lies at y = L/4, whatever x.
  const auto renderer = sinusoid_with({{"direction_rad", std::numbers::pi / 2}});
  EXPECT_NEAR(answer(*renderer, probe_at({0.0007, 0.0005, 0.0})).wrench.force_N.z, 0.5, 1e-9);
  EXPECT_NEAR(answer(*renderer, probe_at({0.0007, 0.0, 0.0})).wrench.force_N.z, 0.25, 1e-9);
}

TEST(Sinusoid, FindsItselfInASampleOfASinusoid) {
  // 0.2 mm and 4 mm: an amplitude of equal RMS, and the wavelength that dominates. The sample is
  // four waves long, so lines of its spectrum are 1/4 of the answer apart; a window spreads it over
  // them.
  const ParameterValues suggested =
      sinusoid_model().suggested_by(*grating({.rows = 320}), Material{});
  EXPECT_NEAR(number_of(suggested, "amplitude_m"), 0.0002, 1e-8);
  EXPECT_NEAR(number_of(suggested, "wavelength_m"), 0.004, 0.1 * 0.004);
}

TEST(Sinusoid, KeepsItsWavelengthForASampleWithoutOne) {
  const ParameterValues suggested = sinusoid_model().suggested_by(*level(0.0F), Material{});
  EXPECT_EQ(suggested.count("wavelength_m"), 0U);
  EXPECT_EQ(number_of(suggested, "amplitude_m"), 0.0);
}

}  // namespace
}  // namespace asperity
