// Compares stimuli with the position step of a device.

#include "app/session/rehearsal/position_step_rehearsal.h"

#include <exception>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "app/session/attempt_measures.h"
#include "app/session/explored_stimuli.h"
#include "app/session/rehearsal/warned_levels.h"
#include "protocols/design/json_pointer.h"
#include "protocols/plan/plan.h"
#include "renderers/force/indentation_law.h"
#include "renderers/force/path_clock.h"
#include "renderers/offline/perceived_instability.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"

namespace asperity {
namespace {

/// What determines the stiffness across a surface.
enum class StiffnessOf { material, coupling, indentation };

struct StiffnessAcross {
  StiffnessOf of = StiffnessOf::material;
  double stiffness_N_per_m = 0.0;
};

StiffnessAcross stiffness_across(const PreparedStimulus& stimulus, double force_N) {
  RendererInputs inputs = stimulus.inputs;
  inputs.parameters = complete_values(stimulus.model->declaration, inputs.parameters);
  if (has_virtual_coupling(inputs.parameters)) {
    return {StiffnessOf::coupling, number_of(inputs.parameters, "coupling_stiffness_N_per_m")};
  }
  const StiffnessAcross plate{StiffnessOf::material, inputs.material.stiffness_N_per_m};
  if (stimulus.model->declaration.needs_bodies) return plate;
  inputs.body.reset();  // compared on a plane
  const std::unique_ptr<ForceRenderer> renderer = stimulus.model->make(inputs);
  const auto* const law = dynamic_cast<const IndentationLaw*>(renderer.get());
  if (law == nullptr) return plate;
  return {StiffnessOf::indentation, law->indentation_stiffness_N_per_m(force_N)};
}

Phrase remedy(StiffnessOf of, double greatest_N_per_m) {
  switch (of) {
    case StiffnessOf::material:
      return phrase("Rehearsal",
                    "Set stiffness_N_per_m to %1 or less, or choose a device with a finer position "
                    "resolution.")
          .with(in_three_digits(greatest_N_per_m));
    case StiffnessOf::coupling:
      return phrase("Rehearsal",
                    "Set coupling_stiffness_N_per_m to %1 or less, or choose a device with a finer "
                    "position resolution.")
          .with(in_three_digits(greatest_N_per_m));
    case StiffnessOf::indentation:
      return phrase("Rehearsal",
                    "Choose a softer surface, of %1 N/m or less, or a device with a finer position "
                    "resolution.")
          .with(in_three_digits(greatest_N_per_m));
  }
  return {};
}

RehearsalWarning step_warning(const std::string& name, const StiffnessAcross& across,
                              double step_m) {
  const double force_N = across.stiffness_N_per_m * step_m;
  return {
      .id = "position_step",
      .asked = force_N,
      .device = kFeltForce_N,
      .text =
          phrase("Rehearsal",
                 "The device measures positions in steps of %2 µm. At the stiffness of \"%1\", "
                 "%3 N/m, one step changes the force by %4 mN, and a reading that varies "
                 "between two steps is felt as a vibration; the threshold is about %5 mN. %6")
              .with(name, in_three_digits(1e6 * step_m), in_three_digits(across.stiffness_N_per_m),
                    in_three_digits(1e3 * force_N), in_three_digits(1e3 * kFeltForce_N),
                    remedy(across.of, two_digits_down(kFeltForce_N / step_m)))};
}

}  // namespace

std::vector<RehearsalWarning> position_step_warnings(const Protocol& protocol,
                                                     StimulusBuilder& builder, double step_m) {
  std::vector<RehearsalWarning> warnings{};
  std::set<std::pair<std::string, double>> warned{};
  for_each_stimulus(protocol, possible_trials(protocol), {}, [&](const ExploredStimulus& one) {
    const StimulusDescription& stimulus = one.planned.stimulus;
    if (!builder.can_make(stimulus)) return;
    StiffnessAcross across{};
    try {
      across = stiffness_across(builder.unmatched(stimulus),
                                habits_for(one.exploration, stimulus.patch).normal_force_N);
    } catch (const std::exception&) {  // other comparisons report it
      return;
    }
    if (across.stiffness_N_per_m * step_m <= kFeltForce_N) return;
    RehearsalWarning warning = step_warning(stimulus.name, across, step_m);
    if (!warned.emplace(stimulus.name, warning.asked).second) return;
    warning.stimulus = stimulus.name;
    warning.pointer = pointer_to("/stimuli", one.planned.stimulus_template);
    warning.level = level_of(protocol, one.trial, one.planned);
    warnings.push_back(std::move(warning));
  });
  return one_for_alike(std::move(warnings), protocol);
}

std::vector<RehearsalWarning> unknown_step_warnings(const Protocol& protocol,
                                                    const ModelRegistry& models) {
  std::vector<RehearsalWarning> warnings{};
  std::set<std::string> seen{};
  for_each_stimulus(protocol, possible_trials(protocol), {}, [&](const ExploredStimulus& one) {
    const StimulusDescription& stimulus = one.planned.stimulus;
    const ForceModel* const model = models.find(stimulus.model);
    if (model == nullptr || stimulus.parameters.contains(kDeviceStep)) return;
    if (!measures_path(complete_values(model->declaration, stimulus.parameters))) return;
    if (!seen.insert(stimulus.name).second) return;
    warnings.push_back(
        {.id = "path_step",
         .stimulus = stimulus.name,
         .pointer = pointer_to("/stimuli", one.planned.stimulus_template),
         .text = phrase("Rehearsal",
                        "The texture of \"%1\" follows the path of the hand, and the position step "
                        "of the device is unknown: if the step is greater than 10 µm, the path "
                        "also grows while the hand rests. Measure the device, and set "
                        "device_step_m to its position_resolution_m.")
                     .with(stimulus.name),
         .level = level_of(protocol, one.trial, one.planned)});
  });
  return one_for_alike(std::move(warnings), protocol);
}

}  // namespace asperity
