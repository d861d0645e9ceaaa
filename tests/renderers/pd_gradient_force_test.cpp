// The force of a contact's penetration depth against what is known in closed form.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/pd_gradient/sampling/penetration_sampler.h"
#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {
namespace {

// A bowl z = z₀ + ½·a·|p − q|² over a tilted hump z = s·p − ½·b·|p|². They are deepest in each other
// where the slopes agree, at p = (s + a·q)/(a + b).
class BowlOnHump : public testing::Test {
 protected:
  static constexpr double kBowl_per_m = 500.0;
  static constexpr double kHump_per_m = 100.0;
  const glm::dvec2 tilt_{0.2, -0.1};
  const glm::dvec2 bowl_at_m_{0.4e-3, 0.3e-3};
  const double bowl_height_m_ = -0.1e-3;
  const TexturedMesh bowl_ = formed_plate(
      {.size_m = {0.002, 0.002}, .cells = {80, 80}},
      [](double x_m, double y_m) { return -0.5 * kBowl_per_m * (x_m * x_m + y_m * y_m); });
  const TexturedMesh hump_ =
      formed_plate({.size_m = {0.004, 0.004}, .cells = {160, 160}}, [this](double x_m, double y_m) {
        return tilt_.x * x_m + tilt_.y * y_m - 0.5 * kHump_per_m * (x_m * x_m + y_m * y_m);
      });
  const std::vector<std::uint32_t> bowl_triangles_ = all_triangles(bowl_);
  const std::vector<std::uint32_t> hump_triangles_ = all_triangles(hump_);
  const ContactPatch a_{.mesh = bowl_,
                        .triangles = bowl_triangles_,
                        .pose = upside_down({bowl_at_m_, bowl_height_m_})};
  const ContactPatch b_{.mesh = hump_, .triangles = hump_triangles_};
  const SamplingGrid grid_{.width_m = 161 * 0.025e-3, .samples = 161};
  const HardMaximum law_{.step_m = 0.1e-3};
};

TEST_F(BowlOnHump, PushesLikeOneContactAtTheDeepestPoint) {
  const glm::dvec2 p_m = (tilt_ + kBowl_per_m * bowl_at_m_) / (kBowl_per_m + kHump_per_m);
  const glm::dvec2 slope = tilt_ - kHump_per_m * p_m;
  const glm::dvec2 off_m = p_m - bowl_at_m_;
  const double a_m = bowl_height_m_ + 0.5 * kBowl_per_m * glm::dot(off_m, off_m);
  const double b_m = glm::dot(tilt_, p_m) - 0.5 * kHump_per_m * glm::dot(p_m, p_m);
  const double depth_m = b_m - a_m;
  const glm::dvec3 force_N = kStiffness_N_per_m * depth_m * glm::dvec3{-slope, 1.0};
  const glm::dvec3 torque_N_m = glm::cross(glm::dvec3{p_m, a_m}, force_N);

  const auto found = reference_penetration(a_, b_, {}, grid_, law_);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->at_border);
  EXPECT_NEAR(found->depth_m, depth_m, 1e-3 * depth_m);
  EXPECT_NEAR(found->deepest_m.x, p_m.x, grid_.spacing_m());
  EXPECT_NEAR(found->deepest_m.y, p_m.y, grid_.spacing_m());
  const Wrench wrench = contact_wrench(*found, {}, kStiffness_N_per_m);
  EXPECT_LT(relative(wrench.force_N - force_N, force_N), 2e-3);
  EXPECT_LT(relative(wrench.torque_N_m - torque_N_m, torque_N_m), 5e-3);
}

