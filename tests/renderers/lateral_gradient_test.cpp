// Minsky's law.

#include "renderers/models/lateral_gradient.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
