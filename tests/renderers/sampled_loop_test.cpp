// Springs, dampers and friction in a sampled loop: the closed forms against the frequency condition, the simulated tool
// and the simulated devices.

#include "renderers/offline/sampled_loop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <deque>
#include <functional>
#include <numbers>
#include <ostream>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/signals/filters.h"
#include "device/simulated_device.h"
#include "device/simulated_models.h"
#include "renderers/models/sinusoid.h"
#include "renderers/pd_gradient/contact/coupled_tool.h"
#include "tests/renderers/surfaces.h"

namespace asperity {
namespace {

using Response = std::function<std::complex<double>(std::complex<double> z)>;

/// What [Colgate 1997] asks of the device at ω = `angle`/T.
double asked_at(double angle, std::complex<double> response) {
  const std::complex<double> z = std::polar(1.0, angle);
  return 0.5 * kTick_s / (1.0 - std::cos(angle)) * ((1.0 - 1.0 / z) * response).real();
}

double greatest_asked(const Response& response) {
  constexpr int kFrequencies = 2000;
  double greatest = 0.0;
  for (int i = 1; i <= kFrequencies; ++i) {
    const double angle = std::numbers::pi * i / kFrequencies;
    greatest = std::max(greatest, asked_at(angle, response(std::polar(1.0, angle))));
  }
  return greatest;
}

TEST(SampledLoop, AsksForTheDampingThatTheFrequencyConditionAsksFor) {
  for (const auto& [k, b] : {std::pair{1000.0, 0.0}, {1000.0, 1.0}, {500.0, 7.0}, {2000.0, -0.8}}) {
    const double greatest =
        greatest_asked([&](std::complex<double> z) { return k + b * (z - 1.0) / (kTick_s * z); });
    EXPECT_NEAR(passive_damping_N_s_per_m(k, b, kTick_s), greatest, 1e-3 * greatest)
        << k << " N/m, " << b << " N s/m";
  }
  EXPECT_DOUBLE_EQ(passive_damping_N_s_per_m(1000.0, 1.0, 1e-3), 1.5) << "the default coupling";
}

// With a low-pass of the readings, y += g(x − y), and a latency that is no multiple of the period.
TEST(SampledLoop, AsksForTheDampingOfADelayedSpringAsTheFrequencyConditionDoes) {
  for (const auto& [k, b, gain, latency_s] : {std::tuple{1000.0, 0.0, 1.0, 0.0},
                                              {120.0, 0.0, 0.33, 1e-3},
                                              {5000.0, 0.0, 0.33, 0.7e-3},
                                              {1000.0, 2.0, 1.0, 1.5e-3},
                                              {1000.0, 2.0, 0.5, 0.3e-3}}) {
    double greatest = 0.0;
    constexpr int kFrequencies = 2000;
    for (int i = 1; i <= kFrequencies; ++i) {
      const double angle = std::numbers::pi * i / kFrequencies;
      const std::complex<double> z = std::polar(1.0, angle);
      const std::complex<double> smoothed = gain / (1.0 - (1.0 - gain) / z);
      greatest =
          std::max(greatest, asked_at(angle, (k + b * (z - 1.0) / (kTick_s * z)) * smoothed *
                                                 std::polar(1.0, -angle * latency_s / kTick_s)));
    }
    const double lag_s = latency_s + kTick_s * (1.0 - gain) / gain;
    const double asked = delayed_damping_N_s_per_m(k, b, lag_s, kTick_s);
    EXPECT_GE(asked, greatest * (1.0 - 1e-3)) << k << ' ' << b << ' ' << latency_s;
    if (b == 0.0) {
      EXPECT_NEAR(asked, greatest, 1e-3 * greatest) << k << ' ' << latency_s;
    }
  }
}

/// What the coupling's force makes of a device that is moved sinusoidally, on a contact of that stiffness.
std::complex<double> coupling_response(double angle, double contact_N_per_m) {
  CoupledTool tool({.mass_kg = 0.002,
                    .inertia_kg_m2 = 1e-6,
                    .stiffness_N_per_m = 1000.0,
                    .damping_N_s_per_m = 1.0,
                    .angular_stiffness_N_m_per_rad = 0.3,
                    .angular_damping_N_m_s_per_rad = 5e-4});
  constexpr double kAmplitude_m = 1e-6;
  constexpr double kDeep_m = 1e-4;  // further in than it is moved: the contact never opens
  constexpr int kSettling = 4000;
  constexpr int kTicks = 4000;
  tool.reset({});
  std::complex<double> force_N = 0.0;
  std::complex<double> way_m = 0.0;
  double before_m = 0.0;
  for (int i = 0; i < kSettling + kTicks; ++i) {
    const double z_m = kAmplitude_m * std::cos(angle * i);
    const ProbeState device{.position_m = {0.0, 0.0, z_m},
                            .velocity_m_per_s = {0.0, 0.0, (z_m - before_m) / kTick_s}};
    before_m = z_m;
    const PenaltyContact contact{.stiffness_N_per_m = contact_N_per_m,
                                 .depth_m = kDeep_m - tool.pose().centre_m.z,
                                 .depth_per_m = {0.0, 0.0, -1.0}};
    const double pushed_N = tool.step(device, std::span(&contact, 1), kTick_s).force_N.z;
    if (i < kSettling) continue;
    force_N += pushed_N * std::polar(1.0, -angle * i);
    way_m += z_m * std::polar(1.0, -angle * i);
  }
  return -force_N / way_m;
}

// A tool of 2 g stands still at half the sampling rate, so a soft contact does not soften the coupling there.
TEST(SampledLoop, AsksForTheCouplingsOwnSpringAndDamperWhateverItsToolTouches) {
  const double bound = passive_damping_N_s_per_m(1000.0, 1.0, kTick_s);
  const double angle = 0.98 * std::numbers::pi;
  const auto asked = [&](double contact_N_per_m) {
    return asked_at(angle, coupling_response(angle, contact_N_per_m));
  };
  for (const double contact_N_per_m : {500.0, 5e3, 5e4, 1e9}) {
    EXPECT_LE(asked(contact_N_per_m), bound) << contact_N_per_m;
  }
  EXPECT_NEAR(asked(500.0), 1.11, 0.02);
  EXPECT_NEAR(asked(5e4), 1.43, 0.02);
  EXPECT_NEAR(asked(1e9), 1.5, 0.02);
  const double in_series_N_per_m = 500.0 * 1000.0 / 1500.0;
  EXPECT_GT(asked(500.0), 6.0 * passive_damping_N_s_per_m(in_series_N_per_m, 0.0, kTick_s))
      << "springs in series are no bound";
}

/// Whether m·(v₁ − v₀) = −B·T·v₋d grows.
bool grows(double damper_N_s_per_m, double mass_kg, std::size_t delay_ticks) {
  std::deque<double> past(delay_ticks + 1, 1.0);
  double early = 0.0;
  double late = 0.0;
  constexpr int kTicks = 20'000;
  for (int i = 0; i < kTicks; ++i) {
    past.push_front(past.front() - damper_N_s_per_m * kTick_s / mass_kg * past.back());
    past.pop_back();
    double& part = i < kTicks / 2 ? early : late;
    part = std::max(part, std::abs(past.front()));
  }
  return late > early;
}

TEST(SampledLoop, HoldsADamperUpToItsSteepestOne) {
  for (const std::size_t delay_ticks : {0U, 1U, 4U, 9U}) {
    const double delay_s = kTick_s * static_cast<double>(delay_ticks);
    const double steepest = steepest_damper_N_s_per_m(0.05, delay_s, kTick_s);
    EXPECT_FALSE(grows(0.99 * steepest, 0.05, delay_ticks)) << delay_ticks;
    EXPECT_TRUE(grows(1.01 * steepest, 0.05, delay_ticks)) << delay_ticks;
  }
  EXPECT_DOUBLE_EQ(steepest_damper_N_s_per_m(0.05, 0.0, 1e-3), 100.0) << "2m/T";
  const double late_s = 0.1;
  EXPECT_NEAR(steepest_damper_N_s_per_m(0.05, late_s, 1e-3),
              0.5 * std::numbers::pi * 0.05 / (late_s + 0.5e-3), 1e-3)
      << "(π/2)·m/(τ + T/2)";
}

/// Friction without a texture on a simulated device: whether strokes are clean or buzz.
struct FrictionCase {
  const char* device = "";
  double friction = 0.0;
  double force_N = 0.0;
  double speed_m_per_s = 0.010;
  bool buzzes = false;
  double stroke_m_per_s = 0.07;

