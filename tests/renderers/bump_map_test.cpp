// The perturbed normal of Ho, Basdogan and Srinivasan against its closed forms.

#include "renderers/models/bump_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

// h = A·sin(2πx/L), fine enough that the interpolated slope is that of the formula to 1e-5.
constexpr Grating kBumps{.amplitude_m = 2e-4, .wavelength_m = 2e-3, .pitch_m = 1e-5};
constexpr double kBumps_N_per_m = 500.0;
constexpr double kBumpNumber_per_m = 2.0 * std::numbers::pi / 2e-3;
constexpr double kBumpSlope = 2e-4 * kBumpNumber_per_m;  // a = 0.628

std::unique_ptr<ForceRenderer> bump_map_with(const ParameterValues& parameters) {
  RendererInputs inputs;
  inputs.parameters = parameters;
  inputs.material = {.stiffness_N_per_m = kBumps_N_per_m, .friction = 0.0};
  inputs.patch = wide_patch();
  inputs.height_field = grating(kBumps);
  return make_renderer(bump_map_model(), inputs);
}

glm::dvec3 bump_N(ForceRenderer& renderer, double x_m, double depth_m) {
  return answer(renderer, probe_at({x_m, 0.0, -depth_m})).wrench.force_N;
}

TEST(BumpMap, TurnsTheForceOfALightTouchByTheSlope) {
  const auto renderer = bump_map_with({});
  for (const double phase_rad : {-0.4, 0.0, 0.7, 1.2, 2.0, 3.0}) {
    // h' = A·(1 + sin φ) ≥ 0.12 mm here: 0.05 mm is a light touch.
    const glm::dvec3 force_N = bump_N(*renderer, phase_rad / kBumpNumber_per_m, 5e-5);
    EXPECT_NEAR(force_N.x / force_N.z, -kBumpSlope * std::cos(phase_rad), 1e-4) << phase_rad;
    EXPECT_NEAR(glm::length(force_N), kBumps_N_per_m * 5e-5, 1e-12) << phase_rad;
    EXPECT_NEAR(force_N.y, 0.0, 1e-15);
  }
}

TEST(BumpMap, FollowsItsSecondLawAtDepth) {
  // At φ = 0: h' = A = 0.2 mm, M̂ = (−0.628, 0, 1)/1.18101. d = 1 mm: F_x = −500·0.2 mm·0.628319/1.18101 = −0.0532018 N,
  // F_z = 500·(0.8 mm + 0.2 mm/1.18101) = 0.484673 N.
  const glm::dvec3 force_N = bump_N(*bump_map_with({}), 0.0, 1e-3);
  EXPECT_NEAR(force_N.x, -0.0532018, 1e-5);
  EXPECT_NEAR(force_N.z, 0.484673, 1e-5);
}

TEST(BumpMap, IsContinuousWhereItsLawsMeet) {
  const auto renderer = bump_map_with({{"depth_scale", 0.6}});
  for (const double x_m : {0.0, 1e-4, 2.5e-4, 9e-4}) {
    const double meeting_m = 0.6 * 2e-4 * (1.0 + std::sin(kBumpNumber_per_m * x_m));
    double largest_N = 0.0;
    glm::dvec3 before_N = bump_N(*renderer, x_m, meeting_m - 1e-8);
    for (int step = -9; step <= 10; ++step) {
      const glm::dvec3 here_N = bump_N(*renderer, x_m, meeting_m + 1e-9 * step);
      largest_N = std::max(largest_N, glm::length(here_N - before_N));
      before_N = here_N;
    }
    EXPECT_LE(largest_N, kBumps_N_per_m * 1.01e-9) << x_m;  // k times the step, no jump
  }
}

TEST(BumpMap, NeverExceedsTheForceOfThePlate) {
  for (const double scale : {0.5, 1.0, 5.0}) {
    const auto renderer = bump_map_with({{"height_scale", scale}});
    for (int place = 0; place < 200; ++place) {
      for (const double depth_m : {1e-5, 1e-4, 4e-4, 2e-3}) {
        const glm::dvec3 force_N = bump_N(*renderer, place * 1e-5, depth_m);
        EXPECT_LE(glm::length(force_N), kBumps_N_per_m * depth_m * (1.0 + 1e-12));
        EXPECT_GE(force_N.z, 0.0);
      }
    }
  }
}