TEST_F(BowlOnHump, FeelsTheOppositeOnceTheSurfacesChangePlaces) {
  const auto found = reference_penetration(a_, b_, {}, grid_, law_);
  ContactFrame mirrored;
  mirrored.v = -mirrored.v;
  mirrored.n = -mirrored.n;
  const auto swapped = reference_penetration(b_, a_, mirrored, grid_, law_);
  ASSERT_TRUE(found && swapped);
  const Wrench on_a = contact_wrench(*found, {}, kStiffness_N_per_m);
  const Wrench on_b = contact_wrench(*swapped, mirrored, kStiffness_N_per_m);
  EXPECT_LT(relative(on_a.force_N + on_b.force_N, on_a.force_N), 1e-9);
  // The torques, about the same point, but for the lever between the two deepest points.
  const glm::dvec3 lever_N_m = -found->depth_m * glm::cross(glm::dvec3{0, 0, 1}, on_a.force_N);
  EXPECT_GT(glm::length(lever_N_m), 1e-6);
  EXPECT_LT(relative(on_a.torque_N_m + on_b.torque_N_m - lever_N_m, on_a.torque_N_m), 5e-3);
}

TEST_F(BowlOnHump, DoesNotPushApart) {
  ContactPatch above = a_;
  above.pose.position_m.z = 0.001;
  const auto found = reference_penetration(above, b_, {}, grid_, law_);
  ASSERT_TRUE(found);
  EXPECT_LT(found->depth_m, 0.0);
  const Wrench wrench = contact_wrench(*found, {}, kStiffness_N_per_m);
  EXPECT_EQ(wrench.force_N, glm::dvec3(0.0));
  EXPECT_EQ(wrench.torque_N_m, glm::dvec3(0.0));
}

TEST_F(BowlOnHump, FindsNothingWhereNothingOverlaps) {
  ContactPatch aside = a_;
  aside.pose.position_m.x = 0.1;
  EXPECT_FALSE(reference_penetration(aside, b_, {}, grid_, law_));
}

TEST_F(BowlOnHump, RefusesAStepOrASmoothnessThatIsNotPositive) {
  EXPECT_THROW(reference_penetration(a_, b_, {}, grid_, HardMaximum{.step_m = 0.0}),
               std::invalid_argument);
  EXPECT_THROW(reference_penetration(a_, b_, {}, grid_, SmoothMaximum{.tau_m = -1e-6}),
               std::invalid_argument);
}

// A ball of radius R on points that stand out of a floor by h, spaced L apart. The ball follows
// arcs, −(R − √(R² − ξ²)) at ξ from the nearest point, and drops to the floor where L exceeds
// 2√(2Rh − h²). Points and samples lie on one raster, so that no point is missed.
class BallOnPoints : public testing::Test {
 protected:
  static constexpr double kRadius_m = 1e-3;
  static constexpr double kRaster_m = 12.5e-6;
  const TexturedMesh ball_ =
      formed_plate({.size_m = {1.6e-3, 0.1e-3}, .cells = {320, 2}}, [](double x_m, double y_m) {
        return std::sqrt(kRadius_m * kRadius_m - x_m * x_m - y_m * y_m) - kRadius_m;
      });
  const std::vector<std::uint32_t> triangles_ = all_triangles(ball_);
  const SamplingGrid grid_{.width_m = 161 * kRaster_m, .samples = 161};

  // Points at (i + offset)·L of that height, on a floor at 0; the ball's lowest point at (x, 0, 0).
  Penetration at(double x_m, double spacing_m, double offset, double height_m) const {
    const TexturedMesh points = formed_plate(
        {.size_m = {192 * kRaster_m, 0.2e-3}, .cells = {192, 2}}, [&](double px_m, double py_m) {
          const double cell = px_m / spacing_m - offset;
          const bool is_point = std::abs(cell - std::round(cell)) < 1e-6 && std::abs(py_m) < 1e-9;
          return is_point ? height_m : 0.0;
        });
    const std::vector<std::uint32_t> triangles = all_triangles(points);
    return reference_penetration(
               {.mesh = ball_, .triangles = triangles_, .pose = upside_down({x_m, 0, 0})},
               {.mesh = points, .triangles = triangles}, {}, grid_, HardMaximum{.step_m = 10e-6})
        .value();
  }
};

