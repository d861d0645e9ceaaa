// Lists every stimulus that the sessions of a protocol can present, with each of its explorations.

#include "app/session/explored_stimuli.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/session/rehearsal/warned_levels.h"
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

/// In the order of the trials, which must outlive them.
std::vector<ExploredStimulus> explored_stimuli(const Protocol& protocol,
                                               std::span<const Trial> trials) {
  std::vector<ExploredStimulus> stimuli{};
  std::set<std::string> listed{};
  for (const Trial& trial : trials) {
    const Exploration& exploration = exploration_of(protocol, trial);
    for (const PlannedPresentation& planned : trial.presentations) {
      if (!listed.insert(stimulus_key(planned.stimulus) + '\n' + exploration.name).second) continue;
      stimuli.push_back({.trial = trial,
                         .planned = planned,
                         .exploration = exploration,
                         .index = stimuli.size()});
    }
  }
  return stimuli;
}

/// Stimuli that differ only in the level of a varied parameter; or a single one.
struct LevelFamily {
  struct Member {
    const ExploredStimulus* stimulus = nullptr;
    double level = 0.0;
  };
  std::string key{};  ///< what they have in common
  std::vector<Member> members{};
};

/// In the order of their first stimuli, the members by their levels.
std::vector<LevelFamily> level_families(const Protocol& protocol,
                                        const std::vector<ExploredStimulus>& stimuli) {
  std::vector<LevelFamily> families{};
  for (const ExploredStimulus& one : stimuli) {
    const std::optional<WarnedLevel> level = level_of(protocol, one.trial, one.planned);
    if (!level) {
      families.push_back({.key = {}, .members = {{&one, 0.0}}});
      continue;
    }
    StimulusDescription without_level = one.planned.stimulus;
    without_level.name = level->stimulus;
    without_level.parameters.erase(level->parameter);
    const std::string key = level->parameter + '\n' + one.planned.stimulus_template + '\n' +
                            one.exploration.name + '\n' + stimulus_key(without_level);
    auto family = std::find_if(families.begin(), families.end(),
                               [&key](const LevelFamily& other) { return other.key == key; });
    if (family == families.end()) family = families.insert(family, {.key = key, .members = {}});
    family->members.push_back({&one, level->value});
  }
  for (LevelFamily& family : families) {
    std::stable_sort(family.members.begin(), family.members.end(),
                     [](const auto& one, const auto& other) { return one.level < other.level; });
  }
  return families;
}

}  // namespace

void for_each_stimulus(const Protocol& protocol, std::span<const Trial> trials,
                       const StimuliCourse& course,
                       const std::function<void(const ExploredStimulus&)>& examine) {
  const std::vector<ExploredStimulus> stimuli = explored_stimuli(protocol, trials);
  for (std::size_t i = 0; i < stimuli.size() && !course.stop.stop_requested(); ++i) {
    if (course.progress)
      course.progress(static_cast<double>(i) / static_cast<double>(stimuli.size()));
    examine(stimuli[i]);
  }
}

void for_each_stimulus_near_limit(const Protocol& protocol, std::span<const Trial> trials,
                                  const StimuliCourse& course,
                                  const std::function<Nearness(const ExploredStimulus&)>& examine) {
  const std::vector<ExploredStimulus> stimuli = explored_stimuli(protocol, trials);
  std::size_t settled = 0;  // examined or left out
  const auto nearness_of = [&](const LevelFamily::Member& member) {
    if (course.stop.stop_requested()) return Nearness::far;
    if (course.progress)
      course.progress(static_cast<double>(settled) / static_cast<double>(stimuli.size()));
    ++settled;
    return examine(*member.stimulus);
  };
  for (const LevelFamily& family : level_families(protocol, stimuli)) {
    const std::vector<LevelFamily::Member>& members = family.members;
    const std::size_t last = members.size() - 1;
    std::vector<Nearness> nearness(members.size(), nearness_of(members.front()));
    if (last > 0) nearness[last] = nearness_of(members[last]);
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, last}};
    while (!open.empty()) {
      const auto [low, high] = open.back();
      open.pop_back();
      if (high - low < 2) continue;
      const bool is_whole = low == 0 && high == last;
      if (!is_whole && nearness[low] == Nearness::far && nearness[high] == Nearness::far) {
        settled += high - low - 1;
        continue;
      }
      const std::size_t middle = low + (high - low) / 2;
      nearness[middle] = nearness_of(members[middle]);
      open.emplace_back(middle, high);
      open.emplace_back(low, middle);
    }
  }
}

}  // namespace asperity
