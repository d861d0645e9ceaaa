// How long a pressed mass is off a surface, against where a linear mass on a spring lifts off.

#include "renderers/offline/contact_loss.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "device/simulated_device.h"
#include "renderers/models/sinusoid.h"
#include "tests/renderers/surfaces.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr double kPressedWave_m = 2e-3;

struct PressedGrating {
  double amplitude_m = 5e-4;
  double stiffness_N_per_m = 500.0;
};

double lost_on(const PressedGrating& grating, const PressedMass& stroke) {
  return share_out_of_contact(
      sinusoid_model(),
      {.parameters = {{"amplitude_m", grating.amplitude_m}, {"wavelength_m", kPressedWave_m}},
       .material = {.stiffness_N_per_m = grating.stiffness_N_per_m, .friction = 0.0}},
      stroke);
}

/// Of the force by which the surface moves a linear mass that follows it, m, b and k in one. The spring is felt half a
/// tick late on average.
double swing_N(const PressedGrating& grating, const PressedMass& stroke) {
  const std::complex<double> s(0.0, 2.0 * std::numbers::pi * stroke.speed_m_per_s / kPressedWave_m);
  const std::complex<double> spring =
      grating.stiffness_N_per_m * std::exp(-0.5 * s / stroke.rate_Hz);
  const std::complex<double> mass = stroke.mass_kg * s * s + stroke.damping_N_s_per_m * s;
  return grating.amplitude_m * std::abs(spring * mass / (mass + spring));
}

/// What strokes on the simulated device are out of contact for, where they are steady.
double lost_in_strokes(const PressedGrating& grating) {
  VirtualHand hand({.speed_m_per_s = 0.06,
                    .speed_variation = 0.0,
                    .normal_force_N = 1.0,
                    .force_variation = 0.0,
                    .drift_m = 0.0},
                   Random(1));
  SimulatedDevice device(hand, {});
  hand.stroke();
  const auto renderer = make_renderer(
      sinusoid_model(),
      {.parameters = {{"amplitude_m", grating.amplitude_m}, {"wavelength_m", kPressedWave_m}},
       .material = {.stiffness_N_per_m = grating.stiffness_N_per_m, .friction = 0.0}});
  constexpr int kTicks = 15'000;
  constexpr int kSettling = 2000;
  int steady = 0;
  int lost = 0;
  for (int i = 1; i <= kTicks; ++i) {
    const ProbeState probe = device.read(i * 1'000'000LL).value();
    if (i == 1) renderer->reset(probe);
    const RenderedTick felt = renderer->tick(probe, kTick_s);
    (void)device.push(felt.wrench, kTick_s);
    if (i < kSettling || std::abs(probe.velocity_m_per_s.x) < 0.059) continue;
    ++steady;
    if (felt.penetration_m == 0.0) ++lost;
  }
  return static_cast<double>(lost) / steady;
}

// 50 g and 10 N s/m across the surface.
TEST(ContactLoss, IsForetoldAsStrokesOnTheSimulatedDeviceHaveIt) {
  const PressedMass stroke{.damping_N_s_per_m = 10.0};
  EXPECT_EQ(lost_on({.stiffness_N_per_m = 500.0}, stroke), 0.0);
  EXPECT_EQ(lost_on({.amplitude_m = 5e-5, .stiffness_N_per_m = 5000.0}, stroke), 0.0);
  for (const double stiffness_N_per_m : {500.0, 2000.0, 5000.0}) {
    const PressedGrating grating{.stiffness_N_per_m = stiffness_N_per_m};
    EXPECT_NEAR(lost_on(grating, stroke), lost_in_strokes(grating), 0.05) << stiffness_N_per_m;
  }
  EXPECT_GT(lost_on({.stiffness_N_per_m = 2000.0}, stroke), 0.2);
}

TEST(ContactLoss, BeginsWhereTheSwingOfALinearMassReachesTheForceThatPressesIt) {
  for (const double stiffness_N_per_m : {500.0, 2000.0, 5000.0}) {
    const PressedGrating grating{.stiffness_N_per_m = stiffness_N_per_m};
    PressedMass stroke{.damping_N_s_per_m = 10.0};
    const double swing = swing_N(grating, stroke);
    stroke.force_N = 1.05 * swing;
    EXPECT_EQ(lost_on(grating, stroke), 0.0) << stiffness_N_per_m;
    stroke.force_N = 0.9 * swing;
    EXPECT_GT(lost_on(grating, stroke), 0.0) << stiffness_N_per_m;
  }
}

TEST(ContactLoss, IsNoneOnAPlateAndRefusesAMassOfNothing) {
  EXPECT_EQ(lost_on({.amplitude_m = 0.0, .stiffness_N_per_m = 5000.0}, {}), 0.0);
  EXPECT_NE(refusal_of<std::invalid_argument>([] {
              (void)lost_on({}, {.mass_kg = 0.0});
            }).find("mass_kg"),
            std::string::npos);
}

}  // namespace
}  // namespace asperity
