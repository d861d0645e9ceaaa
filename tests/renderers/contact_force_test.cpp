// The force of a ball on gratings and points, against what is known in closed form.

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "tests/renderers/contact_scenes.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

Pose moved(const Pose& motion, const Pose& pose) {
  return {.rotation = motion.rotation * pose.rotation,
          .position_m = motion.rotation * pose.position_m + motion.position_m};
}

// A ball of radius R with its lowest point at the origin of its frame, on h(x) = A·sin(2πx/λ).
class BallOnGratedPlate : public testing::Test {
 protected:
  static constexpr double kRadius_m = 1e-3;
  static constexpr double kWavelength_m = 2e-3;
  static constexpr double kHeight_m = 0.06e-3;
  static double height_m(double x_m) {
    return kHeight_m * std::sin(2.0 * std::numbers::pi * x_m / kWavelength_m);
  }
  // How far aside of its middle the ball is deepest, and how deep, with its lowest point at (x, z).
  struct Deepest {
    double aside_m = 0.0;
    double depth_m = -1.0;
  };
  static Deepest deepest(double x_m, double z_m) {
    Deepest found;
    for (int i = -20000; i <= 20000; ++i) {
      const double xi_m = 0.5 * kRadius_m * i / 20000.0;
      const double ball_m = z_m + kRadius_m - std::sqrt(kRadius_m * kRadius_m - xi_m * xi_m);
      const double depth_m = height_m(x_m + xi_m) - ball_m;
      if (depth_m > found.depth_m) found = {.aside_m = xi_m, .depth_m = depth_m};
    }
    return found;
  }

  const TexturedMesh ball_ = shifted(bare(ball(kRadius_m, 200, 32)), {0.0, 0.0, kRadius_m});
  const TexturedMesh plate_ = textured_shape(
      PlateShape{{0.008, 0.008, 0.004}},
      *grating({.amplitude_m = kHeight_m, .wavelength_m = kWavelength_m, .pitch_m = 0.05e-3}),
      {.rim_m = 0.001, .samples_per_wavelength = 4.0});
};

TEST_F(BallOnGratedPlate, PushesAtTheDeepestPointAlongTheTexturesNormal) {
  TexturedContacts contacts = between(ball_, plate_, hard(20e-6, 4));
  for (const double x_m : {0.21e-3, 0.6e-3, -0.35e-3}) {
    const glm::dvec3 place_m{x_m, 0.05e-3, -0.1e-3};
    const auto found = contacts.find(pose_at(place_m), {}, kTick_s);
    ASSERT_EQ(found.size(), 1U);
    const auto [aside_m, depth_m] = deepest(x_m, place_m.z);
    const double slope = 2.0 * std::numbers::pi * kHeight_m / kWavelength_m *
                         std::cos(2.0 * std::numbers::pi * (x_m + aside_m) / kWavelength_m);
    // k·δ·(−h_u, −h_v, 1), and r × F about the place of the ball's lowest point.
    const glm::dvec3 force_N = kStiffness_N_per_m * depth_m * glm::dvec3{-slope, 0.0, 1.0};
    const double below_m = kRadius_m - std::sqrt(kRadius_m * kRadius_m - aside_m * aside_m);
    const glm::dvec3 torque_N_m = glm::cross(glm::dvec3{aside_m, 0.0, below_m}, force_N);
    const Wrench wrench = wrench_about(place_m, found);
    EXPECT_LT(relative(wrench.force_N - force_N, force_N), 0.01) << x_m;
    // The lever, some 0.15 mm long, to half a cell of the grid.
    EXPECT_LT(glm::length(wrench.torque_N_m - torque_N_m), 10e-6 * glm::length(force_N)) << x_m;
  }
}

TEST_F(BallOnGratedPlate, TurnsBackByTheGratingsSlopeTimesTheLever) {
  // The ball is held 2 mm away: about the axis through the hold along n, T = (r × F)·n.
  TexturedContacts contacts = between(ball_, plate_, hard(25e-6, 4));
  for (const double phi_rad : {0.4, 1.3, 2.2, -0.9}) {
    const glm::dvec3 lever_m = 2e-3 * glm::dvec3{std::cos(phi_rad), std::sin(phi_rad), 0.0};
    const glm::dvec3 hold_m{-0.4e-3, 0.3e-3, -0.1e-3};
    const double x_m = hold_m.x + lever_m.x;
    const auto [aside_m, depth_m] = deepest(x_m, hold_m.z);
    const double slope = 2.0 * std::numbers::pi * kHeight_m / kWavelength_m *
                         std::cos(2.0 * std::numbers::pi * (x_m + aside_m) / kWavelength_m);
    const double turning_N_m = kStiffness_N_per_m * depth_m * slope * lever_m.y;
    const Wrench wrench =
        wrench_about(hold_m, contacts.find(pose_at(hold_m + lever_m), {}, kTick_s));
    const double most_N_m =
        kStiffness_N_per_m * depth_m * 2.0 * std::numbers::pi * kHeight_m / kWavelength_m * 2e-3;
    EXPECT_NEAR(wrench.torque_N_m.z, turning_N_m, 0.03 * most_N_m) << phi_rad;
  }
}