TEST_F(BallOnPoints, FollowsTheArcsOfTheOffsetSurface) {
  constexpr double kSpacing_m = 0.8e-3;
  constexpr double kHeight_m = 0.4e-3;
  for (const double x_m : {0.05e-3, 0.1e-3, 0.2e-3, 0.3e-3, 0.38e-3}) {
    const double along_m = std::sqrt(kRadius_m * kRadius_m - x_m * x_m);
    const Penetration found = at(x_m, kSpacing_m, 0.0, kHeight_m);
    EXPECT_NEAR(found.depth_m, kHeight_m - (kRadius_m - along_m), 0.01 * (kRadius_m - along_m));
    EXPECT_NEAR(found.slope.x, -x_m / along_m, 0.01 * x_m / along_m) << x_m;
  }
  // The steepest slope is that at the cusp, (L/2)/√(R² − L²/4); a step next to it, from either side.
  const double half_m = kSpacing_m / 2.0;
  const double steepest = half_m / std::sqrt(kRadius_m * kRadius_m - half_m * half_m);
  constexpr double kNextTo_m = 10.1e-6;
  EXPECT_NEAR(at(half_m - kNextTo_m, kSpacing_m, 0.0, kHeight_m).slope.x, -steepest,
              0.03 * steepest);
  EXPECT_NEAR(at(half_m + kNextTo_m, kSpacing_m, 0.0, kHeight_m).slope.x, steepest,
              0.03 * steepest);
}

TEST_F(BallOnPoints, DropsToTheFloorWhereTheDropSpacingSays) {
  constexpr double kSpacing_m = 50 * kRaster_m;  // points at ± 25 cells of the raster
  const double half_m = kSpacing_m / 2.0;
  const double cusp_m = kRadius_m - std::sqrt(kRadius_m * kRadius_m - half_m * half_m);
  // L = 2√(2Rh − h²) at h = cusp depth.
  ASSERT_NEAR(2.0 * std::sqrt(2.0 * kRadius_m * cusp_m - cusp_m * cusp_m), kSpacing_m, 1e-12);
  EXPECT_NEAR(at(0.0, kSpacing_m, 0.5, 0.99 * cusp_m).depth_m, 0.0, 1e-12);
  EXPECT_NEAR(at(0.0, kSpacing_m, 0.5, 1.01 * cusp_m).depth_m, 0.01 * cusp_m, 1e-3 * cusp_m);
}

TEST(PenetrationForce, TurnsWithTheBodies) {
  ContactsByChance chance(1);
  ChanceContact contact = chance.draw(ContactKind::convex_on_flat);
  contact.pose_a.position_m.z = -0.1e-3;
  const SamplingGrid grid{.width_m = ContactsByChance::kWindow_m, .samples = 24};
  const Pose motion{.rotation = turn_about({0.3, -0.8, 0.5}, 2.1), .position_m = {0.1, -0.2, 0.05}};
  const auto moved = [&](const Pose& pose) {
    return Pose{.rotation = motion.rotation * pose.rotation,
                .position_m = motion.rotation * pose.position_m + motion.position_m};
  };
  const ContactFrame turned{.origin_m = motion.position_m,
                            .u = motion.rotation[0],
                            .v = motion.rotation[1],
                            .n = motion.rotation[2]};
  for (const MaximumLaw& law :
       {MaximumLaw(HardMaximum{.step_m = 0.125e-3}), MaximumLaw(SmoothMaximum{.tau_m = 20e-6})}) {
    const auto before = reference_penetration(contact.a(), contact.b(), {}, grid, law);
    ChanceContact there = contact;
    there.pose_a = moved(contact.pose_a);
    there.pose_b = moved(contact.pose_b);
    const auto after = reference_penetration(there.a(), there.b(), turned, grid, law);
    ASSERT_TRUE(before && after);
    const Wrench was = contact_wrench(*before, {}, kStiffness_N_per_m);
    const Wrench is = contact_wrench(*after, turned, kStiffness_N_per_m);
    ASSERT_GT(glm::length(was.force_N), 0.01);
    EXPECT_LT(relative(is.force_N - motion.rotation * was.force_N, was.force_N), 1e-9);
    EXPECT_LT(relative(is.torque_N_m - motion.rotation * was.torque_N_m, was.torque_N_m), 1e-9);
  }
}

