// Renders a path across each stimulus, and reports the error that a session would meet.

#include "app/tasks/warnings/plugin_stimuli.h"

#include <cmath>
#include <exception>
#include <numbers>
#include <optional>
#include <set>

#include "app/words/phrase_of_error.h"
#include "renderers/offline/along_path.h"

namespace asperity {
namespace {

/// Three crossings in a second.
std::vector<ProbeState> path_across(const SurfacePatch& patch, double rate_Hz) {
  constexpr double kBeyondBorder = 1.1;
  constexpr double kDeepest_m = 0.002;
  constexpr double kAcross_rad_per_s = 2.0 * std::numbers::pi * 1.5;
  constexpr double kDown_rad_per_s = 2.0 * std::numbers::pi * 4.0;
  const double half_x_m = 0.5 * kBeyondBorder * patch.extent_m.x;
  const double half_y_m = 0.5 * kBeyondBorder * patch.extent_m.y;
  std::vector<ProbeState> path(static_cast<std::size_t>(std::lround(rate_Hz)));
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double time_s = static_cast<double>(i) / rate_Hz;
    const double across_rad = kAcross_rad_per_s * time_s;
    const double down_rad = kDown_rad_per_s * time_s;
    const double along_y = 0.7 * std::sin(0.31 * across_rad);
    path[i].time_ns = std::llround(time_s * 1e9);
    path[i].position_m =
        patch.centre_m + glm::dvec3{half_x_m * std::cos(across_rad), half_y_m * along_y,
                                    kDeepest_m * std::cos(down_rad)};
    path[i].velocity_m_per_s = {
        -half_x_m * kAcross_rad_per_s * std::sin(across_rad),
        half_y_m * 0.7 * 0.31 * kAcross_rad_per_s * std::cos(0.31 * across_rad),
        -kDeepest_m * kDown_rad_per_s * std::sin(down_rad)};
  }
  return path;
}

/// What happens in a session; nothing if nothing fails.
std::optional<Phrase> failure_of(const PreparedStimulus& stimulus, double rate_Hz) {
  const auto renderer = make_renderer(*stimulus.model, stimulus.inputs);
  along_path(*renderer, path_across(stimulus.inputs.patch, rate_Hz), rate_Hz);
  if (renderer->error().empty()) return {};
  return phrase("Protocols",
                "the plug-in of its force model failed in a stroke across the surface: %1; correct "
                "the plug-in, or the values of the stimulus")
      .with(std::string(renderer->error()));
}

}  // namespace

std::vector<Diagnostic> problems_of_plugin_stimuli(const CheckedProtocol& checked,
                                                   StimulusBuilder& builder) {
  std::vector<Diagnostic> problems{};
  std::set<std::string> compared{};
  std::set<std::string> reported{};  // one stimulus stands for the others of a template
  for (const auto& [trial, planned] : checked.presentations()) {
    const StimulusDescription& stimulus = planned.stimulus;
    const ForceModel* const model = builder.models().find(stimulus.model);
    if (model == nullptr || !model->plugin || !builder.can_make(stimulus)) continue;
    if (!compared.insert(stimulus.name).second || reported.contains(planned.stimulus_template)) {
      continue;
    }
    std::optional<Phrase> failure{};
    try {
      failure = failure_of(builder.unmatched(stimulus), checked.protocol.rate_Hz);
    } catch (const std::exception& error) {
      failure = phrase_of(error);
    }
    if (!failure) continue;
    reported.insert(planned.stimulus_template);
    problems.push_back(checked.cannot_be_rendered(planned, *failure));
  }
  return problems;
}

}  // namespace asperity
