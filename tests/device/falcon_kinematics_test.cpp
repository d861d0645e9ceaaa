// A Falcon's arms and grip: exact, without memory, and with forces that obey virtual work.

#include "device/falcon/falcon_kinematics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "device/falcon/falcon_device.h"
#include "tests/device/falcon_arm_angles.h"
#include "tests/support/allocation_guard.h"

namespace asperity::falcon {
namespace {

constexpr double kMiddle_m = 0.115;

/// All over the workspace that the driver declares: the largest cube that the legs fill.

void for_each_place(const std::function<void(const glm::dvec3&)>& act) {
  const double half_m = falcon_capability().workspace_maximum_m.x;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        act(glm::dvec3(0.0, 0.0, kMiddle_m) + half_m / 4.0 * glm::dvec3(x, y, z));
      }
    }
  }
}

// dθ/dp of leg i, by central differences of the closed way back.
glm::dvec3 slope(std::size_t leg, const glm::dvec3& p) {
  constexpr double kStep_m = 1e-6;
  glm::dvec3 slope{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 there = p;
    glm::dvec3 back = p;
    there[axis] += kStep_m;
    back[axis] -= kStep_m;
    slope[axis] = (arm_angles_rad(there)[leg] - arm_angles_rad(back)[leg]) / (2.0 * kStep_m);
  }
  return slope;
}

// Solves arm_angles_rad(p) = θ by coordinate steps that halve: slow, and shares nothing with what is
// tested but the way back.
glm::dvec3 searched_m(const ArmAngles_rad& angles) {
  const auto error = [&angles](const glm::dvec3& p) {
    const std::array<double, 3> here = arm_angles_rad(p);
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::pow(here[i] - angles[i], 2);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  };
  glm::dvec3 p(0.0, 0.0, kMiddle_m);
  double best = error(p);
  for (double step_m = 0.02; step_m > 1e-9;) {
    bool better = false;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {-1.0, 1.0}) {
        glm::dvec3 tried = p;
        tried[axis] += side * step_m;
        if (const double there = error(tried); there < best) {
          best = there;
          p = tried;
          better = true;
        }
      }
    }
    if (!better) step_m *= 0.5;
  }
  return p;
}

TEST(FalconKinematics, ComesBackToWhereTheArmsWereComputedForOverTheWholeWorkspace) {
  double worst_m = 0.0;
  for_each_place([&](const glm::dvec3& p) {
    const auto found = position_m(arm_angles_rad(p));
    ASSERT_TRUE(found.has_value()) << p.x << ' ' << p.y << ' ' << p.z;
    worst_m = std::max(worst_m, glm::distance(*found, p));
  });
  EXPECT_LT(worst_m, 1e-12);
}

TEST(FalconKinematics, AgreesWithASearch) {
  for (const glm::dvec3& p : {glm::dvec3(0.0, 0.0, 0.115), glm::dvec3(0.04, -0.03, 0.10),
                              glm::dvec3(-0.04, 0.04, 0.14), glm::dvec3(0.01, 0.03, 0.15)}) {
    const ArmAngles_rad angles = arm_angles_rad(p);
    EXPECT_LT(glm::distance(position_m(angles).value(), searched_m(angles)), 1e-7);
  }
}

TEST(FalconKinematics, TellsOneCountApart) {
  // The finest step anywhere in the workspace is tens of micrometres: never 0, never coarse.
  double finest_m = 1.0;
  double coarsest_m = 0.0;
  for_each_place([&](const glm::dvec3& p) {
    const auto counts = counts_at(p);
    const glm::dvec3 here = position_m(angles_at(counts)).value();
    EXPECT_LT(glm::distance(here, p), 100e-6);
    for (std::size_t i = 0; i < 3; ++i) {
      auto next = counts;
      ++next[i];
      const double step_m = glm::distance(position_m(angles_at(next)).value(), here);
      finest_m = std::min(finest_m, step_m);
      coarsest_m = std::max(coarsest_m, step_m);
    }
  });
  EXPECT_GT(finest_m, 15e-6);
  EXPECT_LT(coarsest_m, 75e-6);
}

