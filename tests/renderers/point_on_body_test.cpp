// Point models on bodies.

#include "renderers/force/point_on_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/renderers/points_on_bodies.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

std::unique_ptr<ForceRenderer> renderer_on_body(const std::string& model, RendererInputs inputs) {
  return built_in_models().make(model, inputs);
}

/// A probe on a circle through the pole of the sphere, in a plane that contains the z axis.
ProbeState on_circle(double angle_rad, double radius_m, double speed_m_per_s) {
  constexpr double kPlane_rad = 0.2;
  const glm::dvec3 across{std::cos(kPlane_rad), std::sin(kPlane_rad), 0.0};
  ProbeState probe;
  probe.position_m =
      radius_m * (std::sin(angle_rad) * across + glm::dvec3(0.0, 0.0, std::cos(angle_rad))) -
      glm::dvec3(0.0, 0.0, kGlobeRadius_m);
  probe.velocity_m_per_s =
      speed_m_per_s * (std::cos(angle_rad) * across - glm::dvec3(0.0, 0.0, std::sin(angle_rad)));
  probe.time_ns = std::llround(1e9 * angle_rad * radius_m / speed_m_per_s);
  return probe;
}

TEST(PointOnBody, ALevelFieldOnASphereIsASphereOfRadiusRPlusH) {
  constexpr float kHeight_m = 0.0003F;
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.height_field = level(kHeight_m);
  const auto renderer = renderer_on_body("height_map", inputs);
  for (const double depth_m : {0.0001, 0.0005, 0.001}) {
    for (int i = 0; i < 600; ++i) {
      const ProbeState probe = on_circle(0.01 * i, kGlobeRadius_m + kHeight_m - depth_m, 0.1);
      const RenderedTick tick = answer(*renderer, probe);
      const glm::dvec3 out =
          glm::normalize(probe.position_m + glm::dvec3(0.0, 0.0, kGlobeRadius_m));
      // The facets of the sphere are up to 0.3 µm inside it.
      EXPECT_NEAR(tick.penetration_m, depth_m, 5e-7);
      EXPECT_LT(glm::distance(tick.wrench.force_N, kBodyStiffness_N_per_m * depth_m * out),
                5e-4 + 2e-3 * depth_m * kBodyStiffness_N_per_m)
          << i;
    }
  }
}

TEST(PointOnBody, OnALevelSideEveryModelGivesTheForceOfThePlane) {
  for (const ForceModel& model : point_models()) {
    RendererInputs inputs = inputs_on_body(flat_plate());
    inputs.material.friction = 0.3;
    const auto on_body = make_renderer(model, inputs);
    inputs.body.reset();
    const auto on_plane = make_renderer(model, inputs);
    const std::vector<ProbeState> path =
        samples_of({.from_x_m = -0.03, .height_m = -0.001, .duration_s = 1.0});
    on_body->reset(path.front());
    on_plane->reset(path.front());
    double greatest_N = 0.0;
    for (const ProbeState& probe : path) {
      const RenderedTick one = on_body->tick(probe, kTick_s);
      const RenderedTick other = on_plane->tick(probe, kTick_s);
      ASSERT_LT(glm::distance(one.wrench.force_N, other.wrench.force_N), 1e-9)
          << model.declaration.id << " at " << probe.position_m.x;
      ASSERT_NEAR(one.penetration_m, other.penetration_m, 1e-12);
      greatest_N = std::max(greatest_N, glm::length(one.wrench.force_N));
    }
    EXPECT_GT(greatest_N, 0.5) << model.declaration.id;
  }
}

