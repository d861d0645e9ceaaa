// Friction near rest against a device: B = μ·F/v₀ of every stimulus of a plan.

#include "app/session/rehearsal/friction_rehearsal.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>

#include "app/session/attempt_measures.h"
#include "protocols/design/json_pointer.h"
#include "protocols/file/json_document.h"
#include "protocols/plan/plan.h"
#include "renderers/offline/sampled_loop.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "stimuli/properties/parameter.h"

namespace asperity {
namespace {

constexpr double kAssumedMass_kg = 0.05;
/// What arithmetic may add to a limit that is just met.
constexpr double kJustMet = 1e-6;
constexpr const char* kFrictionSpeed = "friction_speed_m_per_s";

/// What a stimulus asks of the loop.
struct FrictionDamper {
  double friction = 0.0;  ///< μ
  double force_N = 0.0;
  double speed_m_per_s = 0.0;           ///< v₀
  double greatest_speed_m_per_s = 0.0;  ///< that the model accepts

  double damper_N_s_per_m() const noexcept { return friction * force_N / speed_m_per_s; }
};

/// To two digits, up for a least value and down for a greatest one: a remedy that is rounded the other way is none.
double two_digits_up(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return digit * std::ceil(value / digit - kJustMet);
}
double two_digits_down(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return digit * std::floor(value / digit + kJustMet);
}

std::optional<FrictionDamper> damper_of(const StimulusDescription& stimulus,
                                        const Exploration& exploration,
                                        const ModelRegistry& models) {
  const ForceModel* const model = models.find(stimulus.model);
  if (model == nullptr || !(stimulus.material.friction > 0.0)) return {};
  const std::vector<Parameter>& declared = model->declaration.parameters;
  const auto speed = std::find_if(declared.begin(), declared.end(),
                                  [](const Parameter& one) { return one.name == kFrictionSpeed; });
  if (speed == declared.end()) return {};
  const ParameterValues values = complete_values(model->declaration, stimulus.parameters);
  if (has_virtual_coupling(values)) return {};
  const double aimed_N = habits_for(exploration, stimulus.patch).normal_force_N;
  return FrictionDamper{.friction = stimulus.material.friction,
                        .force_N = exploration.normal_force_N.maximum.value_or(aimed_N),
                        .speed_m_per_s = number_of(values, kFrictionSpeed),
                        .greatest_speed_m_per_s = speed->maximum};
}

/// What the device's limit was computed from.
Phrase basis_of(const DampedResponse& device, double mass_kg, double delay_s) {
  const Phrase text =
      device.moving_mass_kg
          ? phrase("Rehearsal",
                   "This holds for a moving mass of %1 g and a velocity delayed by %2 ms.")
          : phrase("Rehearsal",
                   "This assumes a moving mass of %1 g, which was not measured, and a velocity "
                   "delayed by %2 ms.");
  return text.with(in_three_digits(1e3 * mass_kg), in_three_digits(1e3 * delay_s));
}

Phrase remedy_for(const FrictionDamper& asked, double steepest_N_s_per_m) {
  const double below_N = two_digits_down(steepest_N_s_per_m * asked.speed_m_per_s / asked.friction);
  const double raised_m_per_s = two_digits_up(asked.friction * asked.force_N / steepest_N_s_per_m);
  if (raised_m_per_s > asked.greatest_speed_m_per_s) {
    return phrase("Rehearsal",
                  "Limit the pressing force to %1 N, or lower the friction of the surface; no "
                  "friction_speed_m_per_s that the model accepts is high enough.")
        .with(in_three_digits(below_N));
  }
  return phrase("Rehearsal",
                "Set friction_speed_m_per_s to %1 or more, or limit the pressing force to %2 N.")
      .with(in_three_digits(raised_m_per_s), in_three_digits(below_N));
}

}  // namespace

std::vector<RehearsalWarning> friction_warnings(const Protocol& protocol,
                                                const ModelRegistry& models,
                                                const DampedResponse& device) {
  const double period_s = 1.0 / protocol.rate_Hz;
  const double mass_kg = device.moving_mass_kg.value_or(kAssumedMass_kg);
  const double delay_s =
      device.latency_s + (device.velocity ? device.velocity->lag_s(period_s) : 0.0);
  const double steepest_N_s_per_m = steepest_damper_N_s_per_m(mass_kg, delay_s, period_s);
  std::vector<RehearsalWarning> warnings{};
  std::set<std::tuple<std::string, double, double>> seen{};
  for (const Trial& trial : possible_trials(protocol)) {
    for (const PlannedPresentation& planned : trial.presentations) {
      const auto asked = damper_of(planned.stimulus, exploration_of(protocol, trial), models);
      if (!asked || asked->damper_N_s_per_m() <= (1.0 + kJustMet) * steepest_N_s_per_m) continue;
      if (!seen.emplace(planned.stimulus.name, asked->force_N, asked->damper_N_s_per_m()).second) {
        continue;
      }
      warnings.push_back(
          {.id = "friction_damping",
           .stimulus = planned.stimulus.name,
           .pointer = pointer_to("/stimuli", planned.stimulus_template),
           .asked = asked->damper_N_s_per_m(),
           .device = steepest_N_s_per_m,
           .text =
               phrase("Rehearsal",
                      "Near rest, the friction of \"%1\" acts as a damper of %2 N s/m at %3 N, and "
                      "at %4 Hz the device vibrates if the damping exceeds %5 N s/m: vibration is "
                      "expected where strokes reverse. %6 %7")
                   .with(planned.stimulus.name, in_three_digits(asked->damper_N_s_per_m()),
                         in_three_digits(asked->force_N), in_three_digits(protocol.rate_Hz),
                         in_three_digits(steepest_N_s_per_m), basis_of(device, mass_kg, delay_s),
                         remedy_for(*asked, steepest_N_s_per_m))});
    }
  }
  return warnings;
}

}  // namespace asperity
