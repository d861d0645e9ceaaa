// Tests the properties of a device from its motion, with motions whose answers are computed by hand.

#include "analysis/signals/device_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// From 0 to 10 mm or back at a steady speed, under F = 100·x + 0.2 ± H.
ForcedMotion leg(double velocity_m_per_s, double resistance_N) {
  constexpr double kLength_m = 0.01;
  ForcedMotion made{};
  for (int i = 0; i <= 100; ++i) {
    const double part = i / 100.0;
    const double x_m = kLength_m * (velocity_m_per_s > 0.0 ? part : 1.0 - part);
    made.time_s.push_back(part * kLength_m / std::abs(velocity_m_per_s));
    made.position_m.push_back(x_m);
    made.force_N.push_back(100.0 * x_m + 0.2 + std::copysign(resistance_N, velocity_m_per_s));
  }
  return made;
}

TEST(SweepResponse, SeparatesSpringOffsetAndResistance) {
  const auto response = sweep_response({leg(0.01, 0.5), leg(-0.01, 0.5)});
  ASSERT_TRUE(response);
  EXPECT_NEAR(response->stiffness_N_per_m, 100.0, 1e-9);
  EXPECT_NEAR(response->offset_N, 0.2, 1e-12);
  EXPECT_NEAR(response->resistance_N, 0.5, 1e-12);
  EXPECT_NEAR(response->speed_m_per_s, 0.01, 1e-12);
  EXPECT_FALSE(sweep_response({leg(0.01, 0.5), leg(0.02, 0.5)}));  // one direction is missing
  ForcedMotion uneven = leg(0.01, 0.5);
  uneven.force_N.pop_back();
  EXPECT_THROW(sweep_response({uneven}), std::invalid_argument);
}

// A swing of 0.1 mm about a steady motion has a standard deviation of 0.1/√2 mm.
TEST(Unevenness, IsTheDeviationFromASteadyMotion) {
  ForcedMotion swinging = leg(-0.01, 0.5);
  EXPECT_NEAR(unevenness_m({swinging}).value(), 0.0, 1e-12);
  for (std::size_t i = 0; i < swinging.position_m.size(); ++i) {
    swinging.position_m[i] += 1e-4 * std::sin(0.4 * std::numbers::pi * static_cast<double>(i));
  }
  EXPECT_NEAR(unevenness_m({leg(0.01, 0.5), swinging}).value(), 1e-4 / 2.0, 1e-6);
  EXPECT_FALSE(unevenness_m({}));
}

// H = 0.4 + 5·v: 0.45 N at 10 mm/s, 0.6 N at 40 mm/s. Positions 2 ms late on 100 N/m appear as 0.2 N s/m.
TEST(Resistance, IsFrictionAndItsGrowthWithSpeed) {
  const auto slow = sweep_response({leg(0.01, 0.45), leg(-0.01, 0.45)});
  const auto fast = sweep_response({leg(0.04, 0.6), leg(-0.04, 0.6)});
  ASSERT_TRUE(slow && fast);
  auto resistance = resistance_of(*slow, *fast);
  ASSERT_TRUE(resistance);
  EXPECT_NEAR(resistance->friction_N, 0.4, 1e-12);
  EXPECT_NEAR(resistance->growth_N_s_per_m, 5.0, 1e-9);
  EXPECT_NEAR(resistance->damping_N_s_per_m(0.002), 4.8, 1e-9);
  resistance->held_s = 0.001;  // half of it is as late
  EXPECT_NEAR(resistance->damping_N_s_per_m(0.002), 4.75, 1e-9);
  EXPECT_FALSE(resistance_of(*slow, *slow));
}

// 1.2 N against 0.2 N of friction on 0.1 kg: x = ½·10·t², read 2 ms late.
TEST(PushResponse, FindsMassAndDelayOfAConstantAcceleration) {
  Push forward{.rested_at_m = 0.003};
  Push backward{.direction = -1.0, .rested_at_m = 0.003};
  for (int i = 0; i < 30; ++i) {
    const double t_s = i * 1e-3;
    const double moved_s = std::max(0.0, t_s - 0.002);
    for (Push* push : {&forward, &backward}) {
      push->time_s.push_back(t_s);
      push->position_m.push_back(0.003 + push->direction * 5.0 * moved_s * moved_s);
      push->force_N.push_back(push->direction * 1.2);
    }
  }
  const Resistance friction{.friction_N = 0.2};
  const auto response = push_response({forward, backward}, friction);
  ASSERT_TRUE(response);
  EXPECT_NEAR(response->delay_s, 0.002, 1e-12);
  EXPECT_NEAR(response->mass_kg, 0.1, 1e-12);
  EXPECT_FALSE(push_response({}, friction));  // no readings
}

TEST(PositionError, IsNoneOfACubicAndTheOffsetOfAlternatingReadings) {
  ForcedMotion smooth{};
  for (int i = 0; i < 64; ++i) {
    const double t = i * 1e-3;
    smooth.time_s.push_back(t);
    smooth.position_m.push_back(0.01 + 0.2 * t - 3.0 * t * t + 40.0 * t * t * t);
    smooth.force_N.push_back(0.0);
  }
  EXPECT_NEAR(*position_error_m({smooth}), 0.0, 1e-15);
  // ±1 µm in turns is nearly orthogonal to cubics: 64·1 µm² over 60 degrees of freedom.
  for (std::size_t i = 0; i < 64; ++i) smooth.position_m[i] += i % 2 == 0 ? 1e-6 : -1e-6;
  EXPECT_NEAR(*position_error_m({smooth}), std::sqrt(64.0 / 60.0) * 1e-6, 3e-9);
  smooth.time_s.pop_back();
  smooth.position_m.pop_back();
  smooth.force_N.pop_back();
  EXPECT_FALSE(position_error_m({smooth}));
}