TEST(PointOnBody, TheForceHasNoStepAtASeamBetweenCharts) {
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.parameters = {{"amplitude_m", 1e-4}, {"wavelength_m", 0.002}};
  const auto renderer = renderer_on_body("sinusoid", inputs);
  constexpr double kStep_rad = 1e-4;  // 2 µm
  double greatest_N = 0.0;
  glm::dvec3 last_N{0.0};
  for (int i = 0; i * kStep_rad < 1.5; ++i) {
    const ProbeState probe = on_circle(i * kStep_rad, kGlobeRadius_m - 0.0005, 0.1);
    if (i == 0) renderer->reset(probe);
    const glm::dvec3 force_N = renderer->tick(probe, kTick_s).wrench.force_N;
    if (i > 0) greatest_N = std::max(greatest_N, glm::distance(force_N, last_N));
    last_N = force_N;
  }
  // The grating alone: 2 µm · 2π/2 mm · 0.1 mm · 1 N/mm = 0.6 mN, and the blend of forces that differ by 0.2 N over
  // the 12° in which the charts blend, at most 1.5 · 0.2 N · 1e-4/0.21.
  EXPECT_LT(greatest_N, 1.2e-3);
  EXPECT_GT(greatest_N, 0.5e-3);
}

TEST(PointOnBody, FrictionContinuesFromChartToChart) {
  for (const char* const law : {"rounded", "bounded", "proxy", "elastoplastic", "dahl", "lugre"}) {
    RendererInputs inputs = inputs_on_body(sphere());
    inputs.material.friction = 0.4;
    inputs.parameters = {{"amplitude_m", 0.0}, {"friction_law", std::string(law)}};
    const auto renderer = renderer_on_body("sinusoid", inputs);
    constexpr double kSpeed_m_per_s = 0.1;
    constexpr double kFrom_rad = -0.6;
    constexpr double kSliding_rad = 0.5;  // after 22 mm, before the charts blend
    const double step_rad = kSpeed_m_per_s * kTick_s / kGlobeRadius_m;
    std::optional<double> sliding_N{};
    for (int i = 0; kFrom_rad + i * step_rad < 1.5; ++i) {
      const double angle_rad = kFrom_rad + i * step_rad;
      const ProbeState probe = on_circle(angle_rad, kGlobeRadius_m - 0.001, kSpeed_m_per_s);
      if (i == 0) renderer->reset(probe);
      const glm::dvec3 force_N = renderer->tick(probe, kTick_s).wrench.force_N;
      if (angle_rad < kSliding_rad) continue;
      const double along_N =
          glm::dot(force_N, probe.velocity_m_per_s) / glm::length(probe.velocity_m_per_s);
      if (!sliding_N) sliding_N = along_N;
      EXPECT_NEAR(along_N, *sliding_N, 0.01) << law << " at " << angle_rad << " rad";
    }
    EXPECT_LT(*sliding_N, -0.25) << law;
  }
}

TEST(PointOnBody, TextureOnAnInclinedSideIsLongerByTheInverseCosine) {
  // The crest at x = 2.5 L of the chart lies at the angle θ with R sin θ = 2.5 L.
  constexpr double kWavelength_m = 0.003;
  constexpr double kBodyAmplitude_m = 1e-4;
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.parameters = {{"amplitude_m", kBodyAmplitude_m}, {"wavelength_m", kWavelength_m}};
  const auto renderer = renderer_on_body("sinusoid", inputs);
  const auto depth_at = [&](double x_m) {
    const double z_m = std::sqrt(kGlobeRadius_m * kGlobeRadius_m - x_m * x_m) - kGlobeRadius_m;
    return answer(*renderer, probe_at({x_m, 0.0, z_m})).penetration_m;
  };
  EXPECT_NEAR(depth_at(2.25 * kWavelength_m), 2.0 * kBodyAmplitude_m, 1e-6);
  EXPECT_NEAR(depth_at(2.75 * kWavelength_m), 0.0, 1e-6);
}

TEST(PointOnBody, HasTheBorderOfItsPatch) {
  RendererInputs inputs = inputs_on_body(flat_plate());
  inputs.patch = {.extent_m = {0.02, 0.02}, .edge = PatchEdge::wall};
  const auto renderer = renderer_on_body("sinusoid", inputs);
  const ProbeState inside = probe_at({0.009, 0.0, -0.001});
  EXPECT_NEAR(answer_after(*renderer, inside, probe_at({0.011, 0.0, -0.001})).wrench.force_N.x,
              -1.0, 1e-9);
  inputs.patch.edge = PatchEdge::fade;
  const auto faded = renderer_on_body("sinusoid", inputs);
  EXPECT_EQ(answer(*faded, probe_at({0.011, 0.0, -0.001})).wrench.force_N, glm::dvec3(0.0));
}

