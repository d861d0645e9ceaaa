// Implements friction near rest as a damper.

#include "renderers/offline/friction_damper.h"

#include <algorithm>
#include <vector>

#include "renderers/force/friction.h"
#include "renderers/offline/sampled_loop.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"

namespace asperity {
namespace {

constexpr const char* kFrictionSpeed = "friction_speed_m_per_s";

}  // namespace

std::optional<FrictionDamper> friction_damper_of(const ForceModel& model,
                                                 const StimulusDescription& stimulus,
                                                 double force_N) {
  if (!(stimulus.material.friction > 0.0)) return {};
  const std::vector<Parameter>& declared = model.declaration.parameters;
  const auto speed = std::find_if(declared.begin(), declared.end(),
                                  [](const Parameter& one) { return one.name == kFrictionSpeed; });
  if (speed == declared.end()) return {};
  const ParameterValues values = complete_values(model.declaration, stimulus.parameters);
  if (has_virtual_coupling(values)) return {};
  if (&friction_law_of(values) != &friction_law("rounded")) return {};
  return FrictionDamper{.friction = stimulus.material.friction,
                        .force_N = force_N,
                        .speed_m_per_s = number_of(values, kFrictionSpeed),
                        .greatest_speed_m_per_s = speed->maximum};
}

double DampedResponse::delay_s(double period_s) const noexcept {
  return latency_s + (velocity ? velocity->lag_s(period_s) : 0.0);
}

double steepest_damper_N_s_per_m(const DampedResponse& device, double period_s) noexcept {
  return steepest_damper_N_s_per_m(device.mass_kg(), device.delay_s(period_s), period_s);
}

}  // namespace asperity