// √12 = 3.4641: steps of 34.641 µm have errors of 10 µm.
TEST(RoundingError, IsAStepOverTheRootOfTwelve) {
  EXPECT_NEAR(rounding_error_m(34.641016151e-6), 10e-6, 1e-15);
  EXPECT_NEAR(step_of_rounding_m(10e-6), 34.641016151e-6, 1e-14);
}

// Positions of 2 mm per 0.5 N at 20 Hz, on a drift of 1 mm/s.
TEST(FrequencyResponse, IsAmplitudeOverAmplitude) {
  ForcedMotion tone{};
  for (int i = 0; i < 500; ++i) {
    const double t_s = i * 1e-3;
    const double phase = 2.0 * std::numbers::pi * 20.0 * t_s;
    tone.time_s.push_back(t_s);
    tone.position_m.push_back(2e-3 * std::sin(phase - 1.0) + 1e-3 * t_s);
    tone.force_N.push_back(0.5 * std::sin(phase));
  }
  const auto response = frequency_response(20.0, tone, 0.49);
  ASSERT_TRUE(response);
  EXPECT_EQ(response->frequency_Hz, 20.0);
  EXPECT_NEAR(response->response_m_per_N, 4e-3, 1e-12);
  EXPECT_FALSE(frequency_response(20.0, tone, 0.51));
  const auto moved = component_at(20.0, tone.time_s, tone.position_m);
  ASSERT_TRUE(moved);  // sin(φ − 1) = Re(e^{iφ}·(−i·e^{−i}))
  EXPECT_NEAR(moved->real(), -2e-3 * std::sin(1.0), 1e-12);
  EXPECT_NEAR(moved->imag(), -2e-3 * std::cos(1.0), 1e-12);
}

// A mass of 0.1 kg has ω²|X/F| = 10 everywhere; the second tone of three is 3 times as strong, and the tones lie
// evenly over log f, so that the parabola peaks at the tone itself.
TEST(Resonance, IsWhereTheResponseIsTwiceThatOfTheMass) {
  const auto responses = [](std::array<double, 5> factors) {
    std::vector<FrequencyResponse> made{};
    double frequency_Hz = 10.0;
    for (const double factor : factors) {
      const double omega = 2.0 * std::numbers::pi * frequency_Hz;
      made.push_back({frequency_Hz, factor * 10.0 / (omega * omega)});
      frequency_Hz *= 2.0;
    }
    return made;
  };
  const auto found_Hz = resonance_Hz(responses({1.0, 1.0, 3.0, 1.0, 1.0}));
  ASSERT_TRUE(found_Hz);
  EXPECT_NEAR(*found_Hz, 40.0, 1e-9);
  EXPECT_FALSE(resonance_Hz(responses({1.0, 1.0, 1.9, 1.0, 1.0})));
  EXPECT_FALSE(resonance_Hz(responses({1.0, 1.0, 1.0, 1.0, 3.0})));  // at an end of the list
}

TEST(Swinging, IsMoreThanATenthOfAMillimetreAndFourSteps) {
  const std::vector<double> little{1e-3, 1.09e-3};
  const std::vector<double> much{1e-3, 1.2e-3, 1.1e-3};
  EXPECT_FALSE(is_swinging(little, 0.0));
  EXPECT_TRUE(is_swinging(much, 0.0));
  EXPECT_TRUE(is_swinging(much, 0.049e-3));
  EXPECT_FALSE(is_swinging(much, 0.051e-3));
  EXPECT_FALSE(is_swinging({}, 0.0));
}

// 1 N on 0.05 kg for 10 ms: ½·20·0.01² = 1 mm. A spring of 2000 N/m gives 0.5 mm.
TEST(MotionWithoutFriction, IsThatOfTheMassOrOfTheSpring) {
  const HeldPush push{
      .force_N = 1.0, .duration_s = 0.01, .mass_kg = 0.05, .stiffness_N_per_m = 500.0};
  EXPECT_NEAR(motion_without_friction_m(push), 1e-3, 1e-15);
  HeldPush stiff = push;
  stiff.stiffness_N_per_m = 2000.0;
  EXPECT_NEAR(motion_without_friction_m(stiff), 0.5e-3, 1e-15);
}

// Two pushes of 40 ms, from 0.1 s and 0.18 s: 2 mm forward, then 1 mm backward. Their mean is 1.5 mm.
TEST(MeanMotion, IsTakenInTheDirectionOfEachPush) {
  ForcedMotion motion{};
  for (int i = 0; i <= 240; ++i) {
    motion.time_s.push_back(i * 1e-3);
    motion.position_m.push_back(i <= 105 ? 0.0 : i <= 185 ? 2e-3 : 1e-3);
  }
  const PushTrain train{.first_s = 0.1, .length_s = 0.04, .pushes = 2};
  const auto moved_m = mean_motion_m(train, motion, 0.01);
  ASSERT_TRUE(moved_m);
  EXPECT_NEAR(*moved_m, 1.5e-3, 1e-15);
  const PushTrain later{.first_s = 1.0, .length_s = 0.04, .pushes = 2};
  EXPECT_FALSE(mean_motion_m(later, motion, 0.01));
}

// Steps of √12 µm have σ = 1 µm. Differences of two means of ten, six times: σ²·2/60 = σ²/30.
TEST(FourStandardErrors, AreThoseOfAMeanOfDifferencesOfMeans) {
  EXPECT_NEAR(four_standard_errors_m(std::sqrt(12.0) * 1e-6, {.pushes = 6, .each = 10}),
              4e-6 / std::sqrt(30.0), 1e-18);
}

}  // namespace
}  // namespace asperity
