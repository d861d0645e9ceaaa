// Implements what friction near rest requires of a device.

#include "renderers/offline/friction_near_rest.h"

#include <algorithm>
#include <vector>

#include "renderers/offline/sampled_loop.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"

namespace asperity {
namespace {

constexpr const char* kFrictionSpeed = "friction_speed_m_per_s";

}  // namespace

std::optional<PressedFriction> pressed_friction_of(const ForceModel& model,
                                                   const StimulusDescription& stimulus,
                                                   double force_N) {
  if (!(stimulus.material.friction > 0.0)) return {};
  const std::vector<Parameter>& declared = model.declaration.parameters;
  const auto speed = std::find_if(declared.begin(), declared.end(),
                                  [](const Parameter& one) { return one.name == kFrictionSpeed; });
  if (speed == declared.end()) return {};
  const ParameterValues values = complete_values(model.declaration, stimulus.parameters);
  if (has_virtual_coupling(values)) return {};
  return PressedFriction{.law = &friction_law_of(values),
                         .settings = friction_settings(stimulus.material.friction, values),
                         .force_N = force_N,
                         .greatest_speed_m_per_s = speed->maximum};
}

double DampedResponse::delay_s(double period_s) const noexcept {
  return latency_s + (velocity ? velocity->lag_s(period_s) : 0.0);
}

double steepest_damper_N_s_per_m(const DampedResponse& device, double period_s) noexcept {
  return steepest_damper_N_s_per_m(device.mass_kg(), device.delay_s(period_s), period_s);
}

double required_damping_N_s_per_m(const FrictionNearRest& friction, const DampedResponse& device,
                                  double period_s) noexcept {
  return delayed_damping_N_s_per_m(friction.stiffness_N_per_m, friction.contact_damper_N_s_per_m,
                                   device.latency_s + friction.lag_s, period_s);
}

double stiffest_contact_N_per_m(const FrictionNearRest& friction, const DampedResponse& device,
                                double period_s) noexcept {
  FrictionNearRest of_damper = friction;
  of_damper.stiffness_N_per_m = 0.0;
  FrictionNearRest of_1_N_per_m{.stiffness_N_per_m = 1.0, .lag_s = friction.lag_s};
  return (device.damping_N_s_per_m.value_or(0.0) -
          required_damping_N_s_per_m(of_damper, device, period_s)) /
         required_damping_N_s_per_m(of_1_N_per_m, device, period_s);
}

}  // namespace asperity
