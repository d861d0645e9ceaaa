// The height map's two laws against values worked out by hand.

#include "renderers/models/height_map.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

// k = 500 N/m and mu = 0.2 throughout: the defaults.
RendererInputs inputs_on(std::shared_ptr<const HeightField> field,
                         ParameterValues parameters = {}) {
  RendererInputs inputs;
  inputs.parameters = std::move(parameters);
  inputs.patch = wide_patch();
  inputs.height_field = std::move(field);
  return inputs;
}

TEST(CorrectedHeightMap, AddsTheTextureToThePenetration) {
  // d = 0.1 mm, tip 0.9 mm deep: w = 1.0 mm, F = 500 N/m · 1.0 mm = 0.5 N.
  const auto renderer = make_renderer(height_map_model(), inputs_on(level(0.0001F)));
  const RenderedTick tick = answer(*renderer, probe_at({0.0, 0.0, -0.0009}));
  EXPECT_NEAR(tick.penetration_m, 0.001, 1e-11);
  EXPECT_NEAR(tick.wrench.force_N.z, 0.5, 1e-8);
  EXPECT_EQ(tick.wrench.force_N.x, 0.0);
  EXPECT_EQ(tick.wrench.force_N.y, 0.0);
}

TEST(CorrectedHeightMap, IsFeltAboveThePlaneOnACrestAndNotInAValley) {
  const auto crest = make_renderer(height_map_model(), inputs_on(level(0.0001F)));
  const auto valley = make_renderer(height_map_model(), inputs_on(level(-0.0001F)));
  // 0.05 mm above the plane: 0.05 mm deep in a crest of 0.1 mm, F = 0.025 N; nothing in a valley.
  EXPECT_NEAR(answer(*crest, probe_at({0.0, 0.0, 0.00005})).wrench.force_N.z, 0.025, 1e-8);
  const RenderedTick over_valley = answer(*valley, probe_at({0.0, 0.0, -0.00005}));
  EXPECT_EQ(over_valley.penetration_m, 0.0);
  EXPECT_EQ(over_valley.wrench.force_N.z, 0.0);
}

TEST(CorrectedHeightMap, SaturatesContinuouslyAtTheDepthLimit) {
  // H = 3 mm: at most 500 · 0.003 = 1.5 N, reached without a jump.
  const auto renderer = make_renderer(height_map_model(), inputs_on(level(0.0F)));
  EXPECT_NEAR(answer(*renderer, probe_at({0, 0, -0.0029999})).wrench.force_N.z, 1.49995, 1e-9);
  EXPECT_NEAR(answer(*renderer, probe_at({0, 0, -0.0030001})).wrench.force_N.z, 1.5, 1e-9);
  EXPECT_NEAR(answer(*renderer, probe_at({0, 0, -0.0100000})).wrench.force_N.z, 1.5, 1e-9);
  EXPECT_NEAR(answer(*renderer, probe_at({0, 0, -0.01})).penetration_m, 0.01, 1e-12);
}

TEST(CorrectedHeightMap, ScalesTheHeights) {
  // s = 2, d = 0.1 mm, 0.8 mm deep: w = 1.0 mm.
  const auto renderer =
      make_renderer(height_map_model(), inputs_on(level(0.0001F), {{"height_scale", 2.0}}));
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -0.0008})).wrench.force_N.z, 0.5, 1e-8);
}

TEST(CorrectedHeightMap, RubsAgainstTheMotion) {
  // N = 0.5 N, mu = 0.2, v = 60 mm/s along (0.6, 0.8), v0 = 10 mm/s:
  // |F| = 0.2 · 0.5 · 60/sqrt(60² + 10²) = 0.1 · 0.98639 = 0.098639 N.
  const auto renderer = make_renderer(
      height_map_model(), inputs_on(level(0.0F), {{"friction_law", std::string("rounded")}}));
  ProbeState probe = probe_at({0.0, 0.0, -0.001});
  probe.velocity_m_per_s = {0.036, 0.048, 0.2};
  const glm::dvec3 force_N = answer(*renderer, probe).wrench.force_N;
  EXPECT_NEAR(force_N.x, -0.6 * 0.0986394, 1e-7);
  EXPECT_NEAR(force_N.y, -0.8 * 0.0986394, 1e-7);
  EXPECT_NEAR(force_N.z, 0.5, 1e-12);
}

TEST(CorrectedHeightMap, PushesDownTheSlopeInProportionToTheNormalForce) {
  // At x = 0 of A sin(2πx/L), A = 0.2 mm, L = 4 mm: d = 0, slope = 2πA/L = 0.31416.
  // 1 mm deep: N = 0.5 N; gain 2: F_x = −2 · 0.5 · 0.31416 = −0.31416 N.
  const auto renderer =
      make_renderer(height_map_model(), inputs_on(grating(), {{"lateral_gradient_gain", 2.0}}));
  const glm::dvec3 force_N = answer(*renderer, probe_at({0.0, 0.0, -0.001})).wrench.force_N;
  EXPECT_NEAR(force_N.x, -0.314159, 0.314159 * 0.001);
  EXPECT_NEAR(force_N.z, 0.5, 1e-6);
}