TEST(BumpMap, IsThePlateWithoutDepthScale) {
  const auto renderer = bump_map_with({{"depth_scale", 0.0}});
  for (int place = 0; place < 50; ++place) {
    const glm::dvec3 force_N = bump_N(*renderer, place * 4e-5, 3e-4);
    EXPECT_NEAR(glm::length(force_N - glm::dvec3(0.0, 0.0, 0.15)), 0.0, 1e-15);
  }
}

TEST(BumpMap, ApproachesThePlatesNormalAtDepth) {
  const auto renderer = bump_map_with({});
  const auto angle_rad = [&](double depth_m) {
    const glm::dvec3 force_N = bump_N(*renderer, 0.0, depth_m);
    return std::atan2(std::abs(force_N.x), force_N.z);
  };
  EXPECT_NEAR(angle_rad(1e-7), std::atan(kBumpSlope), 1e-4);  // along M̂
  EXPECT_LT(angle_rad(1e-3), 0.2 * angle_rad(1e-7));
  EXPECT_LT(angle_rad(2e-2), 0.01 * angle_rad(1e-7));  // 100 heights deep: along n
}

TEST(BumpMap, BeginsAtThePlaneOrAtTheCrests) {
  EXPECT_EQ(bump_N(*bump_map_with({}), 0.0, 0.0), glm::dvec3(0.0));
  const auto crest = bump_map_with({{"face", std::string("crest")}});
  // The highest sample is 0.01 % below the crest. Twice the amplitude above the plane; there at φ = 0 a light touch of 0.1 mm.
  EXPECT_EQ(bump_N(*crest, 0.0, -4.001e-4), glm::dvec3(0.0));
  EXPECT_NEAR(glm::length(bump_N(*crest, 0.0, -3e-4)), kBumps_N_per_m * 1e-4, 5e-5);
  EXPECT_NEAR(answer(*crest, probe_at({0.0, 0.0, 3e-4})).penetration_m, 1e-4, 1e-7);
}

TEST(BumpMap, TakesFrictionFromTheRenderedNormalForce) {
  RendererInputs inputs;
  inputs.parameters = {{"friction_law", std::string("rounded")}};
  inputs.material = {.stiffness_N_per_m = kBumps_N_per_m, .friction = 0.5};
  inputs.patch = wide_patch();
  inputs.height_field = grating(kBumps);
  const auto renderer = make_renderer(bump_map_model(), inputs);
  ProbeState probe = probe_at({0.0, 0.0, -1e-3});
  const double normal_N = answer(*renderer, probe).wrench.force_N.z;
  probe.velocity_m_per_s = {0.0, 0.03, 0.0};
  EXPECT_NEAR(answer(*renderer, probe).wrench.force_N.y,
              -0.5 * normal_N * 0.03 / std::hypot(0.03, 0.01), 1e-12);
}

// Green's theorem: from the node to the crest at d₁, deeper there, back at d₂, and up at the node.
TEST(BumpMap, DoesTheWorkOfItsClosedFormOnALoop) {
  const auto renderer = bump_map_with({});
  constexpr double kShallow_m = 5e-5;
  constexpr double kDeep_m = 1.5e-4;  // less than h' ≥ A between node and crest: a light touch
  constexpr double kQuarter_m = 5e-4;
  constexpr int kParts = 2000;
  double work_J = 0.0;
  for (int part = 0; part < kParts; ++part) {
    const double middle = (part + 0.5) / kParts;
    const double along_m = kQuarter_m / kParts;
    const double down_m = (kDeep_m - kShallow_m) / kParts;
    work_J += bump_N(*renderer, middle * kQuarter_m, kShallow_m).x * along_m;
    work_J -= bump_N(*renderer, middle * kQuarter_m, kDeep_m).x * along_m;
    const double depth_m = kShallow_m + middle * (kDeep_m - kShallow_m);
    work_J -= bump_N(*renderer, kQuarter_m, depth_m).z * down_m;
    work_J += bump_N(*renderer, 0.0, depth_m).z * down_m;
  }
  const double expected_J =
      kBumps_N_per_m * (kDeep_m - kShallow_m) * std::atan(kBumpSlope) / kBumpNumber_per_m -
      0.5 * kBumps_N_per_m * (kDeep_m * kDeep_m - kShallow_m * kShallow_m) *
          (1.0 - 1.0 / std::sqrt(1.0 + kBumpSlope * kBumpSlope));
  EXPECT_GT(expected_J, 7e-6);
  EXPECT_NEAR(work_J, expected_J, 1e-4 * expected_J);
}

}  // namespace
}  // namespace asperity
