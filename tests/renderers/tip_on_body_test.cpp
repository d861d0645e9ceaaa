// A tip with a size on a body: one contact, whichever charts of the texture it lies in.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/force/point_on_body.h"
#include "renderers/models/elastic_halfspace.h"
#include "renderers/models/winkler.h"
#include "tests/renderers/points_on_bodies.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kPressed_m = 0.0005;

std::uint64_t ticks_of(const ForceRenderer& renderer, std::string_view limit) {
  for (const NamedCount& count : renderer.limits()) {
    if (count.name == limit) return count.ticks;
  }
  ADD_FAILURE() << limit;
  return 0;
}

/// A stroke around the globe at a constant depth, from one angle off +z towards +x to another one.
std::vector<ProbeState> around_globe(double from_rad, double to_rad, double speed_m_per_s) {
  const double radius_m = kGlobeRadius_m - kPressed_m;
  const auto ticks = static_cast<int>((to_rad - from_rad) * radius_m / speed_m_per_s / kTick_s);
  std::vector<ProbeState> path{};
  for (int tick = 0; tick <= ticks; ++tick) {
    const double angle_rad = from_rad + (to_rad - from_rad) * tick / ticks;
    ProbeState probe = between_axes(2, 0, angle_rad, radius_m);
    probe.time_ns = 1'000'000LL * tick;
    probe.velocity_m_per_s =
        speed_m_per_s * glm::dvec3(std::cos(angle_rad), 0.0, -std::sin(angle_rad));
    path.push_back(probe);
  }
  return path;
}

glm::dvec3 outward(const ProbeState& probe) {
  return glm::normalize(probe.position_m + glm::dvec3(0.0, 0.0, kGlobeRadius_m));
}

TEST(TipOnBody, IsThatOfThePlaneOnAFlatBody) {
  for (const ForceModel& model : {elastic_halfspace_model(), winkler_model()}) {
    RendererInputs inputs = inputs_on_body(flat_plate());
    inputs.material.friction = 0.2;
    inputs.patch.texture_origin_m = {0.0007, 0.0};
    const auto on_body = make_renderer(model, inputs);
    inputs.body.reset();
    const auto on_plane = make_renderer(model, inputs);
    const std::vector<ProbeState> path =
        samples_of({.from_x_m = -0.01, .height_m = -kPressed_m, .duration_s = 0.2});
    on_body->reset(path.front());
    on_plane->reset(path.front());
    for (const ProbeState& probe : path) {
      const RenderedTick body = on_body->tick(probe, kTick_s);
      const RenderedTick plane = on_plane->tick(probe, kTick_s);
      ASSERT_LT(glm::length(body.wrench.force_N - plane.wrench.force_N), 1e-6)
          << model.declaration.id << ' ' << probe.position_m.x;
      ASSERT_NEAR(body.penetration_m, plane.penetration_m, 1e-12);
    }
  }
}

// A body that relaxes to a third, under a tip that begins to slide: on a smooth globe the force is that on a plane over which the
// proxy would move as far, also from 40° to 50°, where the charts of +z and +x blend. A contact that began again in a chart would
// be up to three times as stiff.
TEST(TipOnBody, KeepsItsDentWhereChartsBlend) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr double kStroke_m_per_s = 0.06;
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.height_field = level(0.0F);
  inputs.parameters = {{"relaxation_ratio", 3.0}, {"relaxation_time_s", 0.1}};
  const auto on_globe = make_renderer(elastic_halfspace_model(), inputs);
  inputs.body.reset();
  const auto on_plane = make_renderer(elastic_halfspace_model(), inputs);
  const std::vector<ProbeState> path = around_globe(5.0 * kDegree, 85.0 * kDegree, kStroke_m_per_s);
  const double step_m = 80.0 * kDegree * kGlobeRadius_m / static_cast<double>(path.size() - 1);
  ProbeState level_probe = probe_at({0.0, 0.0, -kPressed_m});
  on_globe->reset(path.front());
  on_plane->reset(level_probe);
  for (const ProbeState& probe : path) {
    const glm::dvec3 globe_N = on_globe->tick(probe, kTick_s).wrench.force_N;
    const glm::dvec3 plane_N = on_plane->tick(level_probe, kTick_s).wrench.force_N;
    const glm::dvec3 normal = outward(probe);
    const glm::dvec3 along{normal.z, 0.0, -normal.x};
    const double angle_deg = std::atan2(normal.x, normal.z) / kDegree;
    ASSERT_NEAR(glm::dot(globe_N, normal), plane_N.z, 0.005 * plane_N.z) << angle_deg;
    ASSERT_NEAR(glm::dot(globe_N, along), plane_N.x, 0.005 * plane_N.z) << angle_deg;
    level_probe.position_m.x += step_m;
  }
}

TEST(TipOnBody, ComputesOneContactInATick) {
  for (const ForceModel& model : {elastic_halfspace_model(), winkler_model()}) {
    const auto renderer = make_renderer(model, inputs_on_body(sphere()));
    const std::vector<ProbeState> path = around_globe(0.6, 1.0, 0.2);
    renderer->reset(path.front());
    for (const ProbeState& probe : path) renderer->tick(probe, kTick_s);
    EXPECT_EQ(ticks_of(*renderer, "contact"), path.size()) << model.declaration.id;
  }
}

TEST(TipOnBody, FeelsTheReliefWithoutAStepWhereChartsBlend) {
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.height_field = grating({.amplitude_m = 1e-4, .wavelength_m = 0.004, .pitch_m = 1e-4});
  const auto renderer = make_renderer(winkler_model(), inputs);
  const std::vector<ProbeState> path = around_globe(0.1, 1.45, 0.02);
  renderer->reset(path.front());
  glm::dvec3 last_N = renderer->tick(path.front(), kTick_s).wrench.force_N;
  double least_N = glm::length(last_N);
  double greatest_N = least_N;
  double step_N = 0.0;
  for (const ProbeState& probe : path) {
    const glm::dvec3 force_N = renderer->tick(probe, kTick_s).wrench.force_N;
    step_N = std::max(step_N, glm::length(force_N - last_N));
    least_N = std::min(least_N, glm::length(force_N));
    greatest_N = std::max(greatest_N, glm::length(force_N));
    last_N = force_N;
  }
  EXPECT_GT(greatest_N - least_N, 0.2 * greatest_N);  // the grating is felt
  // A tick is 20 µm of a wave of 4 mm: 2π/200 of half of the range.
  EXPECT_LT(step_N, 0.05 * (greatest_N - least_N) + 0.002 * greatest_N);
}

TEST(TipOnBody, DoesNotAllocateInATick) {
  const auto renderer = make_renderer(elastic_halfspace_model(), inputs_on_body(sphere()));
  const std::vector<ProbeState> path = around_globe(0.6, 1.0, 0.2);
  renderer->reset(path.front());
  const AllocationGuard guard;
  for (const ProbeState& probe : path) renderer->tick(probe, kTick_s);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