TEST(PointOnBody, LiesWhereItsPatchLies) {
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.patch.centre_m = {0.01, -0.02, 0.03};
  inputs.parameters = {{"amplitude_m", 0.0}};
  const auto renderer = renderer_on_body("sinusoid", inputs);
  const RenderedTick tick = answer(*renderer, probe_at({0.01, -0.02, 0.029}));
  EXPECT_NEAR(tick.wrench.force_N.z, 1.0, 1e-3);
}

TEST(PointOnBody, RefusesATextureThatRisesBeyondItsReach) {
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.height_field = level(0.02F);
  EXPECT_THAT(refusal_of([&] { renderer_on_body("height_map", inputs); }),
              testing::HasSubstr("rises more than"));
}

/// The drag of a hand that is moved over a seam between two charts while it sticks, and then is held.
double drag_after_seam_N(ForceRenderer& renderer, int from, int to, double radius_m) {
  constexpr double kFrom_rad = std::numbers::pi / 4 - 0.15;
  constexpr double kTo_rad = std::numbers::pi / 4 + 0.15;
  constexpr int kMoving = 60;  // 0.1 mm per tick
  constexpr int kHeld = 60;
  glm::dvec3 force_N(0.0);
  for (int i = 0; i <= kMoving + kHeld; ++i) {
    const double part = std::min(1.0, static_cast<double>(i) / kMoving);
    const ProbeState probe = between_axes(from, to, std::lerp(kFrom_rad, kTo_rad, part), radius_m);
    if (i == 0) renderer.reset(probe);
    force_N = renderer.tick(probe, kTick_s).wrench.force_N;
  }
  glm::dvec3 along(0.0);
  along[from] = -std::sin(kTo_rad);
  along[to] = std::cos(kTo_rad);
  return -glm::dot(force_N, along);
}

TEST(PointOnBody, StickingFrictionContinuesOverEverySeamInBothDirections) {
  constexpr double kDepth_m = 0.003;
  for (const char* const law : {"proxy", "elastoplastic", "dahl"}) {
    RendererInputs inputs = inputs_on_body(sphere());
    inputs.material.friction = 0.8;
    inputs.parameters = {{"amplitude_m", 0.0}, {"friction_law", std::string(law)}};
    const auto renderer = renderer_on_body("sinusoid", inputs);
    const double first_N = drag_after_seam_N(*renderer, 2, 0, kGlobeRadius_m - kDepth_m);
    if (std::string_view(law) == "proxy") {
      // The stiffness times the path in the coordinates of the chart that was the last one to be entered or, before, the
      // only one: to 0.04 mm, a part of the motion of a tick.
      constexpr double kSeamAdhesion_N_per_m = 120.0;
      const double half = std::numbers::pi / 4;
      double entered = half - 0.15;
      while (std::cos(entered + 0.005) - std::sin(entered + 0.005) >= 0.15) entered += 0.005;
      const double path_m = kGlobeRadius_m * (std::sin(entered) - std::sin(half - 0.15) +
                                              std::cos(entered) - std::cos(half + 0.15));
      EXPECT_NEAR(first_N, kSeamAdhesion_N_per_m * path_m, 0.003);
    }
    for (const auto& [from, to] : {std::pair{0, 2}, {2, 1}, {1, 2}, {0, 1}, {1, 0}}) {
      EXPECT_NEAR(drag_after_seam_N(*renderer, from, to, kGlobeRadius_m - kDepth_m), first_N, 0.001)
          << law << " from " << from << " to " << to;
    }
    EXPECT_GT(first_N, 0.3) << law;
  }
}

/// Counts its contacts, and fails at a place.
class FailingRenderer final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    ++counts_[0].ticks;
    if (probe.position_m.z < -0.001) {
      ++counts_[1].ticks;
      failed_ = true;
    }
    return {};
  }
  std::span<const NamedCount> limits() const noexcept override { return counts_; }
  std::string_view error() const noexcept override { return failed_ ? "too deep" : ""; }

 private:
  std::array<NamedCount, 2> counts_{NamedCount{.name = "called"}, NamedCount{.name = "deep"}};
  bool failed_ = false;
};

