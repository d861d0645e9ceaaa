// What each law of friction keeps of Coulomb friction, and the vibration that it causes under a stroking hand, on simulated
// devices.

#include "renderers/force/friction.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/random.h"
#include "bench/evidence/evidence.h"
#include "device/simulated_models.h"
#include "renderers/models/sinusoid.h"
#include "renderers/models/stochastic.h"
#include "renderers/offline/friction_stroke.h"
#include "renderers/offline/sliding_drag.h"

namespace asperity {
namespace {

constexpr std::array kDevices{"simulated", "simulated:falcon", "simulated:delta.3"};

// The strokes of the library's protocols with models that touch with a point, and some around them.
struct Setting {
  double friction = 0.2;
  double force_N = 1.0;
  double speed_m_per_s = 0.06;
  double stiffness_N_per_m = 500.0;
};

constexpr std::array kSettings{Setting{},
                               Setting{.force_N = 0.5},
                               Setting{.force_N = 2.0},
                               Setting{.speed_m_per_s = 0.03},
                               Setting{.speed_m_per_s = 0.1},
                               Setting{.force_N = 0.5, .speed_m_per_s = 0.1},
                               Setting{.speed_m_per_s = 0.15},
                               Setting{.friction = 0.5},
                               Setting{.friction = 0.8},
                               Setting{.stiffness_N_per_m = 3000.0}};

// Of the hand and the arm along the surface: a firm grip (the simulated devices' own), and down to an arm alone.
constexpr std::array kDampings_N_s_per_m{5.0, 1.0, 0.3, 0.1};

std::string with_damping(const char* device, double damping_N_s_per_m) {
  const std::string name(device);
  return name + (name.find(':') == std::string::npos ? ":ideal" : "") +
         ",damping_N_s_per_m=" + std::to_string(damping_N_s_per_m);
}

StrokeVibration vibration_of(const FrictionLaw& law, const std::string& device,
                             const Setting& setting) {
  return stroke_vibration(
      sinusoid_model(),
      {.parameters = {{"amplitude_m", 1e-6}, {"friction_law", std::string(law.name)}},
       .material = {.stiffness_N_per_m = setting.stiffness_N_per_m, .friction = setting.friction}},
      {.device = simulated_settings(device).value(),
       .hand = {.speed_m_per_s = setting.speed_m_per_s, .normal_force_N = setting.force_N}});
}

void print_header(double damping_N_s_per_m) {
  std::printf(
      "force along the surface from 30 Hz: greatest at reversals / RMS in steady parts, mN\n"
      "damping along the surface %.1f N s/m\n%-14s %4s %5s %6s %6s",
      damping_N_s_per_m, "law", "mu", "F_n N", "v mm/s", "k N/m");
  for (const char* device : kDevices) std::printf(" %18s", device);
  std::printf("\n");
}

SlidingDrag drag_of(const FrictionLaw& law, const ForceModel& model, ParameterValues parameters,
                    double stiffness_N_per_m) {
  parameters["friction_law"] = std::string(law.name);
  return sliding_drag(model,
                      {.parameters = parameters,
                       .material = {.stiffness_N_per_m = stiffness_N_per_m, .friction = 0.2}});
}

SlidingDrag drag_under_noise(const FrictionLaw& law) {
  return drag_of(law, stochastic_model(), {{"noise_sd_N", 0.1}}, 500.0);
}

/// The least of some gratings, over Coulomb's.
struct LeastDrag {
  double mean = 1.0;
  double modulation = 1.0;
};

LeastDrag least_drag_on_gratings(const FrictionLaw& law) {
  const ParameterValues fine{{"amplitude_m", 5e-5}, {"wavelength_m", 2.5e-3}};
  const ParameterValues coarse{{"amplitude_m", 2e-4}, {"wavelength_m", 4e-3}};
  LeastDrag least{};
  for (const SlidingDrag& drag :
       {drag_of(law, sinusoid_model(), fine, 500.0), drag_of(law, sinusoid_model(), coarse, 500.0),
        drag_of(law, sinusoid_model(), coarse, 2000.0)}) {
    least.mean = std::min(least.mean, drag.mean_N / drag.coulomb_N);
    least.modulation = std::min(least.modulation, drag.modulation);
  }
  return least;
}

double greatest_burst_N(const FrictionLaw& law, const char* device, double slowest_m_per_s,
                        double fastest_m_per_s) {
  double greatest_N = 0.0;
  for (const Setting& setting : kSettings) {
    if (setting.friction > 0.2 || setting.stiffness_N_per_m > 500.0) continue;
    if (setting.speed_m_per_s < slowest_m_per_s || setting.speed_m_per_s > fastest_m_per_s) {
      continue;
    }
    greatest_N = std::max(greatest_N, vibration_of(law, device, setting).burst_N);
  }
  return greatest_N;
}

Friction friction_of(const FrictionLaw& law, double smoothing_s) {
  std::vector<Parameter> declared{};
  add_friction_parameters(declared);
  return {0.2, complete_values("friction", declared,
                               {{"friction_law", std::string(law.name)},
                                {"friction_smoothing_s", smoothing_s}})};
}

// The least work, since its beginning, of a hand on random paths in the plane: noise of 3 Hz, with a mean speed of about 60
// mm/s, at 1 N, with the force held for a period.
double least_work_J(const FrictionLaw& law, double smoothing_s) {
  constexpr double kPeriod_s = 1e-3;
  constexpr double kGain = 2.0 * std::numbers::pi * 3.0 * kPeriod_s;
  constexpr double kSpeed_m_per_s = 0.75;  // before two low-passes
  double least_J = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    Friction friction = friction_of(law, smoothing_s);
    glm::dvec2 place_m{0.0};
    glm::dvec2 halfway_m_per_s{0.0};
    glm::dvec2 velocity_m_per_s{0.0};
    double work_J = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      halfway_m_per_s +=
          kGain * (kSpeed_m_per_s * glm::dvec2(random.normal(), random.normal()) - halfway_m_per_s);
      velocity_m_per_s += kGain * (halfway_m_per_s - velocity_m_per_s);
      const glm::dvec2 drag_N = friction.drag_N({.position_m = place_m,
                                                 .velocity_m_per_s = velocity_m_per_s,
                                                 .normal_N = 1.0,
                                                 .dt_s = kPeriod_s});
      work_J += kPeriod_s * glm::dot(drag_N, velocity_m_per_s);
      least_J = std::min(least_J, work_J);
      place_m += kPeriod_s * velocity_m_per_s;
    }
  }
  return least_J;
}

