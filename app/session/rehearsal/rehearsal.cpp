// Compares a protocol and every stimulus of its plan with the profile of a device.

#include "app/session/rehearsal/rehearsal.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "app/session/rehearsal/friction_rehearsal.h"
#include "app/session/rehearsal/level_rehearsal.h"
#include "app/session/rehearsal/limit_rehearsal.h"
#include "app/session/rehearsal/stimulus_rehearsal.h"
#include "app/session/rehearsal/warned_levels.h"
#include "app/study_files/parameter_json.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

/// The traits with which stimuli are compared, in addition to the workspace.
constexpr std::array kComparedTraits{DeviceTrait::friction,      DeviceTrait::force_resolution,
                                     DeviceTrait::position_step, DeviceTrait::damping,
                                     DeviceTrait::latency,       DeviceTrait::moving_mass,
                                     DeviceTrait::stiffness,     DeviceTrait::resonance};

/// Distinguishes a stimulus from others of the same name: a factor may choose its bodies and its files.
std::string rehearsed_key(const StimulusDescription& stimulus) {
  std::string key = stimulus.name + '\n' + stimulus.model + '\n' +
                    json_text_of(stimulus.parameters) + '\n' +
                    std::to_string(stimulus.material.stiffness_N_per_m) + ' ' +
                    std::to_string(stimulus.material.friction);
  for (const auto* const body : {&stimulus.surface, &stimulus.tool}) {
    key += '\n' + (*body ? (*body)->name : std::string{});
  }
  for (const StimulusAsset& asset : assets_of(stimulus)) {
    key += '\n' + asset.role + '\t' + asset.path;
  }
  return key;
}

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

}  // namespace

std::vector<RehearsalWarning> rehearse_on_device(const Protocol& protocol,
                                                 const DeviceProfile& profile,
                                                 StimulusBuilder& builder,
                                                 const RehearsalCourse& course) {
  std::vector<RehearsalWarning> warnings{};
  add(limit_warnings(protocol, profile), warnings);
  add(level_warnings(protocol, profile, builder.models()), warnings);
  add(rehearse_friction(protocol, builder.models(), damped_response_of(profile)).warnings,
      warnings);
  StimulusRehearsal rehearsal(protocol, profile, builder);
  std::set<std::string> seen{};
  const std::vector<Trial> trials = possible_trials(protocol);
  std::vector<RehearsalWarning> of_stimuli{};
  double done = 0.0;
  for (const Trial& trial : trials) {
    if (course.stop.stop_requested()) break;
    if (course.progress) course.progress(done / static_cast<double>(trials.size()));
    ++done;
    const Exploration& exploration = exploration_of(protocol, trial);
    for (const PlannedPresentation& planned : trial.presentations) {
      const std::string key = rehearsed_key(planned.stimulus) + '\n' + exploration.name;
      if (!seen.insert(key).second) continue;
      std::vector<RehearsalWarning> found = rehearsal.compare(planned, exploration);
      for (RehearsalWarning& warning : found) {
        if (!warning.stimulus.empty()) warning.level = level_of(protocol, trial, planned);
      }
      add(std::move(found), of_stimuli);
    }
  }
  add(one_for_alike(std::move(of_stimuli), protocol), warnings);
  return warnings;
}

std::vector<DeviceTrait> not_compared(const std::vector<DeviceTrait>& not_known) {
  return traits_without(kComparedTraits, traits_without(kDeviceTraits, not_known));
}

}  // namespace asperity