TEST(PenetrationForce, OfTheSmoothMaximumIsTheDerivativeOfItsDepth) {
  ContactsByChance chance(2);
  const SamplingGrid grid{.width_m = 0.6 * ContactsByChance::kWindow_m, .samples = 24};
  const SmoothMaximum law{.tau_m = 20e-6};
  const ChanceContact contact = chance.draw(ContactKind::convex_on_convex);
  const auto depth_m = [&](const Pose& pose) {
    ChanceContact moved = contact;
    moved.pose_a = pose;
    return reference_penetration(moved.a(), moved.b(), {}, grid, law)->depth_m;
  };
  const auto found = reference_penetration(contact.a(), contact.b(), {}, grid, law);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->covered, 24 * 24);
  constexpr double kStep = 1e-8;  // metres and radians
  const auto along = [&](const glm::dvec3& axis) {
    Pose forth = contact.pose_a;
    Pose back = contact.pose_a;
    forth.position_m += kStep * axis;
    back.position_m -= kStep * axis;
    return (depth_m(forth) - depth_m(back)) / (2.0 * kStep);
  };
  const auto about = [&](const glm::dvec3& axis) {
    const auto turned = [&](double angle_rad) {
      const glm::dmat3 turn = turn_about(axis, angle_rad);
      return Pose{.rotation = turn * contact.pose_a.rotation,
                  .position_m = turn * contact.pose_a.position_m};
    };
    return (depth_m(turned(kStep)) - depth_m(turned(-kStep))) / (2.0 * kStep);
  };
  EXPECT_NEAR(found->slope.x, along({1, 0, 0}), 1e-6);
  EXPECT_NEAR(found->slope.y, along({0, 1, 0}), 1e-6);
  EXPECT_NEAR(along({0, 0, 1}), -1.0, 1e-6);
  EXPECT_NEAR(found->lever_m.x, about({1, 0, 0}), 1e-9);
  EXPECT_NEAR(found->lever_m.y, about({0, 1, 0}), 1e-9);
  EXPECT_NEAR(found->lever_m.z, about({0, 0, 1}), 1e-9);
}

// Of two crests a apart the one at the origin is higher by ε. A tilt by θ = 2·step/width, which moves the middle of the window's
// border by the step, makes the other one the deepest if a·θ > ε: (δ(θ) − δ(−θ))/2θ = a/2 − ε/2θ. The torque on many crests thus
// depends on the width of the window; on one crest the lever arm is its place in every window.
TEST(PenetrationForce, HasALeverThatDependsOnTheWindowOnTwoCrestsAndNotOnOne) {
  constexpr double kApart_m = 2e-3;
  constexpr double kHigher_m = 10e-6;
  constexpr double kStep_m = 0.1e-3;
  constexpr double kSpacing_m = 0.05e-3;
  constexpr double kRoofs =
      0.2;  // their slope: steeper than the tilts, which leave the ridges the highest
  const auto roof = [](double x_m) { return -kRoofs * std::abs(x_m); };
  const FormedPlate roofed{.size_m = {0.02, 0.02}, .cells = {400, 1}};  // a vertex on each ridge
  const TexturedMesh two = formed_plate(roofed, [&](double x_m, double) {
    return std::max(roof(x_m), roof(x_m - kApart_m) - kHigher_m);
  });
  const TexturedMesh one =
      formed_plate(roofed, [&](double x_m, double) { return roof(x_m - kApart_m); });
  const TexturedMesh flat =
      formed_plate({.size_m = {0.03, 0.03}}, [](double, double) { return 0.0; });
  const std::vector<std::uint32_t> of_roofs = all_triangles(two);
  const std::vector<std::uint32_t> of_flat = all_triangles(flat);
  for (const int samples : {191, 255, 321}) {  // odd: a sample on each ridge
    const SamplingGrid grid{.width_m = samples * kSpacing_m, .samples = samples};
    const auto lever_m = [&](const TexturedMesh& surface) {
      const auto found = reference_penetration(
          {.mesh = flat, .triangles = of_flat, .pose = upside_down({0.0, 0.0, -0.1e-3})},
          {.mesh = surface, .triangles = of_roofs}, {}, grid, HardMaximum{.step_m = kStep_m});
      EXPECT_TRUE(found);
      return found.value_or(Penetration{}).lever_m.y;
    };
    const double tilt_rad = 2.0 * kStep_m / grid.width_m;
    EXPECT_NEAR(lever_m(two), 0.5 * kApart_m - 0.5 * kHigher_m / tilt_rad, 1e-6) << samples;
    EXPECT_NEAR(lever_m(one), kApart_m, 2e-6) << samples;
  }
}

