// Compares the friction of stimuli near rest with the stability limit of a loop.

#include "app/session/rehearsal/friction_rehearsal.h"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "app/session/attempt_measures.h"
#include "protocols/design/json_pointer.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

/// What arithmetic may add to a limit that is just met.
constexpr double kJustMet = 1e-6;

/// To two digits, up for a least value and down for a greatest one, so that the rounded remedy still works.
double two_digits_up(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return digit * std::ceil(value / digit - kJustMet);
}
double two_digits_down(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return digit * std::floor(value / digit + kJustMet);
}

std::optional<FrictionDamper> damper_of(const StimulusDescription& stimulus,
                                        const Exploration& exploration, const ModelRegistry& models,
                                        UnstatedFriction friction) {
  const ForceModel* const model = models.find(stimulus.model);
  if (model == nullptr) return {};
  const double aimed_N = habits_for(exploration, stimulus.patch).normal_force_N;
  StimulusDescription stated = stimulus;
  stated.parameters.merge(values_of(friction, *model));
  return friction_damper_of(*model, stated, exploration.normal_force_N.maximum.value_or(aimed_N));
}

/// The values from which the device's limit was computed.
Phrase basis_of(const DampedResponse& device, double period_s) {
  const Phrase text =
      device.moving_mass_kg
          ? phrase("Rehearsal",
                   "This holds for a moving mass of %1 g and a velocity delayed by %2 ms.")
          : phrase("Rehearsal",
                   "This assumes a moving mass of %1 g, which was not measured, and a velocity "
                   "delayed by %2 ms.");
  return text.with(in_three_digits(1e3 * device.mass_kg()),
                   in_three_digits(1e3 * device.delay_s(period_s)));
}

Phrase remedy_for(const FrictionDamper& asked, double steepest_N_s_per_m) {
  const double below_N = two_digits_down(asked.force_with_N(steepest_N_s_per_m));
  const double raised_m_per_s = two_digits_up(asked.speed_with_m_per_s(steepest_N_s_per_m));
  if (raised_m_per_s > asked.greatest_speed_m_per_s) {
    return phrase("Rehearsal",
                  "Limit the pressing force to %1 N, or lower the friction of the surface; even "
                  "the greatest possible friction_speed_m_per_s is too low.")
        .with(in_three_digits(below_N));
  }
  return phrase("Rehearsal",
                "Set friction_speed_m_per_s to %1 or more, or limit the pressing force to %2 N.")
      .with(in_three_digits(raised_m_per_s), in_three_digits(below_N));
}

}  // namespace

std::vector<RehearsalWarning> friction_warnings(const Protocol& protocol,
                                                const ModelRegistry& models,
                                                const DampedResponse& device,
                                                UnstatedFriction friction) {
  const double period_s = 1.0 / protocol.rate_Hz;
  const double steepest_N_s_per_m = steepest_damper_N_s_per_m(device, period_s);
  std::vector<RehearsalWarning> warnings{};
  std::set<std::tuple<std::string, double, double>> seen{};
  for (const Trial& trial : possible_trials(protocol)) {
    for (const PlannedPresentation& planned : trial.presentations) {
      const auto asked =
          damper_of(planned.stimulus, exploration_of(protocol, trial), models, friction);
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
                         in_three_digits(steepest_N_s_per_m), basis_of(device, period_s),
                         remedy_for(*asked, steepest_N_s_per_m))});
    }
  }
  return warnings;
}

}  // namespace asperity
