// Minsky's law.

#include "renderers/models/lateral_gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "renderers/offline/along_path.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

RendererInputs gradient_inputs(std::shared_ptr<const HeightField> field, double gain_N) {
  RendererInputs inputs;
  inputs.parameters = {{"gain_N", gain_N}};
  inputs.material.friction = 0.0;
  inputs.patch = wide_patch();
  inputs.height_field = std::move(field);
  return inputs;
}

double largest_lateral_N(ForceRenderer& renderer, double height_m) {
  double largest_N = 0.0;
  const auto path = samples_of({.height_m = height_m, .speed_m_per_s = 0.01, .duration_s = 1.0});
  for (const RenderedTick& tick : along_path(renderer, path, 1000.0)) {
    largest_N = std::max(largest_N, std::abs(tick.wrench.force_N.x));
  }
  return largest_N;
}

TEST(LateralGradient, PushesASinusoidWithAtMostTwoPiAKOverL) {
  // K 2πA/L = 1.5 · 2π · 0.2/4 = 0.471239 N.
  const auto renderer = make_renderer(lateral_gradient_model(), gradient_inputs(grating(), 1.5));
  EXPECT_NEAR(largest_lateral_N(*renderer, -0.001), 0.471239, 0.01 * 0.471239);
}

TEST(LateralGradient, DoesNotDependOnTheNormalForce) {
  const auto renderer = make_renderer(lateral_gradient_model(), gradient_inputs(grating(), 1.5));
  EXPECT_EQ(largest_lateral_N(*renderer, -0.001), largest_lateral_N(*renderer, -0.004));
}

TEST(LateralGradient, IsProportionalToTheNormalForceOnRequest) {
  // 500 N/m: 0.5 N at 1 mm and 2 N at 4 mm, half and twice the force of 1.5 · 2π · 0.2/4 N.
  RendererInputs inputs = gradient_inputs(grating(), 1.5);
  inputs.parameters["law"] = std::string("force");
  const auto renderer = make_renderer(lateral_gradient_model(), inputs);
  EXPECT_NEAR(largest_lateral_N(*renderer, -0.001), 0.235619, 0.01 * 0.235619);
  EXPECT_NEAR(largest_lateral_N(*renderer, -0.004), 0.942478, 0.01 * 0.942478);
  EXPECT_NEAR(largest_lateral_N(*renderer, -1e-9), 0.0, 1e-6);  // no jump at contact
  inputs.parameters["law"] = std::string("constant");
  const auto constant = make_renderer(lateral_gradient_model(), inputs);
  const glm::dvec3 at_m{0.0003, 0.0, -0.002};  // 1 N: both laws are equal
  EXPECT_NEAR(answer(*renderer, probe_at(at_m)).wrench.force_N.x,
              answer(*constant, probe_at(at_m)).wrench.force_N.x, 1e-12);
}

// From a trough to the next crest at 1 mm, back at 3 mm: K·k·(w₂ − w₁)·2A = 1.5·500·2 mm·0.4 mm = 0.6 mJ.
TEST(LateralGradient, DoesTheWorkOfItsClosedFormOnALoopInProportionToTheForce) {
  RendererInputs inputs = gradient_inputs(grating(), 1.5);
  const auto work_J = [&](const char* law) {
    inputs.parameters["law"] = std::string(law);
    const auto renderer = make_renderer(lateral_gradient_model(), inputs);
    constexpr int kParts = 2000;
    double sum_J = 0.0;
    for (int part = 0; part < kParts; ++part) {
      const double x_m = 0.004 * (-0.25 + 0.5 * (part + 0.5) / kParts);
      sum_J += answer(*renderer, probe_at({x_m, 0.0, -0.001})).wrench.force_N.x * 0.002 / kParts;
      sum_J -= answer(*renderer, probe_at({x_m, 0.0, -0.003})).wrench.force_N.x * 0.002 / kParts;
    }
    return sum_J;  // the ways down and up are along the normal force of a plate, which returns it
  };
  EXPECT_NEAR(work_J("force"), 6e-4, 1e-6);
  EXPECT_NEAR(work_J("constant"), 0.0, 1e-12);
}

TEST(LateralGradient, PushesDownTheSlope) {
  // Just right of a trough at x = −L/4 the height rises with x: the force points back to −x.
  const auto renderer = make_renderer(lateral_gradient_model(), gradient_inputs(grating(), 1.0));
  EXPECT_LT(answer(*renderer, probe_at({-0.0005, 0.0, -0.001})).wrench.force_N.x, -0.1);
  EXPECT_GT(answer(*renderer, probe_at({-0.0015, 0.0, -0.001})).wrench.force_N.x, 0.1);
}

TEST(LateralGradient, IsAPlainPlateInItsNormalForce) {
  // On a crest of 0.2 mm, 1 mm below the plane: 500 N/m · 1 mm, the crest does not matter.
  const auto renderer = make_renderer(lateral_gradient_model(), gradient_inputs(grating(), 1.0));
  EXPECT_NEAR(answer(*renderer, probe_at({0.001, 0.0, -0.001})).wrench.force_N.z, 0.5, 1e-12);
}

TEST(LateralGradient, IsSilentOutOfContact) {
  const auto renderer = make_renderer(lateral_gradient_model(), gradient_inputs(grating(), 1.0));
  const RenderedTick tick = answer(*renderer, probe_at({0.0, 0.0, 0.0}));
  EXPECT_EQ(tick.wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(tick.penetration_m, 0.0);
}

}  // namespace
}  // namespace asperity