TEST(PointOnBody, HasTheErrorAndTheLimitsOfItsModel) {
  ForceModel model = point_models().front();
  model.make = [](const RendererInputs&) { return std::make_unique<FailingRenderer>(); };
  const auto renderer = make_renderer(model, inputs_on_body(sphere()));
  ASSERT_EQ(renderer->limits().size(), 2U);
  EXPECT_EQ(renderer->limits()[0].name, "called");
  EXPECT_EQ(renderer->limits()[0].ticks, 0U);
  EXPECT_EQ(renderer->error(), "");
  // One chart on the upper side, one at the equator.
  renderer->tick(between_axes(2, 0, 0.1, kGlobeRadius_m - 0.0005), kTick_s);
  renderer->tick(between_axes(2, 0, 1.5, kGlobeRadius_m - 0.0005), kTick_s);
  EXPECT_EQ(renderer->limits()[0].ticks, 2U);
  EXPECT_EQ(renderer->limits()[1].ticks, 0U);
  EXPECT_EQ(renderer->error(), "");
  renderer->tick(between_axes(2, 0, 0.1, kGlobeRadius_m - 0.002), kTick_s);
  EXPECT_EQ(renderer->limits()[0].ticks, 3U);
  EXPECT_EQ(renderer->limits()[1].ticks, 1U);
  EXPECT_EQ(renderer->error(), "too deep");
}

TEST(PointOnBody, RefusesASingleHighSampleAnywhereOfItsHeightField) {
  constexpr std::size_t kSide = 300;
  for (const std::size_t at : {std::size_t{0}, std::size_t{10'150}, kSide * kSide - 1}) {
    std::vector<float> heights_m(kSide * kSide, 0.0F);
    heights_m[at] = 0.012F;
    RendererInputs inputs = inputs_on_body(sphere());
    inputs.patch.motion_scale = 1.5;
    inputs.patch.texture_origin_m = {0.003, -0.002};
    inputs.height_field = std::make_shared<const HeightField>(
        HeightField::Grid{kSide, kSide, 0.001}, std::move(heights_m));
    EXPECT_THAT(refusal_of([&] { renderer_on_body("height_map", inputs); }),
                testing::HasSubstr("rises more than"))
        << at;
  }
}

TEST(PointOnBody, RefusesAModelWithoutAFiniteForce) {
  class NotANumber final : public ForceRenderer {
   public:
    void reset(const ProbeState&) noexcept override {}
    RenderedTick tick(const ProbeState&, double) noexcept override {
      return {.penetration_m = std::numeric_limits<double>::quiet_NaN()};
    }
    std::string_view error() const noexcept override { return "no memory"; }
  };
  ForceModel model = point_models().front();
  model.make = [](const RendererInputs&) { return std::make_unique<NotANumber>(); };
  EXPECT_THAT(refusal_of([&] { make_renderer(model, inputs_on_body(sphere())); }),
              testing::HasSubstr("no finite force above the body (no memory)"));
}

TEST(PointOnBody, IsNotForAModelOfTwoBodies) {
  const auto ball = std::make_shared<const TexturedMesh>(body_mesh(SphereShape{0.004}, nullptr));
  RendererInputs inputs = inputs_on_body(sphere());
  inputs.tool = inputs.surface = ball;
  EXPECT_THAT(refusal_of([&] { renderer_on_body("pd_gradient", inputs); }),
              testing::HasSubstr("give it the body as its surface"));
}

TEST(PointOnBody, DoesNotTouchTheHeap) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  for (const ForceModel& model : point_models()) {
    const auto renderer = make_renderer(model, inputs_on_body(sphere()));
    const AllocationGuard guard;
    renderer->reset(on_circle(0.0, kGlobeRadius_m, 0.1));
    for (int i = 0; i < 300; ++i) {
      renderer->tick(on_circle(0.005 * i, kGlobeRadius_m + 0.00001 * (i - 150), 0.1), kTick_s);
    }
    EXPECT_EQ(guard.count(), 0) << model.declaration.id;
  }
}

}  // namespace
}  // namespace asperity
