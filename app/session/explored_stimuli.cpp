// Lists every stimulus that the sessions of a protocol can present, with each of its explorations.

#include "app/session/explored_stimuli.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "app/study_files/parameter_json.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

/// Distinguishes a stimulus from others of the same name.
std::string stimulus_key(const StimulusDescription& stimulus) {
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

}  // namespace

void for_each_stimulus(const Protocol& protocol, const StimuliCourse& course,
                       const std::function<void(const ExploredStimulus&)>& examine) {
  const std::vector<Trial> trials = possible_trials(protocol);
  std::vector<ExploredStimulus> stimuli{};
  std::set<std::string> listed{};
  for (const Trial& trial : trials) {
    const Exploration& exploration = exploration_of(protocol, trial);
    for (const PlannedPresentation& planned : trial.presentations) {
      if (!listed.insert(stimulus_key(planned.stimulus) + '\n' + exploration.name).second) continue;
      stimuli.push_back({.trial = trial, .planned = planned, .exploration = exploration});
    }
  }
  for (std::size_t i = 0; i < stimuli.size() && !course.stop.stop_requested(); ++i) {
    if (course.progress)
      course.progress(static_cast<double>(i) / static_cast<double>(stimuli.size()));
    examine(stimuli[i]);
  }
}

}  // namespace asperity
