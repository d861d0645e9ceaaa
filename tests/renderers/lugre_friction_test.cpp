// The law of friction `lugre` by its closed forms.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "renderers/force/friction.h"

namespace asperity {
namespace {

constexpr double kAdhesion_N_per_m = 1000.0;
constexpr double kStribeck_m_per_s = 0.01;
constexpr double kKineticFriction = 0.3;
constexpr double kServoPeriod_s = 1e-3;

/// Without the low-passes of the position.
Friction lugre(double static_ratio, double damping_N_s_per_m, const std::string& law = "lugre") {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  return {kKineticFriction, complete_values("friction", declared,
                                            {{"friction_law", law},
                                             {"friction_smoothing_s", 0.0},
                                             {"friction_stiffness_N_per_m", kAdhesion_N_per_m},
                                             {"friction_speed_m_per_s", kStribeck_m_per_s},
                                             {"friction_static_ratio", static_ratio},
                                             {"friction_damping_N_s_per_m", damping_N_s_per_m}})};
}

FrictionSample pressed_at(const glm::dvec2& position_m, double period_s = kServoPeriod_s) {
  return {.position_m = position_m, .normal_N = 1.0, .dt_s = period_s};
}

TEST(LugreFriction, DragsAtTheLevelOfItsSpeedWhereItSlides) {
  for (const double speed_m_per_s : {1e-3, 5e-3, 1e-2, 2e-2, 0.1}) {
    Friction friction = lugre(1.5, 2.0);
    double drag_N = 0.0;
    for (int i = 0; i < 40'000; ++i) {
      drag_N = friction.drag_N(pressed_at({speed_m_per_s * kServoPeriod_s * i, 0.0})).x;
    }
    const double part = speed_m_per_s / kStribeck_m_per_s;
    EXPECT_NEAR(drag_N, kKineticFriction * (1.0 + 0.5 * std::exp(-part * part)), 1e-9)
        << speed_m_per_s;
  }
}

TEST(LugreFriction, IsASpringWithADamperNearRestAndNoForceAtRest) {
  Friction friction = lugre(1.5, 2.0);
  EXPECT_EQ(friction.drag_N(pressed_at({0.0, 0.0})).x, 0.0);
  EXPECT_EQ(friction.drag_N(pressed_at({0.0, 0.0})).x, 0.0);
  constexpr double kWay_m = 1e-9;
  EXPECT_NEAR(friction.drag_N(pressed_at({kWay_m, 0.0})).x / kWay_m,
              kAdhesion_N_per_m + 2.0 / kServoPeriod_s, 1e-2);
  EXPECT_NEAR(friction.drag_N(pressed_at({kWay_m, 0.0})).x / kWay_m, kAdhesion_N_per_m, 1e-2)
      << "held";
}

TEST(LugreFriction, IsThatOfDahlWithoutStaticFrictionAndDamping) {
  Friction one = lugre(1.0, 0.0);
  Friction other = lugre(1.0, 0.0, "dahl");
  Random random(8);
  glm::dvec2 place_m{0.0};
  for (int i = 0; i < 1000; ++i) {
    place_m += 1e-4 * glm::dvec2(random.normal(), random.normal());
    EXPECT_LT(glm::length(one.drag_N(pressed_at(place_m)) - other.drag_N(pressed_at(place_m))),
              1e-12);
  }
}

// At a constant speed the steps are exact, however long they are.
TEST(LugreFriction, DoesNotDependOnTheRateAtAConstantSpeed) {
  const auto after_way_N = [](int ticks) {
    Friction friction = lugre(1.5, 0.0);
    constexpr double kLasts_s = 0.02;
    constexpr double kSpeed_m_per_s = 0.012;
    double drag_N = 0.0;
    for (int i = 0; i <= ticks; ++i) {
      drag_N =
          friction
              .drag_N(pressed_at({kSpeed_m_per_s * kLasts_s * i / ticks, 0.0}, kLasts_s / ticks))
              .x;
    }
    return drag_N;
  };
  const double at_1_kHz_N = after_way_N(20);
  EXPECT_GT(at_1_kHz_N, 0.1);
  for (const int ticks : {5, 200, 2000}) EXPECT_NEAR(after_way_N(ticks), at_1_kHz_N, 1e-9);
}

// σ₁'v²(1 − q) is negative after the speed has risen: without the bound 4g/|v| of σ₁' the law would return 20 mJ, where
// ½·σz² = 0.72 mJ are stored.
TEST(LugreFriction, ReturnsNoMoreThanItsSpringHasStoredWhereTheSpeedRises) {
  constexpr double kRatio = 4.0;
  constexpr double kFine_s = 1e-6;
  constexpr double kStored_J =
      0.5 * kRatio * kRatio * kKineticFriction * kKineticFriction / kAdhesion_N_per_m;
  for (const double damping_N_s_per_m : {0.0, 1.0, 20.0}) {
    Friction friction = lugre(kRatio, damping_N_s_per_m);
    double place_m = 0.0;
    for (; place_m < 0.02; place_m += 1e-6) friction.drag_N(pressed_at({place_m, 0.0}, 1e-3));
    double taken_J = 0.0;
    double least_J = 0.0;
    for (int i = 0; i < 20'000; ++i) {
      place_m += 1.0 * kFine_s;  // 1 m/s
      taken_J += friction.drag_N(pressed_at({place_m, 0.0}, kFine_s)).x * kFine_s;
      least_J = std::min(least_J, taken_J);
    }
    EXPECT_GE(least_J, -kStored_J) << damping_N_s_per_m;
  }
}

// Any motion from rest, in fine steps.
TEST(LugreFriction, GivesNoEnergyToAHandThatBeganAtRest) {
  for (const double damping_N_s_per_m : {0.0, 1.0, 20.0}) {
    for (int trial = 0; trial < 50; ++trial) {
      Friction friction = lugre(4.0, damping_N_s_per_m);
      Random random(static_cast<std::uint64_t>(trial));
      constexpr double kFine_s = 1e-5;
      double taken_J = 0.0;
      double last_N = friction.drag_N(pressed_at({0.0, 0.0}, kFine_s)).x;
      double place_m = 0.0;
      for (int burst = 0; burst < 40; ++burst) {
        const double speed_m_per_s =
            (random.uniform() < 0.5 ? -1.0 : 1.0) * std::pow(10.0, -3.0 + 3.0 * random.uniform());
        for (int i = 0; i < 100; ++i) {
          place_m += speed_m_per_s * kFine_s;
          const double drag_N = friction.drag_N(pressed_at({place_m, 0.0}, kFine_s)).x;
          taken_J += 0.5 * (drag_N + last_N) * speed_m_per_s * kFine_s;
          last_N = drag_N;
          ASSERT_GE(taken_J, -1e-7) << damping_N_s_per_m << ' ' << trial;
        }
      }
    }
  }
}

}  // namespace
}  // namespace asperity