// sin(π/4)/(π/4) = 90 % of a sine, whose higher harmonics under the ball are weaker still.
TEST_F(BallOnGratedPlate, KeepsMostOfTheTangentialForceAtAStepOfAnEighth) {
  TexturedContacts contacts = between(ball_, plate_, hard(kWavelength_m / 8.0, 8));
  double felt = 0.0;
  double true_slope = 0.0;
  for (int i = 0; i < 16; ++i) {
    const double x_m = kWavelength_m * i / 16.0;
    const auto found = contacts.find(pose_at({x_m, 0.05e-3, -0.1e-3}), {}, kTick_s);
    ASSERT_EQ(found.size(), 1U);
    felt = std::max(felt, std::abs(found[0].penetration.slope.x));
    const double deepest_m = x_m + deepest(x_m, -0.1e-3).aside_m;
    true_slope = std::max(
        true_slope, 2.0 * std::numbers::pi * kHeight_m / kWavelength_m *
                        std::abs(std::cos(2.0 * std::numbers::pi * deepest_m / kWavelength_m)));
  }
  EXPECT_GE(felt, 0.85 * true_slope);
  EXPECT_LE(felt, 1.01 * true_slope);
}

TEST_F(BallOnGratedPlate, FeelsTheOppositeOnceTheBodiesChangePlaces) {
  TexturedContacts forward = between(ball_, plate_, hard(25e-6, 4));
  TexturedContacts backward = between(plate_, ball_, hard(25e-6, 4));
  const glm::dvec3 place_m{0.21e-3, 0.05e-3, -0.1e-3};
  const auto found = forward.find(pose_at(place_m), {}, kTick_s);
  const auto swapped = backward.find({}, pose_at(place_m), kTick_s);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(swapped.size(), 1U);
  const Wrench on_ball = wrench_about(place_m, found);
  const Wrench on_plate = wrench_about(place_m, swapped);
  EXPECT_LT(relative(on_ball.force_N + on_plate.force_N, on_ball.force_N), 1e-4);
  // But for the way between the deepest points of the two, δ·n.
  const glm::dvec3 lever_N_m =
      -found[0].penetration.depth_m * glm::cross(found[0].frame.n, on_ball.force_N);
  EXPECT_LT(glm::length(on_ball.torque_N_m + on_plate.torque_N_m - lever_N_m),
            2e-6 * glm::length(on_ball.force_N));
}

// The grid's axes begin along the plate's and turn with it: what is left is single precision.
TEST_F(BallOnGratedPlate, TurnsWithTheBodies) {
  const Pose ball = pose_at({0.21e-3, 0.05e-3, -0.1e-3});
  const auto turned_error = [&](const Pose& motion) {
    TexturedContacts contacts = between(ball_, plate_, hard(25e-6, 4));
    const Wrench was = wrench_about(ball.position_m, contacts.find(ball, {}, kTick_s));
    contacts.reset();
    const Pose there = moved(motion, ball);
    const Wrench is = wrench_about(there.position_m, contacts.find(there, motion, kTick_s));
    EXPECT_GT(glm::length(was.force_N), 0.05);
    return std::array{
        relative(is.force_N - motion.rotation * was.force_N, was.force_N),
        glm::length(is.torque_N_m - motion.rotation * was.torque_N_m) / glm::length(was.force_N)};
  };
  for (const glm::dvec3& axis :
       {glm::dvec3{0, 0, 1}, glm::dvec3{0.3, -0.8, 0.5}, glm::dvec3{1, 0.2, -0.1}}) {
    const auto [force, lever_m] =
        turned_error({.rotation = turn_about(axis, 1.1), .position_m = {0.1, -0.2, 0.05}});
    EXPECT_LT(force, 1e-4);
    EXPECT_LT(lever_m, 1e-6);
  }
}

