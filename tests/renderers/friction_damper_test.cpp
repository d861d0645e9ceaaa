// Friction near rest as a damper, and the dampers and springs that a measured device renders.

#include "renderers/offline/friction_damper.h"

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/offline/sampled_loop.h"

namespace asperity {
namespace {

StimulusDescription plate_with_friction(double friction, double speed_m_per_s) {
  StimulusDescription stimulus{};
  stimulus.model = "sinusoid";
  stimulus.parameters = {{"friction_speed_m_per_s", speed_m_per_s}};
  stimulus.material.friction = friction;
  return stimulus;
}

TEST(FrictionDamper, IsTheSlopeOfTheFrictionAtRest) {
  const ModelRegistry models = built_in_models();
  const auto damper =
      friction_damper_of(*models.find("sinusoid"), plate_with_friction(0.4, 0.01), 2.0);
  ASSERT_TRUE(damper);
  EXPECT_DOUBLE_EQ(damper->damper_N_s_per_m(), 80.0);  // 0.4 · 2 N / 0.01 m/s
  EXPECT_DOUBLE_EQ(damper->force_with_N(40.0), 1.0);
  EXPECT_DOUBLE_EQ(damper->speed_with_m_per_s(40.0), 0.02);
  EXPECT_GT(damper->greatest_speed_m_per_s, 0.01);
}

TEST(FrictionDamper, IsNoneWithoutFriction) {
  const ModelRegistry models = built_in_models();
  EXPECT_FALSE(friction_damper_of(*models.find("sinusoid"), plate_with_friction(0.0, 0.01), 2.0));
}

TEST(DampedResponse, AddsTheLagOfTheVelocityToTheLatency) {
  const DampedResponse device{.latency_s = 1e-3, .velocity = VelocityWindow{.samples = 5}};
  EXPECT_DOUBLE_EQ(device.delay_s(1e-3), 3e-3);  // (5 − 1)/2 periods
  EXPECT_DOUBLE_EQ(DampedResponse{}.delay_s(1e-3), 0.0);
  EXPECT_DOUBLE_EQ(steepest_damper_N_s_per_m(device, 1e-3),
                   steepest_damper_N_s_per_m(DampedResponse::kAssumedMass_kg, 3e-3, 1e-3));
}

TEST(StiffestSpring, IsTheSmallerOfDampingAndMeasuredSpring) {
  // 2 · 1.5 N s/m · 1000 Hz
  EXPECT_DOUBLE_EQ(stiffest_spring_N_per_m({.damping_N_s_per_m = 1.5}, 1000.0).value(), 3000.0);
  const MeasuredSprings held{.damping_N_s_per_m = 1.5,
                             .held_N_per_m = 2000.0,
                             .held_at_Hz = 1000.0,
                             .stiffest_tried_N_per_m = 8000.0};
  EXPECT_DOUBLE_EQ(stiffest_spring_N_per_m(held, 1000.0).value(), 2000.0);
  EXPECT_DOUBLE_EQ(stiffest_spring_N_per_m(held, 500.0).value(), 1000.0);
  EXPECT_DOUBLE_EQ(stiffest_spring_N_per_m(held, 4000.0).value(), 2000.0);
}

TEST(StiffestSpring, IsUnlimitedWhereTheStiffestSpringOfTheTestWasHeld) {
  const MeasuredSprings held{
      .held_N_per_m = 8000.0, .held_at_Hz = 1000.0, .stiffest_tried_N_per_m = 8000.0};
  EXPECT_FALSE(stiffest_spring_N_per_m(held, 1000.0));
  EXPECT_DOUBLE_EQ(stiffest_spring_N_per_m(held, 500.0).value(), 4000.0);
  EXPECT_FALSE(stiffest_spring_N_per_m({}, 1000.0));
}

TEST(EquivalentSpring, AddsTwiceTheDamperPerPeriod) {
  EXPECT_DOUBLE_EQ(equivalent_spring_N_per_m(500.0, -0.25, 1e-3), 1000.0);
}

}  // namespace
}  // namespace asperity
