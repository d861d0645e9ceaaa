// Compares what the friction of stimuli requires near rest with the properties of a device.

#include "app/session/rehearsal/friction_rehearsal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "app/session/attempt_measures.h"
#include "app/session/explored_stimuli.h"
#include "app/session/rehearsal/warned_levels.h"
#include "device/drivers.h"
#include "protocols/design/json_pointer.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

/// What arithmetic may add to a limit that is just met.
constexpr double kJustMet = 1e-6;
/// The least that the models accept as friction_stiffness_N_per_m.
constexpr double kSoftest_N_per_m = 10.0;

std::string in_ms(double time_s) { return in_three_digits(1e3 * time_s); }

std::optional<PressedFriction> friction_of(const StimulusDescription& stimulus,
                                           const Exploration& exploration,
                                           const ModelRegistry& models) {
  const ForceModel* const model = models.find(stimulus.model);
  if (model == nullptr) return {};
  const double aimed_N = habits_for(exploration, stimulus.patch).normal_force_N;
  return pressed_friction_of(*model, stimulus,
                             exploration.normal_force_N.maximum.value_or(aimed_N));
}

/// The values from which the device's limit for dampers was computed.
Phrase basis_of(const DampedResponse& device, double period_s) {
  const Phrase text =
      device.moving_mass_kg
          ? phrase("Rehearsal",
                   "This holds for a moving mass of %1 g and a velocity delayed by %2 ms.")
          : phrase("Rehearsal",
                   "This assumes a moving mass of %1 g, which was not measured, and a velocity "
                   "delayed by %2 ms.");
  return text.with(in_three_digits(1e3 * device.mass_kg()), in_ms(device.delay_s(period_s)));
}

Phrase remedy_for_speed(const PressedFriction& asked, double steepest_N_s_per_m) {
  const double below_N = two_digits_down(asked.force_with_N(steepest_N_s_per_m));
  const double raised_m_per_s = two_digits_up(asked.speed_with_m_per_s(steepest_N_s_per_m));
  if (raised_m_per_s > asked.greatest_speed_m_per_s) {
    return phrase("Rehearsal",
                  "Limit the normal force to %1 N, or lower the friction of the surface; even the "
                  "greatest possible friction_speed_m_per_s is too low.")
        .with(in_three_digits(below_N));
  }
  return phrase("Rehearsal",
                "Set friction_speed_m_per_s to %1 or more, or limit the normal force to %2 N.")
      .with(in_three_digits(raised_m_per_s), in_three_digits(below_N));
}

/// Of a law that limits its slope itself, for the mass and the delay that it assumes.
Phrase remedy_for_mass(const DampedResponse& device, double period_s) {
  return phrase("Rehearsal",
                "Set friction_mass_kg to %1 or less and friction_delay_s to %2 or more.")
      .with(in_three_digits(two_digits_down(device.mass_kg())),
            in_three_digits(device.delay_s(period_s) > 0.0 ? two_digits_up(device.delay_s(period_s))
                                                           : 0.0));
}

bool limits_its_slope(const FrictionLaw& law) {
  return std::find(law.parameters.begin(), law.parameters.end(), "friction_mass_kg") !=
         law.parameters.end();
}

/// A loop of the protocol's rate on a device.
struct FrictionLoop {
  const DampedResponse& device;
  double rate_Hz = 0.0;
  double period_s() const noexcept { return 1.0 / rate_Hz; }
};

std::optional<RehearsalWarning> damper_warning(const std::string& name,
                                               const PressedFriction& asked,
                                               const FrictionLoop& loop) {
  const double damper_N_s_per_m = asked.near_rest(loop.period_s()).damper_N_s_per_m;
  const double steepest_N_s_per_m = steepest_damper_N_s_per_m(loop.device, loop.period_s());
  if (damper_N_s_per_m <= (1.0 + kJustMet) * steepest_N_s_per_m) return {};
  return RehearsalWarning{
      .id = "friction_damping",
      .asked = damper_N_s_per_m,
      .device = steepest_N_s_per_m,
      .text =
          phrase("Rehearsal",
                 "Near rest, the friction of \"%1\" acts as a damper of %2 N s/m at a normal force "
                 "of %3 N. At %4 Hz the device vibrates if the damping exceeds %5 N s/m: vibration "
                 "is expected where strokes reverse. %6 %7")
              .with(name, in_three_digits(damper_N_s_per_m), in_three_digits(asked.force_N),
                    in_three_digits(loop.rate_Hz), in_three_digits(steepest_N_s_per_m),
                    basis_of(loop.device, loop.period_s()),
                    limits_its_slope(*asked.law) ? remedy_for_mass(loop.device, loop.period_s())
                                                 : remedy_for_speed(asked, steepest_N_s_per_m))};
}

Phrase remedy_for_stiffness(const FrictionNearRest& asked, const FrictionLoop& loop) {
  const double stiffest_N_per_m = stiffest_contact_N_per_m(asked, loop.device, loop.period_s());
  if (stiffest_N_per_m >= kSoftest_N_per_m) {
    return phrase("Rehearsal", "Set friction_stiffness_N_per_m to %1 or less.")
        .with(in_three_digits(two_digits_down(stiffest_N_per_m)));
  }
  if (asked.contact_damper_N_s_per_m > 0.0) {
    return phrase("Rehearsal",
                  "Lower friction_damping_N_s_per_m and friction_stiffness_N_per_m, or choose a "
                  "device with more damping.");
  }
  return phrase("Rehearsal",
                "Lower friction_smoothing_s and friction_stiffness_N_per_m, choose another "
                "friction_law, or choose a device with more damping.");
}

