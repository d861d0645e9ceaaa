// The settings with which the law of friction `lugre` sticks and slips, against the condition of docs/models/friction.md.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/force/friction.h"

namespace asperity {
namespace {

constexpr double kSliding = 0.2;         // μ
constexpr double kStaticRatio = 1.5;     // μ_s/μ
constexpr double kSpeed_m_per_s = 0.01;  // v₀
constexpr double kPressed_N = 1.0;
constexpr double kHand_kg = 0.05;
constexpr double kGrip_N_per_m = 100.0;
constexpr double kGrip_N_s_per_m = 1.0;
constexpr double kDrawn_m_per_s = 0.005;

Friction adhesion(double stiffness_N_per_m, double damping_N_s_per_m) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  return {kSliding, complete_values("friction", declared,
                                    {{"friction_law", std::string("lugre")},
                                     {"friction_smoothing_s", 0.0},
                                     {"friction_stiffness_N_per_m", stiffness_N_per_m},
                                     {"friction_speed_m_per_s", kSpeed_m_per_s},
                                     {"friction_static_ratio", kStaticRatio},
                                     {"friction_damping_N_s_per_m", damping_N_s_per_m}})};
}

struct Drawn {
  std::vector<double>
      slips_s{};  ///< when the hand begins to move at three times the speed of its pull
  double slowest_m_per_s = 1.0;  ///< in the second half of the time
  double fastest_m_per_s = 0.0;
};

/// A hand of a mass on a spring and a damper that are drawn at a constant speed, for 10 s.
Drawn drawn(double stiffness_N_per_m, double damping_N_s_per_m, double rate_Hz) {
  constexpr double kDuration_s = 10.0;
  constexpr double kStep_s = 5e-5;
  Friction friction = adhesion(stiffness_N_per_m, damping_N_s_per_m);
  const double period_s = 1.0 / rate_Hz;
  const auto steps = static_cast<int>(std::lround(period_s / kStep_s));
  Drawn result{};
  double x_m = 0.0;
  double v_m_per_s = 0.0;
  bool slips = false;
  for (double time_s = 0.0; time_s < kDuration_s; time_s += period_s) {
    const double drag_N =
        friction.drag_N({.position_m = {x_m, 0.0}, .normal_N = kPressed_N, .dt_s = period_s}).x;
    for (int i = 0; i < steps; ++i) {
      const double pull_N = kGrip_N_per_m * (kDrawn_m_per_s * (time_s + i * kStep_s) - x_m) +
                            kGrip_N_s_per_m * (kDrawn_m_per_s - v_m_per_s);
      v_m_per_s += kStep_s / kHand_kg * (pull_N - drag_N);
      x_m += kStep_s * v_m_per_s;
    }
    if (!slips && v_m_per_s > 3.0 * kDrawn_m_per_s) result.slips_s.push_back(time_s);
    slips = v_m_per_s > (slips ? 1.0 : 3.0) * kDrawn_m_per_s;
    if (time_s < 0.5 * kDuration_s) continue;
    result.slowest_m_per_s = std::min(result.slowest_m_per_s, v_m_per_s);
    result.fastest_m_per_s = std::max(result.fastest_m_per_s, v_m_per_s);
  }
  return result;
}

/// (b + m·p − γ·p·σ₁/σ)·(k_h + b·p − γ·p) − m·k_h·p: negative where even sliding is unstable.
double margin(double stiffness_N_per_m, double damping_N_s_per_m) {
  const double part = kDrawn_m_per_s / kSpeed_m_per_s;
  const double extra_N = kSliding * kPressed_N * (kStaticRatio - 1.0) * std::exp(-part * part);
  const double level_N = kSliding * kPressed_N + extra_N;
  const double fall_N_s_per_m = 2.0 * extra_N * part / kSpeed_m_per_s;     // γ
  const double rate_per_s = stiffness_N_per_m * kDrawn_m_per_s / level_N;  // p
  const double damped = kGrip_N_s_per_m + kHand_kg * rate_per_s -
                        fall_N_s_per_m * rate_per_s * damping_N_s_per_m / stiffness_N_per_m;
  return damped * (kGrip_N_per_m + (kGrip_N_s_per_m - fall_N_s_per_m) * rate_per_s) -
         kHand_kg * kGrip_N_per_m * rate_per_s;
}

TEST(LugreFriction, SticksAndSlipsOnAStiffAdhesion) {
  EXPECT_LT(margin(1500.0, 3.0), 0.0);
  const auto mean_period_s = [](const Drawn& hand) {
    return (hand.slips_s.back() - hand.slips_s[2]) / static_cast<double>(hand.slips_s.size() - 3);
  };
  const Drawn slow_loop = drawn(1500.0, 3.0, 1000.0);
  ASSERT_GT(slow_loop.slips_s.size(), 15U);
  EXPECT_NEAR(mean_period_s(slow_loop), 0.47, 0.02);
  EXPECT_LT(slow_loop.slowest_m_per_s, 0.0);  // it sticks, and springs back after a slip
  const Drawn fast_loop = drawn(1500.0, 3.0, 4000.0);
  ASSERT_GT(fast_loop.slips_s.size(), 15U);
  EXPECT_NEAR(mean_period_s(fast_loop), mean_period_s(slow_loop), 0.02);
}

TEST(LugreFriction, SlidesEvenlyOnTheDefaultAdhesionWhateverItsStaticRatio) {
  EXPECT_GT(margin(120.0, 0.0), 0.0);
  const Drawn hand = drawn(120.0, 0.0, 1000.0);
  EXPECT_TRUE(hand.slips_s.empty());
  EXPECT_GT(hand.slowest_m_per_s, 0.99 * kDrawn_m_per_s);
  EXPECT_LT(hand.fastest_m_per_s, 1.01 * kDrawn_m_per_s);
}

// The stiffness at which the condition changes its sign is 548 N/m.
TEST(LugreFriction, SlidesUnevenlyFromTheStiffnessOfItsCondition) {
  EXPECT_GT(margin(546.0, 0.0), 0.0);
  EXPECT_LT(margin(551.0, 0.0), 0.0);
  const auto range = [](double stiffness_N_per_m) {
    const Drawn hand = drawn(stiffness_N_per_m, 0.0, 4000.0);
    return (hand.fastest_m_per_s - hand.slowest_m_per_s) / kDrawn_m_per_s;
  };
  EXPECT_LT(range(0.8 * 548.0), 0.05);
  EXPECT_GT(range(1.2 * 548.0), 0.5);
}

}  // namespace
}  // namespace asperity