// A mean with weights that favour the largest of N lies between the largest and an N-th of it.
TEST(PenetrationForce, OfTheSmoothMaximumTendsToTheHardOne) {
  ContactsByChance chance(3);
  const ChanceContact contact = chance.draw(ContactKind::flat);
  const SamplingGrid grid{.width_m = ContactsByChance::kWindow_m, .samples = 24};
  const double hard_m =
      reference_penetration(contact.a(), contact.b(), {}, grid, HardMaximum{.step_m = 1e-4})
          ->depth_m;
  for (const double tau_m : {10e-6, 1e-6, 0.1e-6}) {
    const double smooth_m =
        reference_penetration(contact.a(), contact.b(), {}, grid, SmoothMaximum{.tau_m = tau_m})
            ->depth_m;
    EXPECT_LE(smooth_m, hard_m);
    EXPECT_GE(smooth_m, hard_m - tau_m * std::log(24.0 * 24.0));
  }
}

// Of a plate the depth d itself. Of a bowl, with s = r²/2R and dA = 2πR ds, d − ∫ s·exp(−s/τ) ds / τ = d − τ.
TEST(PenetrationForce, OfTheSmoothMaximumIsThatOfAPlateAndOfABallWhateverTheirSize) {
  const SmoothMaximum law{.tau_m = 20e-6};
  const TexturedMesh ground =
      formed_plate({.size_m = {0.02, 0.02}}, [](double, double) { return 0.0; });
  const std::vector<std::uint32_t> all_of_ground = all_triangles(ground);
  const auto depth_m = [&](const TexturedMesh& tool, double window_m) {
    const std::vector<std::uint32_t> all_of_tool = all_triangles(tool);
    return reference_penetration(
               {.mesh = tool, .triangles = all_of_tool, .pose = upside_down({0.0, 0.0, -0.1e-3})},
               {.mesh = ground, .triangles = all_of_ground}, {},
               {.width_m = window_m, .samples = 128}, law)
        ->depth_m;
  };
  for (const double size_m : {1e-3, 9e-3}) {
    const TexturedMesh plate =
        formed_plate({.size_m = glm::dvec2(size_m)}, [](double, double) { return 0.0; });
    EXPECT_NEAR(depth_m(plate, 1.3 * size_m), 0.1e-3, 1e-12);
    EXPECT_NEAR(depth_m(plate, 2.0 * size_m), 0.1e-3, 1e-12);
  }
  for (const double radius_m : {0.5e-3, 8e-3}) {
    const double half_m = std::sqrt(2.0 * radius_m * 12.0 * law.tau_m);  // 12·τ lower there
    const TexturedMesh bowl = formed_plate(
        {.size_m = glm::dvec2(2.0 * half_m), .cells = {64, 64}},
        [&](double x_m, double y_m) { return -0.5 * (x_m * x_m + y_m * y_m) / radius_m; });
    for (const double window_m : {2.0 * half_m, 3.0 * half_m}) {
      EXPECT_NEAR(depth_m(bowl, window_m), 0.1e-3 - law.tau_m, 0.5e-6);
    }
  }
}