TEST(FalconKinematics, GivesTorquesThatDoTheWorkOfTheForce) {
  // τ·dθ = F·dp for every small motion: F = Σ τ_i ∇θ_i.
  for_each_place([](const glm::dvec3& p) {
    const ArmAngles_rad angles = arm_angles_rad(p);
    for (const glm::dvec3& force_N :
         {glm::dvec3(3.0, 0.0, 0.0), glm::dvec3(0.0, -2.0, 1.0), glm::dvec3(1.0, 1.0, -4.0)}) {
      const glm::dvec3 torques = torques_N_m(angles, p, force_N).value();
      glm::dvec3 given_N{0.0};
      for (std::size_t i = 0; i < 3; ++i) given_N += torques[static_cast<int>(i)] * slope(i, p);
      ASSERT_LT(glm::distance(given_N, force_N), 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
    }
  });
}

TEST(FalconKinematics, SendsTorquesAsWordsAgainstTheAnglesSense) {
  const MotorWords motors = words_for({0.1, -0.02, 0.00006});
  EXPECT_EQ(motors.words, (std::array<std::int16_t, 3>{-1000, 200, -1}));
  EXPECT_EQ(motors.part, 1.0);
}

// The force that motor words give at `p`, by virtual work.
glm::dvec3 force_of_words_N(const std::array<std::int16_t, 3>& words, const glm::dvec3& p) {
  glm::dvec3 force_N{0.0};
  for (std::size_t i = 0; i < 3; ++i) force_N += words[i] / -10000.0 * slope(i, p);
  return force_N;
}

TEST(FalconKinematics, HasOtherWordsThanAFreeDriverThatDoesNotTransposeItsJacobian) {
  const glm::dvec3 p(0.0, 0.0, 0.125);
  const MotorWords ours = words_for(torques_N_m(arm_angles_rad(p), p, {1.0, 0.0, 0.0}).value());
  EXPECT_EQ(ours.words, (std::array<std::int16_t, 3>{-179, 606, -427}));
  EXPECT_LT(glm::distance(force_of_words_N(ours.words, p), {1.0, 0.0, 0.0}), 1e-3);
  // What that driver sends for 1 N along x: its first motor agrees, so that order, sense and scale do.
  const glm::dvec3 theirs_N = force_of_words_N({-178, 596, -324}, p);
  EXPECT_NEAR(theirs_N.x, 0.914, 1e-3);
  EXPECT_NEAR(theirs_N.y, -0.077, 1e-3);
  EXPECT_NEAR(theirs_N.z, -0.124, 1e-3);
  // Its words are the first column of dp/dθ and not the first row; the z of each also has sin θ2 for sin θ3.
  std::array<glm::dvec3, 3> torques{};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit_N{0.0};
    unit_N[axis] = 1.0;
    torques[static_cast<std::size_t>(axis)] = torques_N_m(arm_angles_rad(p), p, unit_N).value();
  }
  EXPECT_NEAR(-10000.0 * torques[0][0], -178, 1.0);
  EXPECT_NEAR(-10000.0 * torques[1][0], 596, 1.0);
  EXPECT_NEAR(-10000.0 * torques[2][0], -252, 1.0);
}

TEST(FalconKinematics, ShortensTooMuchTorqueAndNeverTurnsAMotorRound) {
  const glm::dvec3 p(0.0, 0.0, kMiddle_m);
  const glm::dvec3 one = torques_N_m(arm_angles_rad(p), p, {1.0, 0.0, 0.0}).value();
  for (const double newtons : {6.0, 60.0, 1e3, 1e9, 1e300}) {
    const MotorWords motors = words_for(newtons * one);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LE(std::abs(motors.words[i]), kLargestWord);
      EXPECT_EQ(motors.words[i] > 0, one[static_cast<int>(i)] < 0.0);
    }
    EXPECT_NEAR(motors.words[0] / static_cast<double>(motors.words[1]), one[0] / one[1], 1e-3);
  }
  // 60 N would not fit into the sixteen bits of a word.
  EXPECT_LT(words_for(60.0 * one).part, kLargestWord / 32768.0);
}

TEST(FalconKinematics, SendsNothingForTorquesThatAreNoNumbers) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const MotorWords motors = words_for({0.1, bad, 0.1});
    EXPECT_EQ(motors.words, (std::array<std::int16_t, 3>{}));
    EXPECT_EQ(motors.part, 0.0);
  }
}

TEST(FalconKinematics, FindsNoPlaceForArmsThatCannotMeet) {
  // All words that could come over a wire: a place, or none; never a number that is none.
  int places = 0;
  int none = 0;
  for (int i = -32768; i < 32768; i += 2099) {
    for (int j = -32768; j < 32768; j += 2503) {
      for (int k = -32768; k < 32768; k += 2999) {
        const auto found =
            position_m(angles_at({static_cast<std::int16_t>(i), static_cast<std::int16_t>(j),
                                  static_cast<std::int16_t>(k)}));
        if (found) {
          ASSERT_TRUE(std::isfinite(found->x) && std::isfinite(found->y) &&
                      std::isfinite(found->z));
          ++places;
        } else {
          ++none;
        }
      }
    }
  }
  EXPECT_GT(places, 0);
  EXPECT_GT(none, 0);
  EXPECT_FALSE(position_m({0.6, std::numeric_limits<double>::quiet_NaN(), 0.6}).has_value());
}

// The force that the weakest direction has at `p` before a word reaches its limit.
double weakest_N(const glm::dvec3& p) {
  std::array<glm::dvec3, 3> torques_per_N{};  // a motor's torque for 1 N along x, y, z
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 unit_N{0.0};
    unit_N[axis] = 1.0;
    const glm::dvec3 torques = torques_N_m(arm_angles_rad(p), p, unit_N).value();
    for (std::size_t i = 0; i < 3; ++i) torques_per_N[i][axis] = torques[static_cast<int>(i)];
  }
  double weakest_N = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& per_N : torques_per_N) {
    weakest_N = std::min(weakest_N, kLargestWord / 10000.0 / glm::length(per_N));
  }
  return weakest_N;
}

TEST(FalconKinematics, IsStrongestInTheMiddle) {
  // What docs/falcon.md and the driver say about it.
  EXPECT_NEAR(weakest_N({0.0, 0.0, kMiddle_m}), 6.6, 0.05);
  EXPECT_NEAR(weakest_N({0.0, 0.0, kMiddle_m}), falcon_capability().peak_force_N, 0.05);
  double anywhere_N = std::numeric_limits<double>::infinity();
  for_each_place([&](const glm::dvec3& p) { anywhere_N = std::min(anywhere_N, weakest_N(p)); });
  EXPECT_NEAR(anywhere_N, 3.8, 0.05);
}

TEST(FalconKinematics, DoesNotTouchTheHeap) {
  const ArmAngles_rad angles = arm_angles_rad({0.01, 0.02, 0.12});
  AllocationGuard guard;
  const auto p = position_m(angles);
  const auto torques = torques_N_m(angles, p.value(), {1.0, 2.0, 3.0});
  (void)words_for(torques.value());
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity::falcon
