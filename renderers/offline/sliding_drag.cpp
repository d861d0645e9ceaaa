// Implements the comparison of a law's drag with that of Coulomb along strokes to and fro.

#include "renderers/offline/sliding_drag.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "device/refusal.h"
#include "renderers/force/friction.h"
#include "renderers/offline/along_path.h"

namespace asperity {
namespace {

constexpr const char* kLawName = "friction_law";
constexpr int kDroppedStrokes = 2;
// The modulation begins so many times SlidingDrag's path behind a reversal, and strokes are so many times this path long.
constexpr double kTurned = 3.0;
constexpr double kLeastLengths = 4.0;
constexpr int kRounds = 4;
// A variation below this part of the mean is rounding.
constexpr double kNoVariation = 1e-9;

// The friction of each sample against the direction of motion, and how far behind a reversal it is.
struct FrictionAlong {
  std::vector<double> drag_N{};
  std::vector<double> behind_m{};
};

std::vector<ProbeState> samples_of_strokes(const SlidingStrokes& strokes, const SurfacePatch& patch,
                                           double height_m) {
  const double duration_s = strokes.strokes * strokes.length_m / strokes.speed_m_per_s;
  std::vector<ProbeState> samples(static_cast<std::size_t>(duration_s * strokes.rate_Hz));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time_s = static_cast<double>(i) / strokes.rate_Hz;
    const double along_m = std::fmod(strokes.speed_m_per_s * time_s, 2.0 * strokes.length_m);
    const bool is_back = along_m >= strokes.length_m;
    samples[i].time_ns = std::llround(time_s * 1e9);
    samples[i].position_m = {patch.centre_m.x - 0.5 * strokes.length_m +
                                 (is_back ? 2.0 * strokes.length_m - along_m : along_m),
                             patch.centre_m.y, height_m};
    samples[i].velocity_m_per_s = {is_back ? -strokes.speed_m_per_s : strokes.speed_m_per_s, 0.0,
                                   0.0};
  }
  return samples;
}

// The strokes, and the force along x of the stimulus without friction, to which each law is compared.
struct FrictionlessStrokes {
  std::vector<ProbeState> samples{};
  std::vector<RenderedTick> ticks{};
};

FrictionlessStrokes without_friction(const ForceModel& model, RendererInputs inputs,
                                     const SlidingStrokes& strokes) {
  inputs.material.friction = 0.0;
  const double height_m =
      inputs.patch.centre_m.z - strokes.normal_force_N / inputs.material.stiffness_N_per_m;
  FrictionlessStrokes without{.samples = samples_of_strokes(strokes, inputs.patch, height_m)};
  without.ticks = along_path(*make_renderer(model, inputs), without.samples, strokes.rate_Hz);
  return without;
}

FrictionAlong friction_along(const ForceModel& model, const RendererInputs& inputs,
                             const SlidingStrokes& strokes, const FrictionlessStrokes& without) {
  const auto with = along_path(*make_renderer(model, inputs), without.samples, strokes.rate_Hz);
  FrictionAlong friction{};
  for (std::size_t i = 0; i < with.size(); ++i) {
    const double travelled_m = strokes.speed_m_per_s * static_cast<double>(i) / strokes.rate_Hz;
    if (travelled_m < kDroppedStrokes * strokes.length_m) continue;
    const double direction = without.samples[i].velocity_m_per_s.x > 0.0 ? 1.0 : -1.0;
    friction.drag_N.push_back(direction *
                              (without.ticks[i].wrench.force_N.x - with[i].wrench.force_N.x));
    friction.behind_m.push_back(std::fmod(travelled_m, strokes.length_m));
  }
  return friction;
}

double mean_behind(const FrictionAlong& friction, double behind_m) {
  double sum_N = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < friction.drag_N.size(); ++i) {
    if (friction.behind_m[i] < behind_m) continue;
    sum_N += friction.drag_N[i];
    ++count;
  }
  return count == 0 ? 0.0 : sum_N / static_cast<double>(count);
}

double modulation_of(const FrictionAlong& friction, const FrictionAlong& coulomb, double behind_m) {
  const double mean_N = mean_behind(friction, behind_m);
  const double coulomb_N = mean_behind(coulomb, behind_m);
  double both_N2 = 0.0;
  double squares_N2 = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < friction.drag_N.size(); ++i) {
    if (friction.behind_m[i] < behind_m) continue;
    const double varies_N = coulomb.drag_N[i] - coulomb_N;
    both_N2 += (friction.drag_N[i] - mean_N) * varies_N;
    squares_N2 += varies_N * varies_N;
    ++count;
  }
  const double least_N = kNoVariation * coulomb_N;
  return squares_N2 > count * least_N * least_N ? both_N2 / squares_N2 : 1.0;
}

}  // namespace

SlidingDrag sliding_drag(const ForceModel& model, const RendererInputs& inputs,
                         const SlidingStrokes& strokes) {
  require_positive("SlidingStrokes::speed_m_per_s", strokes.speed_m_per_s);
  require_positive("SlidingStrokes::normal_force_N", strokes.normal_force_N);
  require_positive("SlidingStrokes::length_m", strokes.length_m);
  require_positive("SlidingStrokes::rate_Hz", strokes.rate_Hz);
  RendererInputs with_law = inputs;
  with_law.parameters = complete_values(model.declaration, inputs.parameters);
  if (!with_law.parameters.contains(kLawName)) {
    throw std::invalid_argument("the force model " + model.declaration.id +
                                " has no law of friction to be compared");
  }
  with_law.patch.edge = PatchEdge::wall;  // never reached
  with_law.patch.tiling = Tiling::repeat;
  const double stiffness_N_per_m =
      friction_law_of(with_law.parameters)
          .near_rest(friction_settings(with_law.material.friction, with_law.parameters),
                     strokes.normal_force_N, 1.0 / strokes.rate_Hz)
          .stiffness_N_per_m;
  // D = μ·F_n·v/√(v² + v₀²) at the constant speed v.
  const double full = std::hypot(
      1.0, number_of(with_law.parameters, "friction_speed_m_per_s") / strokes.speed_m_per_s);
  SlidingStrokes stroked = strokes;
  FrictionlessStrokes without{};
  FrictionAlong coulomb{};
  double behind_m = 0.0;
  // The mean normal force is known behind the first strokes only; a texture may make it several times the nominal one. Longer
  // strokes have about the same mean, so that a second round is enough but for chance.
  for (int round = 0; round < kRounds; ++round) {
    stroked.length_m = std::max(stroked.length_m, kLeastLengths * behind_m);
    with_law.patch.extent_m = glm::dvec2(4.0 * stroked.length_m);
    RendererInputs by_coulomb = with_law;
    by_coulomb.parameters[kLawName] = std::string("rounded");
    without = without_friction(model, with_law, stroked);
    coulomb = friction_along(model, by_coulomb, stroked, without);
    for (double& drag_N : coulomb.drag_N) drag_N *= full;
    behind_m = stiffness_N_per_m > 0.0 ? 2.0 * mean_behind(coulomb, 0.0) / stiffness_N_per_m : 0.0;
    if (stroked.length_m > kTurned * behind_m) break;
  }
  const FrictionAlong friction = friction_along(model, with_law, stroked, without);
  return {.mean_N = mean_behind(friction, behind_m),
          .coulomb_N = mean_behind(coulomb, behind_m),
          .modulation = modulation_of(friction, coulomb, kTurned * behind_m)};
}

}  // namespace asperity