// Two plates with crossed gratings of wavelength λ.
class Gratings : public testing::Test {
 protected:
  static constexpr double kWavelength_m = 1e-3;
  static constexpr double kHeight_m = 0.05e-3;
  static double crossed_m(double x_m, double y_m) {
    const double k_per_m = 2.0 * std::numbers::pi / kWavelength_m;
    return kHeight_m * (std::cos(k_per_m * x_m) + std::cos(k_per_m * (0.6 * x_m + 0.8 * y_m)));
  }
  // Smooth wherever it is sampled, so that the sum over a path is as good as its integral.
  static TexturedMesh saddle() {
    TexturedMesh mesh = formed_plate({.size_m = {8e-3, 8e-3}}, [](double, double) { return 0.0; });
    mesh.atlas = {.rows = 2, .columns = 2, .step_m = 1e-6, .values = {0, 700, 200, -600}};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const glm::dvec3 p_m = mesh.vertices_m[mesh.triangles[i][corner]];
        mesh.places[i][corner] = glm::dvec2{p_m} / 8e-3 + 0.5;
      }
    }
    return mesh;
  }
  const TexturedMesh plate_ = textured_plate(6e-3, kWavelength_m / 8.0, crossed_m);
  const std::vector<std::uint32_t> triangles_ = all_triangles(plate_);
  const SamplingGrid grid_{.width_m = 3.0 * kWavelength_m, .samples = 32};
};

// A bowl goes around a loop that is no mirror image of itself, over a texture of 32 texels a
// wavelength; n and the window stay.
TEST_F(Gratings, DoNoNetWorkAroundAClosedPathInTheLimitOfSmallSteps) {
  const TexturedMesh fine = textured_plate(2e-3, kWavelength_m / 32.0, crossed_m);
  const TexturedMesh bowl = formed_plate(
      {.size_m = {0.16e-3, 0.16e-3}, .cells = {16, 16}},
      [](double x_m, double y_m) { return -(x_m * x_m + y_m * y_m) / (2.0 * 0.2e-3); });
  const std::vector<std::uint32_t> bowl_triangles = all_triangles(bowl);
  const SamplingGrid grid{.width_m = 1.2e-3, .samples = 64};
  const auto net_over_gross = [&](double step_m) {
    constexpr int kPoints = 160;
    const auto place_m = [](int point) {
      const double t = 2.0 * std::numbers::pi * point / kPoints;
      return glm::dvec3{0.35e-3 * std::cos(t), 0.30e-3 * std::sin(t + 0.4),
                        -0.15e-3 + 0.05e-3 * std::sin(2.0 * t + 0.6)};
    };
    double net_J = 0.0;
    double gross_J = 0.0;
    for (int point = 0; point < kPoints; ++point) {
      const glm::dvec3 from_m = place_m(point);
      const glm::dvec3 to_m = place_m(point + 1);
      const auto found = reference_penetration(
          {.mesh = bowl, .triangles = bowl_triangles, .pose = upside_down(0.5 * (from_m + to_m))},
          {.mesh = fine, .triangles = triangles_}, {}, grid, HardMaximum{.step_m = step_m});
      const double work_J =
          glm::dot(contact_wrench(*found, {}, kStiffness_N_per_m).force_N, to_m - from_m);
      net_J += work_J;
      gross_J += std::abs(work_J);
    }
    return std::abs(net_J) / gross_J;
  };
  EXPECT_LT(net_over_gross(kWavelength_m / 30.0), 1e-3);
  EXPECT_LT(net_over_gross(kWavelength_m / 15.0), 4e-3);
  EXPECT_LT(net_over_gross(kWavelength_m / 8.0), 15e-3);  // the step that is shipped: 0.9 %
}

