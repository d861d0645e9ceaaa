// What friction requires of a device near rest, and the dampers and springs that a measured device renders.

#include "renderers/offline/friction_near_rest.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/built_in_models.h"
#include "renderers/offline/sampled_loop.h"

namespace asperity {
namespace {

constexpr double kLoopPeriod_s = 1e-3;

PressedFriction pressed(const std::string& law, const ParameterValues& parameters, double force_N,
                        double friction = 0.4) {
  const ModelRegistry models = built_in_models();
  StimulusDescription stimulus{.model = "sinusoid", .parameters = parameters};
  stimulus.parameters["friction_law"] = law;
  stimulus.material.friction = friction;
  return pressed_friction_of(*models.find("sinusoid"), stimulus, force_N).value();
}

TEST(PressedFriction, IsADamperNearRestWithTheRoundedLaw) {
  const PressedFriction friction = pressed("rounded", {{"friction_speed_m_per_s", 0.01}}, 2.0);
  EXPECT_DOUBLE_EQ(friction.near_rest(kLoopPeriod_s).damper_N_s_per_m,
                   80.0);  // 0.4 · 2 N / 0.01 m/s
  EXPECT_EQ(friction.near_rest(kLoopPeriod_s).stiffness_N_per_m, 0.0);
  EXPECT_DOUBLE_EQ(friction.force_with_N(40.0), 1.0);
  EXPECT_DOUBLE_EQ(friction.speed_with_m_per_s(40.0), 0.02);
  EXPECT_GT(friction.greatest_speed_m_per_s, 0.01);
}

TEST(PressedFriction, IsNoneWithoutFriction) {
  const ModelRegistry models = built_in_models();
  StimulusDescription smooth{.model = "sinusoid"};
  smooth.material.friction = 0.0;
  EXPECT_FALSE(pressed_friction_of(*models.find("sinusoid"), smooth, 2.0));
}

// A quarter of 2m/T = 100 N s/m without a delay, at the end of the step: 25/(1 + 25 · 1 ms/50 g).
TEST(PressedFriction, IsABoundedDamperWithTheBoundedLaw) {
  const ParameterValues undelayed{{"friction_mass_kg", 0.05}, {"friction_delay_s", 0.0}};
  EXPECT_NEAR(pressed("bounded", undelayed, 2.0).near_rest(kLoopPeriod_s).damper_N_s_per_m,
              25.0 / 1.5, 1e-9);
  EXPECT_NEAR(pressed("bounded", undelayed, 0.1).near_rest(kLoopPeriod_s).damper_N_s_per_m,
              4.0 / 1.08, 1e-9)
      << "below the bound it is μN/v₀";
}

/// The greatest change of the drag over the change of the position, at rest, by the law itself.
TEST(PressedFriction, HasTheSlopesOfItsLaws) {
  for (const std::string law : {"rounded", "bounded", "proxy", "elastoplastic", "dahl", "lugre"}) {
    const PressedFriction friction =
        pressed(law, {{"friction_smoothing_s", 0.0}, {"friction_damping_N_s_per_m", 0.7}}, 1.0);
    const FrictionNearRest near_rest = friction.near_rest(kLoopPeriod_s);
    constexpr double kWay_m = 1e-9;
    FrictionState state{};
    friction.law->drag_N(friction.settings, {.normal_N = 1.0, .dt_s = kLoopPeriod_s}, state);
    const double drag_N =
        friction.law
            ->drag_N(friction.settings,
                     {.position_m = {kWay_m, 0.0}, .normal_N = 1.0, .dt_s = kLoopPeriod_s}, state)
            .x;
    EXPECT_NEAR(drag_N / kWay_m,
                near_rest.stiffness_N_per_m + near_rest.contact_damper_N_s_per_m / kLoopPeriod_s,
                1e-3)
        << law;
    FrictionState at_rest{};
    const double damped_N =
        friction.law
            ->drag_N(friction.settings,
                     {.velocity_m_per_s = {kWay_m, 0.0}, .normal_N = 1.0, .dt_s = kLoopPeriod_s},
                     at_rest)
            .x;
    EXPECT_NEAR(damped_N / kWay_m, near_rest.damper_N_s_per_m, 1e-6) << law;
  }
}

// 1/(e^0.4 − 1) = 2.0332 ms in each of two low-passes of 2.5 ms; less than 2 · 2.5 ms.
TEST(PressedFriction, RequiresTheDampingOfADelayedSpring) {
  const DampedResponse late{.latency_s = 1e-3};
  EXPECT_NEAR(required_damping_N_s_per_m(pressed("dahl", {}, 1.0).near_rest(kLoopPeriod_s), late,
                                         kLoopPeriod_s),
              120.0 * (0.5e-3 + 1e-3 + 2.0 * 2.0332e-3), 1e-4);
  const ParameterValues stiff{{"friction_stiffness_N_per_m", 1000.0},
                              {"friction_smoothing_s", 0.0},
                              {"friction_damping_N_s_per_m", 2.0}};
  EXPECT_NEAR(required_damping_N_s_per_m(pressed("proxy", stiff, 1.0).near_rest(kLoopPeriod_s),
                                         late, kLoopPeriod_s),
              1000.0 * 1.5e-3 + 2.0, 1e-9);
  EXPECT_EQ(required_damping_N_s_per_m(pressed("rounded", {}, 1.0).near_rest(kLoopPeriod_s), late,
                                       kLoopPeriod_s),
            0.0);
}

TEST(PressedFriction, NamesTheStiffestContactThatADeviceRenders) {
  DampedResponse device{.damping_N_s_per_m = 5.0, .latency_s = 1e-3};
  FrictionNearRest contact =
      pressed("proxy", {{"friction_damping_N_s_per_m", 1.0}}, 1.0).near_rest(kLoopPeriod_s);
  contact.stiffness_N_per_m = stiffest_contact_N_per_m(contact, device, kLoopPeriod_s);
  EXPECT_NEAR(required_damping_N_s_per_m(contact, device, kLoopPeriod_s), 5.0, 1e-9);
  device.damping_N_s_per_m = 0.5;
  EXPECT_LT(stiffest_contact_N_per_m(contact, device, kLoopPeriod_s), 0.0);
}

// The force that is left 4 to 5 s after a push of a free mass with a damper, with a latency.
double left_N(const PressedFriction& friction, double mass_kg, double damping_N_s_per_m,
              double latency_s) {
  constexpr int kSubsteps = 10;
  constexpr double kStep_s = kLoopPeriod_s / kSubsteps;
  FrictionState state{};
  double position_m = 0.0;
  double velocity_m_per_s = 0.1;
  std::deque<double> past_m(static_cast<std::size_t>(std::lround(latency_s / kStep_s)) + 1, 0.0);
  std::vector<double> forces_N{};
  for (int tick = 0; tick < 5000; ++tick) {
    const double drag_N = friction.law
                              ->drag_N(friction.settings,
                                       {.position_m = {past_m.front(), 0.0},
                                        .normal_N = friction.force_N,
                                        .dt_s = kLoopPeriod_s},
                                       state)
                              .x;
    if (tick >= 4000) forces_N.push_back(drag_N);
    for (int step = 0; step < kSubsteps; ++step) {
      velocity_m_per_s = (velocity_m_per_s - kStep_s / mass_kg * drag_N) /
                         (1.0 + kStep_s / mass_kg * damping_N_s_per_m);
      position_m += kStep_s * velocity_m_per_s;
      past_m.push_back(position_m);
      past_m.pop_front();
    }
  }
  const auto [least_N, greatest_N] = std::minmax_element(forces_N.begin(), forces_N.end());
  return *greatest_N - *least_N;
}

// Below the condition a vibration lasts, above it dies.
TEST(PressedFriction, VibratesBelowTheRequiredDampingOnly) {
  for (const auto& [stiffness_N_per_m, smoothing_s, latency_s] :
       {std::tuple(120.0, 2.5e-3, 1e-3), std::tuple(1000.0, 0.0, 0.0),
        std::tuple(1000.0, 0.0, 1e-3)}) {
    for (const std::string law : {"proxy", "elastoplastic", "dahl", "lugre"}) {
      const PressedFriction friction = pressed(law,
                                               {{"friction_stiffness_N_per_m", stiffness_N_per_m},
                                                {"friction_smoothing_s", smoothing_s}},
                                               0.5);
      const double required_N_s_per_m = required_damping_N_s_per_m(
          friction.near_rest(kLoopPeriod_s), {.latency_s = latency_s}, kLoopPeriod_s);
      for (const double mass_kg : {0.02, 0.05}) {
        EXPECT_GT(left_N(friction, mass_kg, 0.75 * required_N_s_per_m, latency_s), 0.005)
            << law << ' ' << stiffness_N_per_m << ' ' << mass_kg;
        EXPECT_LT(left_N(friction, mass_kg, 1.25 * required_N_s_per_m, latency_s), 1e-3)
            << law << ' ' << stiffness_N_per_m << ' ' << mass_kg;
      }
    }
  }
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
