// Compares a protocol and every stimulus of its plan with the profile of a device.

#include "app/session/rehearsal/rehearsal.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "app/session/rehearsal/friction_rehearsal.h"
#include "app/session/rehearsal/level_rehearsal.h"
#include "app/session/rehearsal/limit_rehearsal.h"
#include "app/session/rehearsal/position_step_rehearsal.h"
#include "app/session/rehearsal/stimulus_rehearsal.h"
#include "app/session/rehearsal/warned_levels.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

/// The traits with which stimuli are compared, in addition to the workspace.
constexpr std::array kComparedTraits{DeviceTrait::friction,      DeviceTrait::force_resolution,
                                     DeviceTrait::position_step, DeviceTrait::damping,
                                     DeviceTrait::latency,       DeviceTrait::moving_mass,
                                     DeviceTrait::stiffness,     DeviceTrait::resonance};

/// Adds warnings; the same sentence under the same name once.
void add(std::vector<RehearsalWarning> more, std::vector<RehearsalWarning>& warnings) {
  for (RehearsalWarning& warning : more) {
    const bool is_reported =
        std::any_of(warnings.begin(), warnings.end(), [&](const RehearsalWarning& one) {
          return one.id == warning.id && one.text == warning.text;
        });
    if (!is_reported) warnings.push_back(std::move(warning));
  }
}

/// Whether the level is that of the texture: none at a level of 0 and too little at the next one, it is not monotone.
bool varies_amplitude(const std::optional<WarnedLevel>& level, const PlannedPresentation& planned,
                      const StimulusBuilder& builder) {
  const ForceModel* const model = builder.models().find(planned.stimulus.model);
  return level && model != nullptr && model->declaration.amplitude_parameter == level->parameter;
}

}  // namespace

std::vector<RehearsalWarning> rehearse_on_device(const Protocol& protocol,
                                                 const DeviceProfile& profile,
                                                 StimulusBuilder& builder,
                                                 const StimuliCourse& course) {
  std::vector<RehearsalWarning> warnings{};
  add(limit_warnings(protocol, profile), warnings);
  add(level_warnings(protocol, profile, builder.models()), warnings);
  add(rehearse_friction(protocol, builder.models(), damped_response_of(profile)).warnings,
      warnings);
  if (const std::optional<double> step_m = profile.value("position_resolution_m")) {
    add(position_step_warnings(protocol, builder, *step_m), warnings);
  }
  StimulusRehearsal rehearsal(protocol, profile, builder);
  std::map<std::size_t, std::vector<RehearsalWarning>> found_of{};  // in the order of the trials
  for_each_stimulus_near_limit(
      protocol, possible_trials(protocol), course, [&](const ExploredStimulus& one) {
        const std::optional<WarnedLevel> level = level_of(protocol, one.trial, one.planned);
        std::vector<RehearsalWarning>& found = found_of[one.index];
        found = rehearsal.compare(one.planned, one.exploration);
        for (RehearsalWarning& warning : found) {
          if (!warning.stimulus.empty()) warning.level = level;
        }
        return varies_amplitude(level, one.planned, builder) ? Nearness::near
                                                             : rehearsal.nearness();
      });
  std::vector<RehearsalWarning> of_stimuli{};
  for (auto& [index, found] : found_of) add(std::move(found), of_stimuli);
  add(one_for_alike(std::move(of_stimuli), protocol), warnings);
  return warnings;
}

std::vector<DeviceTrait> not_compared(const std::vector<DeviceTrait>& not_known) {
  return traits_without(kComparedTraits, traits_without(kDeviceTraits, not_known));
}

}  // namespace asperity
