// Runs the model at its defaults, at each limit and at drawn combinations of limits.

#include "renderers/conformance/finite_check.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "renderers/conformance/check_paths.h"
#include "renderers/force/layers.h"
#include "renderers/offline/along_path.h"
#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr int kJointRuns = 16;

/// The first problem of a result; empty for none. A tool that is coupled to the hand pulls at it without contact.
std::string problem_of(const RenderedTick& tick, bool has_bodies) {
  if (!is_finite_as_stored(tick)) return "a number that is not finite as stored";
  if (tick.penetration_m < 0.0) return "a negative penetration";
  if (!has_bodies && tick.penetration_m == 0.0 && tick.wrench.force_N != glm::dvec3(0.0)) {
    return "a force without contact";
  }
  return {};
}

std::vector<Parameter> own_parameters(const ForceModel& model) {
  std::vector<Parameter> shared{};
  add_layer_parameters(shared);
  std::vector<Parameter> own = model.declaration.parameters;
  std::erase_if(own, [&shared](const Parameter& parameter) {
    return std::any_of(shared.begin(), shared.end(),
                       [&parameter](const Parameter& each) { return each.name == parameter.name; });
  });
  return own;
}

/// The limits of a number, or all choices.
std::vector<ParameterValue> extremes_of(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::choice) {
    return {parameter.choices.begin(), parameter.choices.end()};
  }
  return {parameter.minimum, parameter.maximum};
}

/// The given values of each run: the defaults, then each own parameter at its limits, then all together at limits that are
/// drawn, the same ones in every run of the suite.
std::vector<ParameterValues> values_at_limits(const ForceModel& model) {
  std::vector<ParameterValues> runs{{}};
  // A body at the limits of its sampling takes minutes.
  if (model.declaration.needs_bodies) return runs;
  const std::vector<Parameter> own = own_parameters(model);
  for (const Parameter& parameter : own) {
    for (const ParameterValue& value : extremes_of(parameter)) {
      runs.push_back({{parameter.name, value}});
    }
  }
  if (own.size() < 2) return runs;
  Random random = Random(1).split("conformance");
  for (int run = 0; run < kJointRuns; ++run) {
    ParameterValues values{};
    for (const Parameter& parameter : own) {
      const std::vector<ParameterValue> extremes = extremes_of(parameter);
      // The first two runs: all lower limits, all upper limits.
      const std::size_t place = run == 0 ? 0
                                : run == 1
                                    ? extremes.size() - 1
                                    : static_cast<std::size_t>(random.below(extremes.size()));
      values[parameter.name] = extremes[place];
    }
    runs.push_back(std::move(values));
  }
  return runs;
}

/// The ticks of all runs, and the first problem.
class FiniteRuns final {
 public:
  explicit FiniteRuns(const ForceModel& model) : model_(model) {}

  /// `with`: the values, and where. Errors: std::invalid_argument of a model that refuses the inputs.
  void run(const RendererInputs& inputs, const std::vector<ProbeState>& path,
           const std::string& with) {
    const auto renderer = make_renderer(model_, inputs);
    std::size_t number = 0;
    for (const RenderedTick& tick : along_path(*renderer, path, kConformanceRate_Hz)) {
      ++ticks_;
      std::string problem = problem_of(tick, model_.declaration.needs_bodies);
      if (!problem.empty()) {
        if (!renderer->error().empty()) problem += " (" + std::string(renderer->error()) + ')';
        problem_ = problem + ' ' + with + ", in tick " + std::to_string(number);
        return;
      }
      ++number;
    }
  }
  /// A combination of values that the model does not accept.
  void count_refusal() { ++refused_; }

  bool has_failed() const { return !problem_.empty(); }
  std::string text() const {
    if (has_failed()) return problem_;
    std::string text = counted(ticks_, "tick", "ticks");
    if (refused_ > 0) {
      text += "; " + counted(refused_, "combination", "combinations") + " refused by the model";
    }
    return text;
  }

 private:
  const ForceModel& model_;
  std::size_t ticks_ = 0;
  std::size_t refused_ = 0;
  std::string problem_{};
};

}  // namespace

ConformanceCheck finite_check(const ForceModel& model, const RendererInputs& inputs,
                              const ConformanceCourse& course) {
  FiniteRuns runs(model);
  RendererInputs at_limits = inputs;
  at_limits.material.friction = 0.3;
  if (!model.declaration.needs_bodies) at_limits.patch.extent_m = {0.04, 0.04};
  const std::vector<ProbeState> path = wandering(model, 0.3);
  for (const ParameterValues& values : values_at_limits(model)) {
    if (runs.has_failed() || course.stop.stop_requested()) break;
    at_limits.parameters = values;
    try {
      runs.run(at_limits, path,
               values.empty() ? "with default parameters" : condition_text(values));
    } catch (const std::invalid_argument&) {
      if (values.empty()) throw;
      runs.count_refusal();  // values that contradict each other or the defaults
    }
  }
  if (!model.declaration.needs_bodies && !runs.has_failed() && !course.stop.stop_requested()) {
    RendererInputs on_sphere = inputs;
    on_sphere.material.friction = 0.3;
    on_sphere.body =
        std::make_shared<const BodySurface>(body_mesh(SphereShape{kConformanceSphere_m}, nullptr));
    try {
      runs.run(on_sphere, around_sphere(1.0), "with default parameters on a sphere");
    } catch (const std::invalid_argument&) {
      runs.count_refusal();  // a texture that is too high for a body
    }
  }
  return {.name = "finite",
          .result = runs.has_failed() ? Conformance::violated : Conformance::met,
          .measured = runs.text(),
          .required = "finite, no negative penetration, no force without contact"};
}

}  // namespace asperity