// With gain 1 and no friction the force is the gradient of ½ k w², so a closed path costs nothing.
// The path leaves the surface and is no mirror image of itself about a crest; height and motion are
// both scaled, so that a factor forgotten in the slope would show.
TEST(CorrectedHeightMap, IsConservativeWithALateralGainOfOne) {
  RendererInputs inputs =
      inputs_on(grating(), {{"lateral_gradient_gain", 1.0}, {"height_scale", 1.5}});
  inputs.material.friction = 0.0;
  inputs.patch.motion_scale = 2.0;
  const auto renderer = make_renderer(height_map_model(), inputs);
  constexpr int kSteps = 20000;
  const auto path_m = [](int step) {
    const double angle_rad = 2.0 * std::numbers::pi * step / kSteps;
    return glm::dvec3{0.0004 + 0.0013 * std::cos(angle_rad), 0.0,
                      -0.0004 + 0.0008 * std::sin(angle_rad + 0.6)};
  };
  double net_work_J = 0.0;
  double gross_work_J = 0.0;
  bool left = false;
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 from_m = path_m(step);
    const glm::dvec3 to_m = path_m(step + 1);
    const RenderedTick tick = answer(*renderer, probe_at(0.5 * (from_m + to_m)));
    const double work_J = glm::dot(tick.wrench.force_N, to_m - from_m);
    net_work_J += work_J;
    gross_work_J += std::abs(work_J);
    left = left || tick.penetration_m == 0.0;
  }
  EXPECT_TRUE(left);
  EXPECT_GT(gross_work_J, 1e-5);
  EXPECT_NEAR(net_work_J / gross_work_J, 0.0, 1e-6);
}

TEST(LiteralHeightMap, AddsEquationsOneAndTwo) {
  // k d = 500 · 0.1 mm = 0.05 N; k1 Δw = 400 · 1 mm = 0.4 N.
  const auto renderer = make_renderer(
      height_map_model(),
      inputs_on(level(0.0001F), {{"law", std::string("literal")}, {"k1_N_per_m", 400.0}}));
  const RenderedTick tick = answer(*renderer, probe_at({0.0, 0.0, -0.001}));
  EXPECT_NEAR(tick.wrench.force_N.z, 0.45, 1e-8);
  EXPECT_NEAR(tick.penetration_m, 0.001, 1e-15);
}

TEST(LiteralHeightMap, ActsOnlyBelowTheReferencePlane) {
  const auto renderer = make_renderer(height_map_model(),
                                      inputs_on(level(0.0001F), {{"law", std::string("literal")}}));
  const RenderedTick on_the_plane = answer(*renderer, probe_at({0.0, 0.0, 0.0}));
  EXPECT_EQ(on_the_plane.wrench.force_N.z, 0.0);
  EXPECT_EQ(on_the_plane.penetration_m, 0.0);
  EXPECT_GT(answer(*renderer, probe_at({0.0, 0.0, -1e-9})).wrench.force_N.z, 0.0499);
}

TEST(LiteralHeightMap, PullsOverAValleyAsEquationOneSays) {
  // d = −0.1 mm, Δw = 0.02 mm: −0.05 + 0.01 = −0.04 N.
  const auto renderer = make_renderer(
      height_map_model(), inputs_on(level(-0.0001F), {{"law", std::string("literal")}}));
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -0.00002})).wrench.force_N.z, -0.04, 1e-8);
}

TEST(LiteralHeightMap, CountsHeightsFromTheLowestWhenAsked) {
  // At the crest x = L/4: d − min d = 2A = 0.4 mm, k(d − min d) = 0.2 N; k1 Δw = 0.25 N.
  const auto renderer = make_renderer(
      height_map_model(), inputs_on(grating(), {{"law", std::string("literal")},
                                                {"offset", std::string("subtract_min")}}));
  EXPECT_NEAR(answer(*renderer, probe_at({0.001, 0.0, -0.0005})).wrench.force_N.z, 0.45, 1e-3);
}

TEST(LiteralHeightMap, IsConstantBeyondTheDepthLimit) {
  // k1 H = 500 · 3 mm = 1.5 N, without texture; just above it the texture's 0.05 N is still there.
  const auto renderer = make_renderer(height_map_model(),
                                      inputs_on(level(0.0001F), {{"law", std::string("literal")}}));
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -0.0029999})).wrench.force_N.z, 1.54995, 1e-6);
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -0.0031})).wrench.force_N.z, 1.5, 1e-12);
  EXPECT_NEAR(answer(*renderer, probe_at({0.0, 0.0, -0.0100})).wrench.force_N.z, 1.5, 1e-12);
}

TEST(LiteralHeightMap, HasNoForceAlongTheSurface) {
  const auto renderer = make_renderer(
      height_map_model(),
      inputs_on(grating(), {{"law", std::string("literal")}, {"lateral_gradient_gain", 1.0}}));
  ProbeState probe = probe_at({0.0003, 0.0, -0.001});
  probe.velocity_m_per_s = {0.06, 0.01, 0.0};
  const glm::dvec3 force_N = answer(*renderer, probe).wrench.force_N;
  EXPECT_EQ(force_N.x, 0.0);
  EXPECT_EQ(force_N.y, 0.0);
}

}  // namespace
}  // namespace asperity