// The offset surface of a ball on points of height h, a distance L apart: arcs, and the floor where L
// exceeds 2·√(2Rh − h²). The points are 20 µm wide, so that some sample meets each.
class BallOnPlateWithPoints : public testing::Test {
 protected:
  static constexpr double kRadius_m = 1e-3;
  static constexpr double kSpacing_m = 0.8e-3;
  static constexpr double kHalfPoint_m = 10e-6;
  static constexpr double kCell_m = 2.5e-6;
  // Points at (i + offset)·L on the line y = 0.
  static TexturedMesh plate(double offset, double height_m) {
    return textured_plate(3.2e-3, 5e-6, [=](double x_m, double y_m) {
      const double from_point_m =
          kSpacing_m * std::abs(x_m / kSpacing_m - offset - std::round(x_m / kSpacing_m - offset));
      return std::max(from_point_m, std::abs(y_m)) < kHalfPoint_m + 1e-9 ? height_m : 0.0;
    });
  }
  // The ball's lowest point at (x, 0, −0.02 mm).
  Penetration answer(double x_m, double offset, double height_m) const {
    TexturedContacts contacts = between(ball_, plate(offset, height_m), hard(8.0 * kCell_m, 8));
    const auto found = contacts.find(pose_at({x_m, 0.0, -kSunk_m}), {}, kTick_s);
    EXPECT_EQ(found.size(), 1U);
    return found[0].penetration;
  }
  static constexpr double kSunk_m = 0.02e-3;
  const TexturedMesh ball_ = shifted(bare(ball(kRadius_m, 200, 32)), {0.0, 0.0, kRadius_m});
};

TEST_F(BallOnPlateWithPoints, FollowsTheArcsOfTheOffsetSurface) {
  constexpr double kHeight_m = 0.15e-3;
  for (const double x_m : {0.33e-3, 0.38e-3}) {
    const Penetration found = answer(x_m, 0.0, kHeight_m);
    const double beside_m = x_m - kHalfPoint_m;
    const double along_m = std::sqrt(kRadius_m * kRadius_m - beside_m * beside_m);
    EXPECT_NEAR(found.depth_m, kHeight_m + kSunk_m - (kRadius_m - along_m),
                0.01 * (kRadius_m - along_m));
    EXPECT_NEAR(found.slope.x, -beside_m / along_m, 0.01 * beside_m / along_m) << x_m;
  }
}

TEST_F(BallOnPlateWithPoints, DropsToTheFloorWhereTheDropSpacingSays) {
  const double half_m = 0.5 * kSpacing_m - kHalfPoint_m;
  const double cusp_m = kRadius_m - std::sqrt(kRadius_m * kRadius_m - half_m * half_m);
  EXPECT_NEAR(answer(0.0, 0.5, 0.97 * cusp_m).depth_m, kSunk_m, 0.01 * cusp_m);
  EXPECT_NEAR(answer(0.0, 0.5, 1.03 * cusp_m).depth_m, kSunk_m + 0.03 * cusp_m, 0.01 * cusp_m);
}

// Net over gross work of the ball around a loop that is no mirror image of itself.
class BallAroundALoop : public testing::Test {
 protected:
  static constexpr double kWavelength_m = 1e-3;
  double net_over_gross(const WindowSampling& sampling) const {
    TexturedContacts contacts = between(ball_, plate_, sampling);
    constexpr int kPoints = 300;
    const auto place_m = [](int point) {
      const double t = 2.0 * std::numbers::pi * point / kPoints;
      return glm::dvec3{0.35e-3 * std::cos(t), 0.30e-3 * std::sin(t + 0.4),
                        -0.1e-3 + 0.04e-3 * std::sin(2.0 * t + 0.6)};
    };
    contacts.find(pose_at(place_m(0)), {}, kTick_s);
    double net_J = 0.0;
    double gross_J = 0.0;
    for (int point = 0; point < kPoints; ++point) {
      const glm::dvec3 from_m = place_m(point);
      const glm::dvec3 to_m = place_m(point + 1);
      const auto found = contacts.find(pose_at(0.5 * (from_m + to_m)), {}, kTick_s);
      const double work_J = glm::dot(wrench_about({}, found).force_N, to_m - from_m);
      net_J += work_J;
      gross_J += std::abs(work_J);
    }
    EXPECT_GT(gross_J, 1e-6);
    return std::abs(net_J) / gross_J;
  }
  const TexturedMesh ball_ = shifted(bare(ball(0.5e-3, 40, 40)), {0.0, 0.0, 0.5e-3});
  const TexturedMesh plate_ = textured_shape(
      PlateShape{{0.006, 0.006, 0.004}},
      *grating({.amplitude_m = 0.05e-3, .wavelength_m = kWavelength_m, .pitch_m = 0.05e-3}),
      {.rim_m = 0.001, .samples_per_wavelength = 4.0});
};

TEST_F(BallAroundALoop, DoesNoNetWorkInTheLimitOfSmallSteps) {
  EXPECT_LT(net_over_gross(hard(kWavelength_m / 30.0, 2)), 1e-3);
  EXPECT_LT(net_over_gross(hard(kWavelength_m / 8.0)), 0.01);  // the coarsest that is advised
}

TEST_F(BallAroundALoop, DoesHardlyAnyWithTheSmoothMaximum) {
  // The window goes along with the ball, and its samples meet the texture elsewhere each time: what is left depends on the ticks
  // in which heights are renewed.
  EXPECT_LT(net_over_gross({.law = SmoothMaximum{.tau_m = 20e-6}, .cell_m = kWavelength_m / 60.0}),
            5e-5);
}

}  // namespace
}  // namespace asperity
