// Implements two nested root searches: for the height with the mean force, and for the amplitude with the RMS.

#include "renderers/offline/force_matching.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/signals/spectrum.h"
#include "device/refusal.h"
#include "renderers/force/friction.h"
#include "renderers/force/indentation_law.h"
#include "renderers/offline/along_path.h"
#include "renderers/offline/bracketed_root.h"
#include "renderers/offline/constant_height.h"

namespace asperity {
namespace {

/// How closely the two searches find their forces.
struct Accuracy {
  double of_height = HeightSearch{}.tolerance;
  int height_bits = HeightSearch{}.height_bits;
  double of_rms = 1e-9;
  int amplitude_bits = 50;  // nearly all of them
};
/// Of contacts that are solved by iterations: their force has steps of up to a thousandth between heights.
constexpr Accuracy kOfIterations{
    .of_height = 1e-3, .height_bits = 12, .of_rms = 5e-3, .amplitude_bits = 14};

Accuracy accuracy_of(const ForceRenderer& renderer) {
  return dynamic_cast<const IndentationLaw*>(&renderer) == nullptr ? Accuracy{} : kOfIterations;
}

std::string text_of(double value) {
  char characters[32];
  const auto end = std::to_chars(characters, characters + sizeof characters, value,
                                 std::chars_format::general, 6);
  return {characters, end.ptr};
}

// The path's samples at a variable height. The renderer also receives the dropped samples.
class Strokes {
 public:
  Strokes(const TextureForcePath& path, const SurfacePatch& patch)
      : rate_Hz_(path.rate_Hz),
        kept_from_(static_cast<std::size_t>(std::lround(path.dropped_s * path.rate_Hz))),
        plane_m_(patch.centre_m.z) {
    const auto count = static_cast<std::size_t>(std::lround(path.duration_s * path.rate_Hz));
    const double start_m = patch.centre_m.x - 0.5 * path.speed_m_per_s * path.duration_s;
    samples_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double time_s = static_cast<double>(i) / path.rate_Hz;
      samples_[i].time_ns = std::llround(time_s * 1e9);
      samples_[i].position_m = {start_m + path.speed_m_per_s * time_s, patch.centre_m.y, plane_m_};
      samples_[i].velocity_m_per_s = {path.speed_m_per_s, 0.0, 0.0};
    }
  }

  // The forces at a height over the plane, without the dropped ones.
  std::vector<glm::dvec3> forces_N(ForceRenderer& renderer, double height_m) {
    for (ProbeState& sample : samples_) sample.position_m.z = plane_m_ + height_m;
    const std::vector<RenderedTick> ticks = along_path(renderer, samples_, rate_Hz_);
    std::vector<glm::dvec3> forces_N;
    forces_N.reserve(ticks.size() - kept_from_);
    for (std::size_t i = kept_from_; i < ticks.size(); ++i) {
      forces_N.push_back(ticks[i].wrench.force_N);
    }
    return forces_N;
  }

 private:
  double rate_Hz_ = 0.0;
  std::size_t kept_from_ = 0;
  double plane_m_ = 0.0;
  std::vector<ProbeState> samples_{};
};

double mean_normal_N(std::span<const glm::dvec3> forces_N) {
  double sum_N = 0.0;
  for (const glm::dvec3& force_N : forces_N) sum_N += force_N.z;
  return sum_N / static_cast<double>(forces_N.size());
}

// The height over the plane at which the mean normal force is the path's.
double height_of(const ForceModel& model, ForceRenderer& renderer, Strokes& strokes,
                 const RendererInputs& inputs, const TextureForcePath& path) {
  const Accuracy accuracy = accuracy_of(renderer);
  const auto* const law = dynamic_cast<const IndentationLaw*>(&renderer);
  const ConstantHeight found = constant_height(
      [&](double height_m) { return mean_normal_N(strokes.forces_N(renderer, height_m)); },
      {.force_N = path.mean_normal_force_N,
       .stiffness_N_per_m = law == nullptr
                                ? inputs.material.stiffness_N_per_m
                                : law->indentation_stiffness_N_per_m(path.mean_normal_force_N),
       .tolerance = accuracy.of_height,
       .height_bits = accuracy.height_bits});
  if (found.height_m) return *found.height_m;
  throw std::invalid_argument(
      "the force model " + model.declaration.id + " has a mean normal force of " +
      text_of(path.mean_normal_force_N) +
      " N at no constant height; the nearest mean normal force is " + text_of(found.reached_N) +
      " N; change the stiffness of the material or the parameters of the model");
}

// Friction of the laws without a memory is constant on a plate, and constants are not part of the texture force. That of
// the others builds up on the way, which is the same with texture and without.
bool is_constant_at_constant_speed(const ParameterValues& parameters) {
  return !friction_law_of(parameters).remembers;
}

void check(const TextureForcePath& path) {
  require_positive("TextureForcePath::speed_m_per_s", path.speed_m_per_s);
  require_positive("TextureForcePath::rate_Hz", path.rate_Hz);
  require_positive("TextureForcePath::mean_normal_force_N", path.mean_normal_force_N);
  if (!(path.dropped_s >= 0.0 && path.dropped_s + 2.0 / path.rate_Hz < path.duration_s)) {
    throw std::invalid_argument("TextureForcePath::dropped_s must be shorter than the path of " +
                                text_of(path.duration_s) + " s, but it is " +
                                text_of(path.dropped_s));
  }
}

const Parameter& amplitude_of(const ModelDeclaration& declaration) {
  for (const Parameter& parameter : declaration.parameters) {
    if (parameter.name == declaration.amplitude_parameter) return parameter;
  }
  throw std::invalid_argument(
      "the force model " + declaration.id +
      " declares no amplitude parameter to solve for; use a model that declares one");
}

}  // namespace