std::optional<RehearsalWarning> spring_warning(const std::string& name,
                                               const FrictionNearRest& asked,
                                               const FrictionLoop& loop) {
  const double required_N_s_per_m = required_damping_N_s_per_m(asked, loop.device, loop.period_s());
  const double damping_N_s_per_m = *loop.device.damping_N_s_per_m;
  if (required_N_s_per_m <= (1.0 + kJustMet) * damping_N_s_per_m) return {};
  return RehearsalWarning{
      .id = "friction_stiffness",
      .asked = required_N_s_per_m,
      .device = damping_N_s_per_m,
      .text = phrase("Rehearsal",
                     "Near rest, the friction of \"%1\" acts as a spring of %2 N/m whose force is "
                     "delayed by %3 ms. At %4 Hz this requires a damping of %5 N s/m, but the "
                     "damping of the device along the surface is %6 N s/m: vibration is expected "
                     "where the hand rests or reverses, unless the hand adds the difference. %7")
                  .with(name, in_three_digits(asked.stiffness_N_per_m),
                        in_ms(loop.device.latency_s + asked.lag_s), in_three_digits(loop.rate_Hz),
                        in_three_digits(required_N_s_per_m), in_three_digits(damping_N_s_per_m),
                        remedy_for_stiffness(asked, loop))};
}

RehearsalWarning unknown_damping(const std::string& stimulus_template, double required_N_s_per_m,
                                 const FrictionLoop& loop) {
  return {
      .id = "friction_not_compared",
      .stimulus = stimulus_template,
      .pointer = pointer_to("/stimuli", stimulus_template),
      .asked = required_N_s_per_m,
      .text =
          phrase(
              "Rehearsal",
              "The friction of \"%1\" was not compared with the device. Near rest, it acts as a "
              "spring that requires a damping of %3 N s/m at %2 Hz, and the damping of the device "
              "is unknown. Measure the device, or state damping_N_s_per_m for a simulated device.")
              .with(stimulus_template, in_three_digits(loop.rate_Hz),
                    in_three_digits(required_N_s_per_m))};
}

}  // namespace

FrictionRehearsal rehearse_friction(const Protocol& protocol, const ModelRegistry& models,
                                    const DampedResponse& device) {
  const FrictionLoop loop{.device = device, .rate_Hz = protocol.rate_Hz};
  FrictionRehearsal found{};
  std::map<std::string, double> required_N_s_per_m{};  // by template, where the damping is unknown
  std::set<std::tuple<std::string, std::string, double, double>> seen{};
  for_each_stimulus(protocol, possible_trials(protocol), {}, [&](const ExploredStimulus& one) {
    const std::string& name = one.planned.stimulus.name;
    const auto asked = friction_of(one.planned.stimulus, one.exploration, models);
    if (!asked) return;
    const FrictionNearRest near_rest = asked->near_rest(loop.period_s());
    const auto add = [&](std::optional<RehearsalWarning> warning) {
      found.has_compared = true;
      if (!warning || !seen.emplace(warning->id, name, asked->force_N, warning->asked).second) {
        return;
      }
      warning->stimulus = name;
      warning->pointer = pointer_to("/stimuli", one.planned.stimulus_template);
      warning->level = level_of(protocol, one.trial, one.planned);
      found.warnings.push_back(std::move(*warning));
    };
    if (near_rest.damper_N_s_per_m > 0.0) add(damper_warning(name, *asked, loop));
    if (!(near_rest.stiffness_N_per_m > 0.0)) return;
    if (device.damping_N_s_per_m) {
      add(spring_warning(name, near_rest, loop));
    } else {
      double& greatest_N_s_per_m = required_N_s_per_m[one.planned.stimulus_template];
      greatest_N_s_per_m = std::max(greatest_N_s_per_m,
                                    required_damping_N_s_per_m(near_rest, device, loop.period_s()));
    }
  });
  for (const auto& [stimulus_template, required] : required_N_s_per_m) {
    found.not_compared.push_back(unknown_damping(stimulus_template, required, loop));
  }
  found.warnings = one_for_alike(std::move(found.warnings), protocol);
  return found;
}

DampedResponse damped_response_of(const DeviceProfile& profile) {
  DampedResponse response{.moving_mass_kg = profile.value("moving_mass_kg"),
                          .damping_N_s_per_m = profile.value("damping_N_s_per_m"),
                          .latency_s = profile.value("latency_s").value_or(0.0),
                          .velocity = velocity_window_of(profile.name, profile.model)};
  const DeviceItem* const damping = profile.item("damping_N_s_per_m");
  if (response.damping_N_s_per_m && damping->by_axis.size() > 1) {
    response.damping_N_s_per_m = std::min(damping->by_axis[0], damping->by_axis[1]);
  }
  return response;
}

}  // namespace asperity