  double damper_N_s_per_m() const { return friction * force_N / speed_m_per_s; }
  friend std::ostream& operator<<(std::ostream& out, const FrictionCase& one) {
    return out << one.device << ", μ " << one.friction << ", " << one.force_N << " N, v₀ "
               << one.speed_m_per_s << " m/s";
  }
};

/// Strokes at 70 mm/s, and slow ones, which stay below v₀. 100 N s/m on the simulated device, whose limit is 2m/T = 100,
/// is the last one that is clean.
constexpr std::array kFrictionCases{
    FrictionCase{"simulated", 0.2, 1.0},
    FrictionCase{"simulated", 0.5, 2.0},
    FrictionCase{"simulated", 0.8, 2.0, 0.010, true},
    FrictionCase{"simulated", 1.0, 3.0, 0.010, true},
    FrictionCase{"simulated", 0.3, 1.0, 0.001, true},
    FrictionCase{"simulated:falcon", 0.2, 1.0, 0.010, true},
    FrictionCase{"simulated:falcon", 0.5, 1.0, 0.010, true},
    FrictionCase{"simulated:falcon", 0.8, 1.0, 0.010, true},
    FrictionCase{"simulated:delta.3", 0.2, 1.0},
    FrictionCase{"simulated:delta.3", 0.2, 1.3, 0.010, false, 0.003},
    FrictionCase{"simulated:delta.3", 0.2, 2.5, 0.010, true, 0.003},
    FrictionCase{"simulated:delta.3", 0.8, 1.0, 0.010, true}};

/// Clean strokes stay below 0.01 N, the faintest buzz is above 0.06 N.
constexpr double kClean_N = 0.03;

/// The greatest force along the stroke above 30 Hz, of a surface without a texture.
double friction_vibration_N(const FrictionCase& one) {
  const SimulatedDeviceSettings settings = simulated_settings(one.device).value();
  VirtualHand hand({.speed_m_per_s = one.stroke_m_per_s, .normal_force_N = one.force_N}, Random(1));
  SimulatedDevice device(hand, settings);
  device.set_limits({.force_N = 10.0});
  hand.stroke();
  const auto renderer = make_renderer(
      sinusoid_model(), {.parameters = {{"amplitude_m", 0.0},
                                        {"friction_law", std::string("rounded")},
                                        {"friction_speed_m_per_s", one.speed_m_per_s}},
                         .material = {.friction = one.friction}});
  ButterworthFilter quick(HighPass{.order = 4, .cutoff_Hz = 30.0}, 1000.0);
  constexpr int kTicks = 20'000;
  constexpr int kSettling = 2000;
  double greatest_N = 0.0;
  for (int i = 1; i <= kTicks; ++i) {
    const ProbeState probe = device.read(i * 1'000'000LL).value();
    if (i == 1) renderer->reset(probe);
    const Wrench wrench = renderer->tick(probe, kTick_s).wrench;
    (void)device.push(wrench, kTick_s);
    const double passed_N = std::abs(quick.next(wrench.force_N.x));
    if (i > kSettling) greatest_N = std::max(greatest_N, passed_N);
  }
  return greatest_N;
}

TEST(SampledLoop, BuzzesOnTheFrictionThatIsTooSteepForASimulatedDevice) {
  for (const FrictionCase& one : kFrictionCases) {
    const SimulatedDeviceSettings settings = simulated_settings(one.device).value();
    const double delay_s =
        settings.sensor.latency_s +
        (settings.sensor.velocity ? settings.sensor.velocity->lag_s(kTick_s) : 0.0);
    const double steepest = steepest_damper_N_s_per_m(settings.hand.mass_kg, delay_s, kTick_s);
    const double vibration = friction_vibration_N(one);
    EXPECT_EQ(one.damper_N_s_per_m() > steepest, one.buzzes) << one << ", limit " << steepest;
    EXPECT_EQ(vibration > kClean_N, one.buzzes) << one << ", " << vibration << " N";
  }
}

}  // namespace
}  // namespace asperity