// What 1000 cycles of ±20 µm leave of the force of a contact that was strained by 80 µm (10 mN with σ).
double left_after_tremor(const FrictionLaw& law) {
  Friction friction = friction_of(law, 0.0);
  const auto drag_N = [&friction](double place_m) {
    return friction.drag_N({.position_m = {place_m, 0.0}, .normal_N = 1.0, .dt_s = 1e-3}).x;
  };
  drag_N(0.0);
  const double before_N = drag_N(8e-5);
  if (!(before_N > 0.0)) return 0.0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    drag_N(1e-4);
    drag_N(6e-5);
  }
  return drag_N(8e-5) / before_N;
}

void print_properties() {
  constexpr double kSlow_m_per_s = 0.06;
  constexpr double kFast_m_per_s = 0.1;
  std::printf(
      "mean drag and its modulation by gratings and by noise, %% of Coulomb's; reversals up to 60 "
      "mm/s and at 100 mm/s, mN; work without and with the low-passes, mJ; force that tremor "
      "leaves, %%\n%-14s %13s %13s %17s %17s %19s %6s\n",
      "law", "gratings", "noise", "simulated", "falcon", "work", "held");
  for (const FrictionLaw& law : friction_laws()) {
    const LeastDrag gratings = least_drag_on_gratings(law);
    const SlidingDrag noise = drag_under_noise(law);
    std::printf("%-14s %5.1f / %5.1f %5.1f / %5.1f", std::string(law.name).c_str(),
                1e2 * gratings.mean, 1e2 * gratings.modulation,
                1e2 * noise.mean_N / noise.coulomb_N, 1e2 * noise.modulation);
    for (const char* device : {kDevices[0], kDevices[1]}) {
      std::printf(" %7.1f / %7.1f", 1e3 * greatest_burst_N(law, device, 0.0, kSlow_m_per_s),
                  1e3 * greatest_burst_N(law, device, kFast_m_per_s, kFast_m_per_s));
    }
    std::printf(" %8.4f / %8.4f %6.0f\n", 1e3 * least_work_J(law, 0.0),
                1e3 * least_work_J(law, FrictionSettings{}.smoothing_s),
                1e2 * left_after_tremor(law));
  }
}

}  // namespace

void print_friction() {
  print_properties();
  for (const double damping_N_s_per_m : kDampings_N_s_per_m) {
    print_header(damping_N_s_per_m);
    for (const Setting& setting : kSettings) {
      for (const FrictionLaw& law : friction_laws()) {
        std::printf("%-14s %4.1f %5.1f %6.0f %6.0f", std::string(law.name).c_str(),
                    setting.friction, setting.force_N, 1e3 * setting.speed_m_per_s,
                    setting.stiffness_N_per_m);
        for (const char* device : kDevices) {
          const StrokeVibration found =
              vibration_of(law, with_damping(device, damping_N_s_per_m), setting);
          std::printf(" %10.2f / %5.2f", 1e3 * found.burst_N, 1e3 * found.steady_rms_N);
        }
        std::printf("\n");
      }
    }
  }
}

}  // namespace asperity