// A saddle turns and tilts as it goes. Power is F·v + T·ω with the velocity at the origin.
TEST_F(Gratings, DoNoNetWorkWithTheSmoothMaximum) {
  const TexturedMesh saddle = Gratings::saddle();
  const std::vector<std::uint32_t> triangles = all_triangles(saddle);
  constexpr int kPoints = 120;
  double net_J = 0.0;
  double gross_J = 0.0;
  for (int point = 0; point < kPoints; ++point) {
    const double t = 2.0 * std::numbers::pi * point / kPoints;
    const double turn_rad = 0.3 * std::sin(t);
    const double tilt_rad = 0.05 * std::cos(t + 0.5);
    const glm::dmat3 turn = turn_about({0, 0, 1}, turn_rad);
    Pose pose = upside_down({0.3e-3 * std::cos(t), 0.2e-3 * std::sin(t + 0.4),
                             -0.3e-3 + 0.05e-3 * std::sin(2.0 * t + 0.6)});
    pose.rotation = turn * turn_about({1, 0, 0}, tilt_rad) * pose.rotation;
    const glm::dvec3 velocity_m{-0.3e-3 * std::sin(t), 0.2e-3 * std::cos(t + 0.4),
                                0.1e-3 * std::cos(2.0 * t + 0.6)};
    const glm::dvec3 spin_rad = 0.3 * std::cos(t) * glm::dvec3{0, 0, 1} -
                                0.05 * std::sin(t + 0.5) * (turn * glm::dvec3{1, 0, 0});
    const auto found = reference_penetration({.mesh = saddle, .triangles = triangles, .pose = pose},
                                             {.mesh = plate_, .triangles = triangles_}, {}, grid_,
                                             SmoothMaximum{.tau_m = 20e-6});
    const Wrench wrench = contact_wrench(*found, {}, kStiffness_N_per_m);
    ASSERT_GT(found->depth_m, 0.0);
    const double power =
        glm::dot(wrench.force_N, velocity_m - glm::cross(spin_rad, pose.position_m)) +
        glm::dot(wrench.torque_N_m, spin_rad);
    net_J += power * 2.0 * std::numbers::pi / kPoints;
    gross_J += std::abs(power) * 2.0 * std::numbers::pi / kPoints;
  }
  EXPECT_GT(gross_J, 1e-6);
  EXPECT_LT(std::abs(net_J) / gross_J, 1e-6);
}

// The fast evaluation, in single precision; the saddle does not turn or tilt.
TEST_F(Gratings, DoNoNetWorkWithTheSmoothMaximumInSinglePrecision) {
  const TexturedMesh saddle = Gratings::saddle();
  const std::vector<std::uint32_t> triangles = all_triangles(saddle);
  const PackedSurface a(saddle);
  const PackedSurface b(plate_);
  PenetrationSampler sampler({.grid = {.width_m = 3.0 * kWavelength_m, .samples = 64},
                              .law = SmoothMaximum{.tau_m = 20e-6},
                              .most_triangles = triangles.size(),
                              .instructions = instruction_sets_here().back()});
  constexpr int kPoints = 240;
  double net_J = 0.0;
  double gross_J = 0.0;
  for (int point = 0; point < kPoints; ++point) {
    const double t = 2.0 * std::numbers::pi * point / kPoints;
    const Pose pose = upside_down({0.3e-3 * std::cos(t), 0.2e-3 * std::sin(t + 0.4),
                                   -0.3e-3 + 0.05e-3 * std::sin(2.0 * t + 0.6)});
    const glm::dvec3 velocity_m{-0.3e-3 * std::sin(t), 0.2e-3 * std::cos(t + 0.4),
                                0.1e-3 * std::cos(2.0 * t + 0.6)};
    const auto found = sampler.evaluate({.surface = a, .triangles = triangles, .pose = pose},
                                        {.surface = b, .triangles = triangles_}, {});
    ASSERT_TRUE(found);
    const double power =
        glm::dot(contact_wrench(*found, {}, kStiffness_N_per_m).force_N, velocity_m);
    net_J += power;
    gross_J += std::abs(power);
  }
  EXPECT_LT(std::abs(net_J) / gross_J, 1e-6);
}

