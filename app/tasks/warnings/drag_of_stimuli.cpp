// Strokes each stimulus at the requested force and speed, and divides its drag by that of Coulomb.

#include "app/tasks/warnings/drag_of_stimuli.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <optional>

#include "analysis/numbers/number_text.h"
#include "app/session/attempt_measures.h"
#include "renderers/offline/sliding_drag.h"

namespace asperity {
namespace {

constexpr const char* kSpeedName = "friction_speed_m_per_s";
constexpr const char* kLawName = "friction_law";
constexpr int kStrokes = 3;  // two of them are dropped

constexpr std::size_t kNames = 8;

struct AimedStroke {
  double speed_m_per_s = 0.0;
  double normal_force_N = 0.0;
  double length_m = 0.0;
};

/// Nothing where the hand presses without a stroke.
std::optional<AimedStroke> aimed_stroke(const Exploration& exploration, const SurfacePatch& patch) {
  const Band& speed = exploration.speed_m_per_s;
  if (!speed.target && !speed.minimum && !speed.maximum) return {};
  const HandHabits habits = habits_for(exploration, patch);
  // The band is that of the mean of a stroke; so is the drag.
  return AimedStroke{.speed_m_per_s = (1.0 - habits.gathering) * habits.speed_m_per_s,
                     .normal_force_N = habits.normal_force_N,
                     .length_m = habits.stroke_length_m};
}

/// The mean drag over that of Coulomb.
std::optional<double> measured_drag(PreparedStimulus stimulus, const AimedStroke& stroke,
                                    double rate_Hz) {
  RendererInputs& inputs = stimulus.inputs;
  inputs.body = nullptr;
  const SlidingDrag drag = sliding_drag(*stimulus.model, inputs,
                                        {.speed_m_per_s = stroke.speed_m_per_s,
                                         .normal_force_N = stroke.normal_force_N,
                                         .length_m = stroke.length_m,
                                         .strokes = kStrokes,
                                         .rate_Hz = rate_Hz});
  return drag.coulomb_N > 0.0 ? std::optional(drag.mean_N / drag.coulomb_N) : std::nullopt;
}

std::optional<double> drag_of(const PlannedPresentation& planned, const AimedStroke& stroke,
                              double rate_Hz, StimulusBuilder& builder) {
  const StimulusDescription& stimulus = planned.stimulus;
  const ForceModel* const model = builder.models().find(stimulus.model);
  if (model == nullptr || !(stimulus.material.friction > 0.0)) return {};
  const std::vector<Parameter>& declared = model->declaration.parameters;
  const auto declares = [&declared](const char* name) {
    return std::any_of(declared.begin(), declared.end(),
                       [name](const Parameter& one) { return one.name == name; });
  };
  if (declares(kLawName)) {
    if (!builder.can_make(stimulus)) return {};
    return measured_drag(builder.prepare(planned), stroke, rate_Hz);
  }
  if (!declares(kSpeedName)) return {};
  const ParameterValues values = complete_values(model->declaration, stimulus.parameters);
  return 1.0 / std::hypot(1.0, number_of(values, kSpeedName) / stroke.speed_m_per_s);
}

}  // namespace

std::vector<StimulusDrag> drag_of_stimuli(const CheckedProtocol& checked, StimulusBuilder& builder,
                                          const StimuliCourse& course) {
  const Protocol& protocol = checked.protocol;
  std::vector<StimulusDrag> drags{};
  for_each_stimulus(protocol, checked.trials(), course, [&](const ExploredStimulus& one) {
    const StimulusDescription& stimulus = one.planned.stimulus;
    const std::optional<AimedStroke> stroke = aimed_stroke(one.exploration, stimulus.patch);
    if (!stroke) return;
    std::optional<double> drag{};
    try {
      drag = drag_of(one.planned, *stroke, protocol.rate_Hz, builder);
    } catch (const std::exception&) {  // the session's preparation reports it
      return;
    }
    if (!drag) return;
    drags.push_back({.stimulus = stimulus.name,
                     .exploration = one.exploration.name,
                     .mean_N = *drag * stimulus.material.friction * stroke->normal_force_N,
                     .of_coulomb = *drag});
  });
  return drags;
}

std::vector<std::string> drag_lines(std::span<const StimulusDrag> drags) {
  struct Alike {
    std::string numbers{};
    std::string exploration{};
    std::vector<std::string> stimuli{};
  };
  std::vector<Alike> groups{};
  for (const StimulusDrag& drag : drags) {
    const std::string numbers = "mean drag " + fixed(drag.mean_N, 3) + " N, " +
                                fixed(1e2 * drag.of_coulomb, 1) + " % of friction × normal force";
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Alike& group) {
      return group.numbers == numbers && group.exploration == drag.exploration;
    });
    if (found != groups.end()) {
      found->stimuli.push_back(drag.stimulus);
    } else {
      groups.push_back(
          {.numbers = numbers, .exploration = drag.exploration, .stimuli = {drag.stimulus}});
    }
  }
  if (groups.empty()) return {};
  std::vector<std::string> lines{
      "the mean drag is the mean force of friction against a stroke, without the texture; stimuli "
      "that should differ only in their texture should have the same mean drag, because "
      "participants can otherwise distinguish them by it"};
  for (const Alike& group : groups) {
    std::string names{};
    for (std::size_t i = 0; i < std::min(group.stimuli.size(), kNames); ++i) {
      names += (i == 0 ? "" : ", ") + group.stimuli[i];
    }
    if (group.stimuli.size() > kNames) {
      names += " and " + std::to_string(group.stimuli.size() - kNames) + " more";
    }
    lines.push_back(group.numbers + ": " + names + " (exploration " + group.exploration + ")");
  }
  return lines;
}

}  // namespace asperity
