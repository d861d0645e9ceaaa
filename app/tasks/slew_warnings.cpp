// Strokes each stimulus at the greatest speed and force of its exploration, through the limiter.

#include "app/tasks/slew_warnings.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <glm/geometric.hpp>

#include "analysis/number_text.h"
#include "device/force_limiter.h"
#include "device/probe_state.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"

namespace asperity {
namespace {

constexpr double kForce_N = 1.0;
constexpr double kSpeed_m_per_s = 0.3;
constexpr double kDeepest_m = 0.02;
constexpr int kHalvings = 16;
constexpr double kInside = 0.8;     // of the patch: within its border, where a force may fade
constexpr double kSettled = 0.25;   // of a stroke: friction and filters have settled
constexpr double kLongest_s = 0.5;  // of a stroke
constexpr int kPlaces = 64;         // of a stroke, at which the depth for a force is sought

double greatest(const Band& band, double otherwise) {
  if (band.maximum) return *band.maximum;
  if (band.target) return *band.target;
  return band.minimum.value_or(otherwise);
}

/// A stroke across the middle of the patch.
struct Stroke {
  glm::dvec3 from_m{0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  int ticks = 0;
  double rate_Hz = 1000.0;

  double duration_s() const { return ticks / rate_Hz; }
};

/// `direction` is 1 or −1.
Stroke stroke_of(const PreparedStimulus& stimulus, const Protocol& protocol,
                 const Exploration& exploration, double speed_m_per_s, double direction) {
  const SurfacePatch& patch = stimulus.inputs.patch;
  const glm::dvec3 along = direction * glm::dvec3(std::cos(exploration.direction_rad),
                                                  std::sin(exploration.direction_rad), 0.0);
  const double length_m =
      std::min(kInside * std::min(patch.extent_m.x, patch.extent_m.y), kLongest_s * speed_m_per_s);
  Stroke stroke{};
  stroke.from_m = patch.centre_m - 0.5 * length_m * along;
  stroke.velocity_m_per_s = speed_m_per_s * along;
  stroke.ticks = static_cast<int>(std::ceil(length_m / speed_m_per_s * protocol.rate_Hz));
  stroke.rate_Hz = protocol.rate_Hz;
  return stroke;
}

/// What the limiter does to the part of a stroke in which friction and filters have settled.
struct Slew {
  double mean_normal_force_N = 0.0;
  int limited_ticks = 0;
  int ticks = 0;
};

Slew slew_of(ForceRenderer& renderer, const Stroke& stroke, double depth_m, double limit_N) {
  ForceLimits limits{};
  limits.force_N = limit_N;
  ForceLimiter limiter(limits);
  ProbeState probe{};
  probe.velocity_m_per_s = stroke.velocity_m_per_s;
  Slew slew{};
  const int settled = static_cast<int>(kSettled * stroke.ticks);
  for (int i = 0; i < stroke.ticks; ++i) {
    const double time_s = i / stroke.rate_Hz;
    probe.time_ns = std::llround(1e9 * time_s);
    probe.position_m = stroke.from_m + time_s * stroke.velocity_m_per_s;
    probe.position_m.z -= depth_m;
    if (i == 0) renderer.reset(probe);
    const Wrench wrench = renderer.tick(probe, 1.0 / stroke.rate_Hz).wrench;
    const LimitedWrench limited = limiter.limit(wrench, 1.0 / stroke.rate_Hz);
    if (i < settled) continue;
    ++slew.ticks;
    slew.mean_normal_force_N += wrench.force_N.z;
    slew.limited_ticks += limited.has(LimitReason::slew) ? 1 : 0;
  }
  slew.mean_normal_force_N /= std::max(1, slew.ticks);
  return slew;
}

/// The stroke at the depth at which the mean normal force is `force_N`, or at the deepest.
Slew slew_at_force(const PreparedStimulus& stimulus, const Stroke& stroke, double force_N,
                   double limit_N) {
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(*stimulus.model, stimulus.inputs);
  Stroke sparse = stroke;
  sparse.ticks = std::min(kPlaces, stroke.ticks);
  sparse.rate_Hz = sparse.ticks / stroke.duration_s();
  double shallow_m = 0.0;
  double deep_m = std::max(kDeepest_m, 2.0 * force_N / stimulus.inputs.material.stiffness_N_per_m);
  if (slew_of(*renderer, sparse, deep_m, limit_N).mean_normal_force_N >= force_N) {
    for (int i = 0; i < kHalvings; ++i) {
      const double middle_m = 0.5 * (shallow_m + deep_m);
      const Slew found = slew_of(*renderer, sparse, middle_m, limit_N);
      (found.mean_normal_force_N < force_N ? shallow_m : deep_m) = middle_m;
    }
  }
  return slew_of(*renderer, stroke, deep_m, limit_N);
}

}  // namespace

std::vector<Diagnostic> warnings_about_slew(const Protocol& protocol, const std::string& file_name,
                                            StimulusBuilder& builder) {
  std::vector<Diagnostic> warnings{};
  std::set<std::string> compared{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for (const Trial& trial : possible_trials(protocol)) {
    const Exploration& exploration = exploration_of(protocol, trial);
    const double speed_m_per_s = greatest(exploration.speed_m_per_s, kSpeed_m_per_s);
    const double force_N =
        std::min(greatest(exploration.normal_force_N, kForce_N), protocol.force_limit_N);
    if (!(speed_m_per_s > 0.0 && force_N > 0.0)) continue;
    for (const PlannedPresentation& planned : trial.presentations) {
      const StimulusDescription& stimulus = planned.stimulus;
      if (stimulus.surface || stimulus.tool || !builder.can_make(stimulus)) continue;
      if (!compared.insert(stimulus.name + '\n' + exploration.name).second) continue;
      const std::string where = planned.stimulus_template + '\n' + exploration.name;
      if (reported.contains(where)) continue;
      const PreparedStimulus prepared = builder.unmatched(stimulus);
      Slew slew{};
      for (const double direction : {1.0, -1.0}) {
        const Slew one = slew_at_force(
            prepared, stroke_of(prepared, protocol, exploration, speed_m_per_s, direction), force_N,
            protocol.force_limit_N);
        slew.limited_ticks += one.limited_ticks;
        slew.ticks += one.ticks;
      }
      if (slew.limited_ticks == 0) continue;
      reported.insert(where);
      warnings.push_back(place_of_stimulus(protocol, file_name, planned.stimulus_template));
      warnings.back().message =
          "the force of the stimulus \"" + stimulus.name + "\" (model " +
          prepared.model->declaration.id + ") would be limited in " +
          std::to_string(slew.limited_ticks) + " of " + std::to_string(slew.ticks) +
          " ticks of strokes at " + number_text(1000.0 * speed_m_per_s) + " mm/s and " +
          number_text(force_N) + " N in the exploration \"" + exploration.name +
          "\": within a millisecond it would grow or turn by more than " +
          number_text(ForceLimits{}.slew_N) +
          " N, and another texture would be felt; lower the amplitude, the stiffness or the speed";
    }
  }
  return warnings;
}

}  // namespace asperity
