// Compares one stimulus with the profile of a device.

#include "app/session/rehearsal/stimulus_rehearsal.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "app/session/attempt_measures.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/json_pointer.h"
#include "renderers/offline/contact_loss.h"
#include "renderers/offline/felt_stiffness.h"
#include "renderers/offline/force_matching.h"
#include "renderers/offline/sampled_loop.h"

namespace asperity {
namespace {

/// The stiffest spring that `device-test` tries.
constexpr double kStiffestTried_N_per_m = 8000.0;
/// Of a stroke: a stimulus that loses contact for less is still felt as a surface.
constexpr double kContactMayBeLost = 0.05;
/// In place of a damping of 0, which the simulated mass refuses: without effect on a stroke.
constexpr double kSomeDamping_N_s_per_m = 1e-3;
/// A force below this is what the arithmetic leaves of a stimulus without texture.
constexpr double kNoForce_N = 1e-9;
/// Of a limit: Nearness::far.
constexpr double kFar = 0.5;

std::string in_um(double value_m) { return in_three_digits(1e6 * value_m); }

double fastest_m_per_s(const Exploration& exploration, const HandHabits& habits) {
  return exploration.speed_m_per_s.maximum.value_or(habits.speed_m_per_s);
}

}  // namespace

std::vector<RehearsalWarning> StimulusRehearsal::compare(const PlannedPresentation& planned,
                                                         const Exploration& exploration) {
  const StimulusDescription& stimulus = planned.stimulus;
  name_ = stimulus.name;
  pointer_ = pointer_to("/stimuli", planned.stimulus_template);
  nearness_ = Nearness::far;
  check_workspace(stimulus.patch);
  try {
    if (stimulus.surface && stimulus.tool) {
      compare_bodies(planned, exploration);
    } else {
      compare_point(planned, exploration);
    }
  } catch (const std::exception& error) {
    warn({.id = "not_rehearsed",
          .text = phrase("Rehearsal", "\"%1\" cannot be compared with the device: %2")
                      .with(name_, phrase_of(error))
                      .as_sentence()});
  }
  return std::exchange(warnings_, {});
}

void StimulusRehearsal::warn(RehearsalWarning warning) {
  nearness_ = Nearness::near;
  warning.stimulus = name_;
  warning.pointer = pointer_;
  warnings_.push_back(std::move(warning));
}

void StimulusRehearsal::compare_point(const PlannedPresentation& planned,
                                      const Exploration& exploration) {
  PreparedStimulus stimulus = builder_.unmatched(planned.stimulus);
  stimulus.inputs.body.reset();  // the texture is compared on a plane
  const HandHabits habits = habits_for(exploration, planned.stimulus.patch);
  if (force_is_compared()) {
    check_force(texture_force_N(planned, stimulus,
                                {.speed_m_per_s = habits.speed_m_per_s,
                                 .rate_Hz = protocol_.rate_Hz,
                                 .mean_normal_force_N = habits.normal_force_N}));
  }
  check_waves(texture_waves(*stimulus.model, stimulus.inputs, builder_.models()),
              fastest_m_per_s(exploration, habits));
  if (const std::optional<double> holds = holds_N_per_m()) {
    check_stiffness(felt_stiffness(*stimulus.model, stimulus.inputs,
                                   {.force_limit_N = protocol_.force_limit_N}),
                    *holds, 0.0);
  }
  check_contact(stimulus, habits);
}

void StimulusRehearsal::compare_bodies(const PlannedPresentation& planned,
                                       const Exploration& exploration) {
  const HandHabits habits = habits_for(exploration, planned.stimulus.patch);
  const BodiesAsRelief relief =
      bodies_as_relief(builder_.unmatched(planned.stimulus).inputs,
                       {.length_m = habits.stroke_length_m, .direction_rad = habits.direction_rad},
                       builder_.models());
  if (relief.coupling) {
    check_coupling(*relief.coupling);
  } else if (const std::optional<double> holds = holds_N_per_m()) {
    check_stiffness(felt_stiffness(relief, protocol_.force_limit_N), *holds,
                    relief.contact_damping_N_s_per_m);
  }
  if (!relief.waves.wavelength_m) return;  // neither has a texture that could be lost
  if (force_is_compared()) {
    const bool is_given = planned.equal_force && planned.equal_force->rms_N;
    check_force(is_given
                    ? *planned.equal_force->rms_N
                    : texture_force_rms_N(relief, {.speed_m_per_s = habits.speed_m_per_s,
                                                   .rate_Hz = protocol_.rate_Hz,
                                                   .mean_normal_force_N = habits.normal_force_N}));
  }
  check_waves(relief.waves, fastest_m_per_s(exploration, habits));
}

double StimulusRehearsal::texture_force_N(const PlannedPresentation& planned,
                                          const PreparedStimulus& stimulus,
                                          const TextureForcePath& path) {
  if (!planned.equal_force) return texture_force_rms_N(*stimulus.model, stimulus.inputs, path);
  // The force of a texture is nearly proportional to its amplitude.
  const double relative = planned.stimulus.relative_amplitude.value_or(1.0);
  if (planned.equal_force->rms_N) return relative * *planned.equal_force->rms_N;
  StimulusDescription reference = planned.stimulus;
  reference.relative_amplitude.reset();
  reference.model = planned.equal_force->to_model;
  reference.parameters.clear();
  const PreparedStimulus other = builder_.unmatched(reference);
  return relative * texture_force_rms_N(*other.model, other.inputs, path);
}

bool StimulusRehearsal::force_is_compared() const {
  return profile_.value("friction_N") || profile_.value("force_resolution_N");
}

void StimulusRehearsal::check_force(double texture_force_N) {
  if (texture_force_N < kNoForce_N) return;
  const std::optional<double> friction_N = profile_.value("friction_N");
  const std::optional<double> resolution_N = profile_.value("force_resolution_N");
  note_if_near(kFar * texture_force_N <
               std::max(friction_N.value_or(0.0), resolution_N.value_or(0.0)));
  if (friction_N && texture_force_N < *friction_N) {
    warn(
        {.id = "friction",
         .asked = texture_force_N,
         .device = *friction_N,
         .text = phrase("Rehearsal",
                        "The texture of \"%1\" corresponds to a force of %2 N RMS, and the "
                        "device's own friction is %3 N, which masks the texture. Raise the "
                        "amplitude of the texture, or choose a device with less friction.")
                     .with(name_, in_three_digits(texture_force_N), in_three_digits(*friction_N))});
  } else if (resolution_N && texture_force_N < *resolution_N) {
    warn({.id = "force_resolution",
          .asked = texture_force_N,
          .device = *resolution_N,
          .text =
              phrase("Rehearsal",
                     "The texture of \"%1\" corresponds to a force of %2 N RMS, and the "
                     "smallest force that moves the device is %3 N. Raise the amplitude of the "
                     "texture, or choose a device with a finer force resolution.")
                  .with(name_, in_three_digits(texture_force_N), in_three_digits(*resolution_N))});
  }
}

void StimulusRehearsal::check_waves(const TextureWaves& waves, double speed_m_per_s) {
  const std::optional<double> resolution_m = profile_.value("position_resolution_m");
  note_if_near(resolution_m && waves.amplitude_m && kFar * *waves.amplitude_m < *resolution_m);
  if (resolution_m && waves.amplitude_m && *waves.amplitude_m > 0.0 &&
      *waves.amplitude_m < *resolution_m) {
    warn({.id = "position_resolution",
          .asked = *waves.amplitude_m,
          .device = *resolution_m,
          .text =
              phrase("Rehearsal",
                     "The texture of \"%1\" has an amplitude of %2 µm (√2 times its RMS), and the "
                     "device measures positions in steps of %3 µm. Raise the amplitude of the "
                     "texture, or choose a device with a finer position resolution.")
                  .with(name_, in_um(*waves.amplitude_m), in_um(*resolution_m))});
  }
  if (!waves.wavelength_m) return;
  note_if_near(resolution_m && kFar * *waves.wavelength_m < 2.0 * *resolution_m);
  if (resolution_m && *waves.wavelength_m < 2.0 * *resolution_m) {
    warn({.id = "wavelength",
          .asked = *waves.wavelength_m,
          .device = *resolution_m,
          .text = phrase("Rehearsal",
                         "The wavelength of \"%1\" is %2 µm, and the device measures positions in "
                         "steps of %3 µm: at least two steps per wavelength are needed. Choose a "
                         "longer wavelength, or a device with a finer position resolution.")
                      .with(name_, in_um(*waves.wavelength_m), in_um(*resolution_m))});
  }
  double bandwidth_Hz = 0.5 * protocol_.rate_Hz;
  if (const auto resonance_Hz = profile_.value("resonance_Hz")) {
    bandwidth_Hz = std::min(bandwidth_Hz, *resonance_Hz);
  }
  const double frequency_Hz = speed_m_per_s / *waves.wavelength_m;
  note_if_near(frequency_Hz > kFar * bandwidth_Hz);
  if (frequency_Hz > bandwidth_Hz) {
    warn({.id = "bandwidth",
          .asked = frequency_Hz,
          .device = bandwidth_Hz,
          .text = phrase("Rehearsal",
                         "When \"%1\" is stroked at %2 mm/s, its temporal frequency is %3 Hz, and "
                         "the bandwidth of the device is %4 Hz. Lower the speed, or choose a "
                         "longer wavelength or a device with a higher bandwidth.")
                      .with(name_, in_three_digits(1e3 * speed_m_per_s),
                            in_three_digits(frequency_Hz), in_three_digits(bandwidth_Hz))});
  }
}

std::optional<double> StimulusRehearsal::holds_N_per_m() const {
  return stiffest_spring_N_per_m({.damping_N_s_per_m = profile_.value("damping_N_s_per_m"),
                                  .held_N_per_m = profile_.value("stiffness_N_per_m"),
                                  .held_at_Hz = profile_.rate_Hz,
                                  .stiffest_tried_N_per_m = kStiffestTried_N_per_m},
                                 protocol_.rate_Hz);
}

void StimulusRehearsal::check_coupling(const VirtualCoupling& coupling) {
  const std::optional<double> holds = holds_N_per_m();
  if (!holds) return;
  const double asked_N_s_per_m =
      passive_damping_N_s_per_m(coupling.stiffness_N_per_m, coupling.damping_N_s_per_m, period_s());
  const double device_N_s_per_m = passive_damping_N_s_per_m(*holds, 0.0, period_s());
  note_if_near(asked_N_s_per_m > kFar * device_N_s_per_m);
  if (asked_N_s_per_m <= device_N_s_per_m) return;
  warn(
      {.id = "coupling",
       .asked = asked_N_s_per_m,
       .device = device_N_s_per_m,
       .text =
           phrase("Rehearsal",
                  "The virtual coupling of \"%1\", %2 N/m and %3 N s/m, requires a device with a "
                  "damping of %4 N s/m at %5 Hz; the measured stiffness of this device corresponds "
                  "to %6 N s/m. Lower coupling_damping_N_s_per_m or coupling_stiffness_N_per_m.")
               .with(name_, in_three_digits(coupling.stiffness_N_per_m),
                     in_three_digits(coupling.damping_N_s_per_m), in_three_digits(asked_N_s_per_m),
                     in_three_digits(protocol_.rate_Hz), in_three_digits(device_N_s_per_m))});
}

void StimulusRehearsal::check_stiffness(const std::optional<FeltStiffness>& felt,
                                        double holds_N_per_m, double damper_N_s_per_m) {
  if (!felt) {
    warn({.id = "not_rehearsed",
          .device = holds_N_per_m,
          .text =
              phrase("Rehearsal",
                     "The stiffness of \"%1\" could not be determined or compared with the "
                     "%2 N/m that the device renders without oscillation: at every place "
                     "examined its force jumps or does not increase. Check on the device that the "
                     "stimulus does not cause oscillation.")
                  .with(name_, in_three_digits(holds_N_per_m))});
    return;
  }
  const double stiffest_N_per_m =
      equivalent_spring_N_per_m(felt->stiffness_N_per_m, damper_N_s_per_m, period_s());
  note_if_near(stiffest_N_per_m > kFar * holds_N_per_m);
  if (stiffest_N_per_m <= holds_N_per_m) return;
  const Phrase text =
      felt->force_N >= protocol_.force_limit_N
          ? phrase("Rehearsal",
                   "At the force limit of %2 N, the greatest stiffness of \"%1\" is %3 N/m; the "
                   "device renders up to %4 N/m without oscillation. Lower the stiffness, or "
                   "choose another device.")
          : phrase("Rehearsal",
                   "At the greatest force that \"%1\" exerts at its stiffest place, %2 N, its "
                   "stiffness is %3 N/m; the device renders up to %4 N/m without oscillation. "
                   "Lower the stiffness, or choose another device.");
  const Phrase sentence =
      text.with(name_, in_three_digits(felt->force_N), in_three_digits(stiffest_N_per_m),
                in_three_digits(holds_N_per_m));
  const double of_damper_N_per_m = equivalent_spring_N_per_m(0.0, damper_N_s_per_m, period_s());
  warn(
      {.id = "stiffness",
       .asked = stiffest_N_per_m,
       .device = holds_N_per_m,
       .text =
           damper_N_s_per_m == 0.0
               ? sentence
               : phrase("Rehearsal",
                        "%1 The contact damping of %2 N s/m accounts for %3 N/m of this stiffness.")
                     .with(sentence, in_three_digits(damper_N_s_per_m),
                           in_three_digits(of_damper_N_per_m))});
}

void StimulusRehearsal::check_contact(const PreparedStimulus& stimulus, const HandHabits& habits) {
  const std::optional<double> mass_kg = profile_.value("moving_mass_kg");
  const DeviceItem* const damping = profile_.item("damping_N_s_per_m");
  if (!mass_kg || damping == nullptr || !damping->value) return;
  constexpr std::size_t kAcross = 2;
  // The hold along the surface is the simulated hand's; across it the damping is that of the device alone.
  HandMechanics held{.mass_kg = *mass_kg};
  held.normal_damping_N_s_per_m =
      std::max(kSomeDamping_N_s_per_m,
               damping->by_axis.size() > kAcross ? damping->by_axis[kAcross] : *damping->value);
  const double lost =
      share_out_of_contact(*stimulus.model, stimulus.inputs,
                           {.hand = held, .habits = habits, .rate_Hz = protocol_.rate_Hz});
  note_if_near(lost > kFar * kContactMayBeLost);
  if (lost <= kContactMayBeLost) return;
  warn({.id = "contact",
        .asked = lost,
        .device = kContactMayBeLost,
        .text = phrase("Rehearsal",
                       "With a force of %2 N and a speed of %3 mm/s, contact with \"%1\" is "
                       "expected to be lost for about %4 % of a stroke: a mass of %5 g with a "
                       "damping of %6 N s/m, as measured for the device, cannot follow the height "
                       "of the surface. Lower stiffness_N_per_m, the amplitude of the texture or "
                       "the speed, or request a higher normal force.")
                    .with(name_, in_three_digits(habits.normal_force_N),
                          in_three_digits(1e3 * habits.speed_m_per_s), fixed(100.0 * lost, 0),
                          in_three_digits(1e3 * *mass_kg),
                          in_three_digits(held.normal_damping_N_s_per_m))});
}

void StimulusRehearsal::check_workspace(const SurfacePatch& patch) {
  const glm::dvec3 low_m = profile_.reached_minimum_m.value_or(profile_.workspace_minimum_m);
  const glm::dvec3 high_m = profile_.reached_maximum_m.value_or(profile_.workspace_maximum_m);
  for (int axis = 0; axis < 2; ++axis) {
    const double from_m = patch.centre_m[axis] - 0.5 * patch.extent_m[axis];
    const double to_m = patch.centre_m[axis] + 0.5 * patch.extent_m[axis];
    if (from_m >= low_m[axis] && to_m <= high_m[axis]) continue;
    // The place belongs to the surface and not to a stimulus.
    warnings_.push_back(
        {.id = "workspace",
         .pointer = "/surface",
         .asked = std::max(low_m[axis] - from_m, to_m - high_m[axis]),
         .device = 0.0,
         .text = phrase("Rehearsal",
                        "The surface lies from %1 to %2 mm along %3, and the handle reaches from "
                        "%4 to %5 mm. Move the surface or make it smaller, or choose a device with "
                        "a larger workspace.")
                     .with(fixed(1e3 * from_m, 1), fixed(1e3 * to_m, 1), axis == 0 ? "x" : "y",
                           fixed(1e3 * low_m[axis], 1), fixed(1e3 * high_m[axis], 1))});
  }
}

}  // namespace asperity