double texture_force_rms_N(const ForceModel& model, const RendererInputs& inputs,
                           const TextureForcePath& path) {
  check(path);
  RendererInputs textured = inputs;
  const double length_m = path.speed_m_per_s * path.duration_s;
  textured.patch.edge = PatchEdge::wall;  // never reached
  textured.patch.extent_m = {2.0 * length_m, 2.0 * length_m};
  textured.patch.tiling = Tiling::repeat;

  Strokes strokes(path, textured.patch);
  const auto renderer = make_renderer(model, textured);
  const double height_m = height_of(model, *renderer, strokes, textured, path);
  RendererInputs untextured = without_texture(model.declaration, textured);
  if (!is_constant_at_constant_speed(textured.parameters)) {
    untextured.material.friction = textured.material.friction;
  }
  const auto plate = make_renderer(model, untextured);
  const std::vector<glm::dvec3> with_N = strokes.forces_N(*renderer, height_m);
  const std::vector<glm::dvec3> without_N = strokes.forces_N(*plate, height_m);

  double mean_square_N2 = 0.0;
  std::vector<double> difference_N(with_N.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < with_N.size(); ++i) {
      difference_N[i] = with_N[i][axis] - without_N[i][axis];
    }
    mean_square_N2 += std::pow(band_rms(difference_N, path.rate_Hz, path.low_Hz, path.high_Hz), 2);
  }
  if (!std::isfinite(mean_square_N2)) {
    const std::string reason(renderer->error().empty() ? plate->error() : renderer->error());
    throw std::invalid_argument(
        "the force model " + model.declaration.id +
        " computes a force that is not finite on the path of equal texture force" +
        (reason.empty() ? "" : " (" + reason + ')') + "; correct the model or its parameters");
  }
  return std::sqrt(mean_square_N2);
}

SolvedAmplitude solve_amplitude(const ForceModel& model, const RendererInputs& inputs,
                                double target_rms_N, const TextureForcePath& path) {
  require_positive("target_rms_N", target_rms_N);
  const Parameter& amplitude = amplitude_of(model.declaration);
  const Accuracy accuracy = accuracy_of(*make_renderer(model, inputs));
  RendererInputs candidate = inputs;
  const auto rms_N = [&](double value) {
    candidate.parameters[amplitude.name] = value;
    return texture_force_rms_N(model, candidate, path);
  };
  const auto excess = [&](double value) { return rms_N(value) / target_rms_N - 1.0; };

  double start = number_of(complete_values(model.declaration, inputs.parameters), amplitude.name);
  if (start <= amplitude.minimum) start = std::get<double>(amplitude.default_value);
  Bracket value{amplitude.minimum, start};
  Bracket excesses{excess(value.low), excess(value.high)};
  while (excesses.high < 0.0 && value.high < amplitude.maximum) {
    value = {value.high, std::min(2.0 * value.high, amplitude.maximum)};
    excesses = {excesses.high, excess(value.high)};
  }
  if (excesses.low <= 0.0 && excesses.high >= 0.0) {
    const double solved = root_of(excess, value, excesses, accuracy.amplitude_bits);
    const double solved_rms_N = rms_N(solved);
    if (std::abs(solved_rms_N / target_rms_N - 1.0) <= accuracy.of_rms) {
      return {amplitude.name, solved, solved_rms_N};
    }
  }
  throw std::invalid_argument(
      "the force model " + model.declaration.id + " cannot have a texture force of " +
      text_of(target_rms_N) + " N RMS: its " + amplitude.name + " ranges from " +
      text_of(amplitude.minimum) + " to " + text_of(amplitude.maximum) +
      (amplitude.unit == "1" ? "" : " " + amplitude.unit) + ", which gives a texture force of " +
      text_of(rms_N(amplitude.minimum)) + " and " + text_of(rms_N(amplitude.maximum)) +
      " N RMS; request a force within this range");
}

}  // namespace asperity