// A small ball on a sinusoidal grating, h(x) = A·cos(2πx/λ), finely formed in its mesh.
class BallOnGrating : public testing::Test {
 protected:
  static constexpr double kWavelength_m = 1e-3;
  static constexpr double kHeight_m = 0.1e-3;
  static constexpr double kRadius_m = 0.1e-3;
  static double height_m(double x_m) {
    return kHeight_m * std::cos(2.0 * std::numbers::pi * x_m / kWavelength_m);
  }
  // Where the ball's lowest point is when it rests on the grating at x: its offset surface.
  static double offset_m(double x_m) {
    constexpr int kAcross = 4000;
    double highest_m = -1.0;
    for (int i = -kAcross; i <= kAcross; ++i) {
      const double xi_m = 0.95 * kRadius_m * i / kAcross;
      highest_m = std::max(highest_m,
                           height_m(x_m + xi_m) + std::sqrt(kRadius_m * kRadius_m - xi_m * xi_m));
    }
    return highest_m - kRadius_m;
  }
  static double offset_slope(double x_m) {
    constexpr double kStep_m = 5e-6;
    return (offset_m(x_m + kStep_m) - offset_m(x_m - kStep_m)) / (2.0 * kStep_m);
  }
  const TexturedMesh grating_ = formed_plate({.size_m = {2.8e-3, 2.8e-3}, .cells = {560, 1}},
                                             [](double x_m, double) { return height_m(x_m); });
  const TexturedMesh ball_ =
      formed_plate({.size_m = {0.13e-3, 0.13e-3}, .cells = {26, 26}}, [](double x_m, double y_m) {
        return std::sqrt(kRadius_m * kRadius_m - x_m * x_m - y_m * y_m) - kRadius_m;
      });
  const std::vector<std::uint32_t> grating_triangles_ = all_triangles(grating_);
  const std::vector<std::uint32_t> ball_triangles_ = all_triangles(ball_);
};

// With the ball at (ρ cos φ, ρ sin φ), turning A about n moves it across the grating by −ρ sin φ.
TEST_F(BallOnGrating, TurnsBackByTheGratingsSlopeTimesTheLever) {
  const SamplingGrid grid{.width_m = 2.61e-3, .samples = 261};
  constexpr double kLever_m = 1e-3;
  for (const double phi_rad : {0.4, 1.1, 2.0, -0.8}) {
    const glm::dvec2 at_m = kLever_m * glm::dvec2{std::cos(phi_rad), std::sin(phi_rad)};
    const auto found = reference_penetration(
        {.mesh = ball_, .triangles = ball_triangles_, .pose = upside_down({at_m, -kHeight_m})},
        {.mesh = grating_, .triangles = grating_triangles_}, {}, grid,
        HardMaximum{.step_m = kWavelength_m / 40.0});
    const double expected_m = offset_slope(at_m.x) * -at_m.y;
    EXPECT_NEAR(found->lever_m.z, expected_m, 0.02 * 0.6e-3) << phi_rad;
  }
}

TEST_F(BallOnGrating, KeepsMostOfTheTangentialForceAtAStepOfAnEighth) {
  const SamplingGrid grid{.width_m = 0.41e-3, .samples = 41};
  double felt = 0.0;
  double true_slope = 0.0;
  for (int i = 0; i < 16; ++i) {
    const double x_m = kWavelength_m * i / 16.0;
    const auto found = reference_penetration(
        {.mesh = ball_, .triangles = ball_triangles_, .pose = upside_down({0, 0, -kHeight_m})},
        {.mesh = grating_, .triangles = grating_triangles_, .pose = {.position_m = {-x_m, 0, 0}}},
        {}, grid, HardMaximum{.step_m = kWavelength_m / 8.0});
    felt = std::max(felt, std::abs(found->slope.x));
    true_slope = std::max(true_slope, std::abs(offset_slope(x_m)));
  }
  EXPECT_GE(felt, 0.85 * true_slope);
  EXPECT_LE(felt, 1.01 * true_slope);
}

}  // namespace
}  // namespace asperity
