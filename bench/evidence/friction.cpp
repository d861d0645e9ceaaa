// The vibration that each law of friction causes under a stroking hand, on simulated devices.

#include "renderers/force/friction.h"

#include <array>
#include <cstdio>
#include <string>

#include "bench/evidence/evidence.h"
#include "device/simulated_models.h"
#include "renderers/models/sinusoid.h"
#include "renderers/offline/friction_stroke.h"

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
      "damping along the surface %.1f N s/m\n%-10s %4s %5s %6s %6s",
      damping_N_s_per_m, "law", "mu", "F_n N", "v mm/s", "k N/m");
  for (const char* device : kDevices) std::printf(" %18s", device);
  std::printf("\n");
}

}  // namespace

void print_friction() {
  for (const double damping_N_s_per_m : kDampings_N_s_per_m) {
    print_header(damping_N_s_per_m);
    for (const Setting& setting : kSettings) {
      for (const FrictionLaw& law : friction_laws()) {
        std::printf("%-10s %4.1f %5.1f %6.0f %6.0f", std::string(law.name).c_str(),
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
