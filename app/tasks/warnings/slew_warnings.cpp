// Strokes each stimulus at the greatest speed and force of its exploration, and touches down on it, through the limiter.

#include "app/tasks/warnings/slew_warnings.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <set>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
#include "device/force_limiter.h"
#include "device/probe_state.h"
#include "device/virtual_hand.h"
#include "protocols/design/wording.h"

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
constexpr int kTouchDowns = 8;      // along a stroke
constexpr double kFar = 0.5;        // of the limits: Nearness::far

double greatest(const Band& band, double otherwise) {
  if (band.maximum) return *band.maximum;
  if (band.target) return *band.target;
  return band.minimum.value_or(otherwise);
}

/// A motion in a straight line, from the reset of the renderer and the limiter on.
struct Motion {
  glm::dvec3 from_m{0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  int ticks = 0;
  double rate_Hz = 1000.0;
};

/// Across the middle of the patch; `direction` is 1 or −1.
Motion stroke_of(const PreparedStimulus& stimulus, const Protocol& protocol,
                 const Exploration& exploration, double speed_m_per_s, double direction) {
  const SurfacePatch& patch = stimulus.inputs.patch;
  const glm::dvec3 along = direction * glm::dvec3(std::cos(exploration.direction_rad),
                                                  std::sin(exploration.direction_rad), 0.0);
  const double length_m =
      std::min(kInside * std::min(patch.extent_m.x, patch.extent_m.y), kLongest_s * speed_m_per_s);
  Motion stroke{};
  stroke.from_m = patch.centre_m - 0.5 * length_m * along;
  stroke.velocity_m_per_s = speed_m_per_s * along;
  stroke.ticks = static_cast<int>(std::ceil(length_m / speed_m_per_s * protocol.rate_Hz));
  stroke.rate_Hz = protocol.rate_Hz;
  return stroke;
}

/// What a limiter changes of a force.
struct LimitedBy {
  bool whole = false;  ///< the limiter of a device
  bool half = false;   ///< one that permits half of its growth
};

/// Calls `tick` with the number of each tick, the rendered force and whether limiters change it.
template <typename Tick>
void move(ForceRenderer& renderer, const Motion& motion, double limit_N, const Tick& tick) {
  ForceLimits limits{};
  limits.force_N = limit_N;
  ForceLimiter limiter(limits);
  limits.slew_N *= kFar;
  limits.slew_N_m *= kFar;
  ForceLimiter half_limiter(limits);
  ProbeState probe{};
  probe.velocity_m_per_s = motion.velocity_m_per_s;
  for (int i = 0; i < motion.ticks; ++i) {
    const double time_s = i / motion.rate_Hz;
    probe.time_ns = std::llround(1e9 * time_s);
    probe.position_m = motion.from_m + time_s * motion.velocity_m_per_s;
    if (i == 0) renderer.reset(probe);
    const Wrench wrench = renderer.tick(probe, 1.0 / motion.rate_Hz).wrench;
    const auto changes = [&](ForceLimiter& one) {
      return one.limit(wrench, 1.0 / motion.rate_Hz).has(LimitReason::slew);
    };
    tick(i, wrench, LimitedBy{.whole = changes(limiter), .half = changes(half_limiter)});
  }
}

/// What the limiter does to the part of a stroke in which friction and filters have settled.
struct Slew {
  double mean_normal_force_N = 0.0;
  int limited_ticks = 0;
  int near_ticks = 0;  ///< limited at half the growth
  int ticks = 0;
};

Slew slew_of(ForceRenderer& renderer, const Motion& stroke, double depth_m, double limit_N) {
  Motion pressed = stroke;
  pressed.from_m.z -= depth_m;
  Slew slew{};
  const int settled = static_cast<int>(kSettled * stroke.ticks);
  move(renderer, pressed, limit_N, [&](int i, const Wrench& wrench, const LimitedBy& limited) {
    if (i < settled) return;
    ++slew.ticks;
    slew.mean_normal_force_N += wrench.force_N.z;
    slew.limited_ticks += limited.whole ? 1 : 0;
    slew.near_ticks += limited.half ? 1 : 0;
  });
  slew.mean_normal_force_N /= std::max(1, slew.ticks);
  return slew;
}

/// The stroke at the depth at which the mean normal force is `force_N`, or at the deepest.
Slew slew_at_force(const PreparedStimulus& stimulus, const Motion& stroke, double force_N,
                   double limit_N) {
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(*stimulus.model, stimulus.inputs);
  Motion sparse = stroke;
  sparse.ticks = std::min(kPlaces, stroke.ticks);
  sparse.rate_Hz = stroke.rate_Hz * sparse.ticks / stroke.ticks;
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

/// How many of kTouchDowns along the middle of a stroke a limiter changes, down to the depth of a force.
struct TouchDowns {
  int limited = 0;
  int near = 0;  ///< limited at half the growth
};

TouchDowns limited_touch_downs(const PreparedStimulus& stimulus, const Motion& stroke,
                               double force_N, double limit_N) {
  const HandHabits habits{};
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(*stimulus.model, stimulus.inputs);
  const double depth_m = force_N / stimulus.inputs.material.stiffness_N_per_m;
  Motion down{};
  down.velocity_m_per_s = {0.0, 0.0, -habits.approach_speed_m_per_s};
  down.rate_Hz = stroke.rate_Hz;
  down.ticks = static_cast<int>(
      std::ceil((habits.lift_height_m + depth_m) / habits.approach_speed_m_per_s * stroke.rate_Hz));
  TouchDowns touch_downs{};
  for (int place = 0; place < kTouchDowns; ++place) {
    const double time_s = (place + 0.5) / kTouchDowns * stroke.ticks / stroke.rate_Hz;
    down.from_m = stroke.from_m + time_s * stroke.velocity_m_per_s;
    down.from_m.z += habits.lift_height_m;
    LimitedBy one{};
    move(*renderer, down, limit_N, [&](int, const Wrench&, const LimitedBy& limited) {
      one.whole = one.whole || limited.whole;
      one.half = one.half || limited.half;
    });
    touch_downs.limited += one.whole ? 1 : 0;
    touch_downs.near += one.half ? 1 : 0;
  }
  return touch_downs;
}

struct LimitedMotions {
  /// "3 of 900 ticks of strokes at 300 mm/s and 1 N and in 8 of 8 touch-downs at 50 mm/s"; empty if nothing is limited.
  Phrase text{};
  Nearness nearness = Nearness::far;
};

LimitedMotions limited_motions(const PreparedStimulus& stimulus, const Protocol& protocol,
                               const Exploration& exploration) {
  const double speed_m_per_s = greatest(exploration.speed_m_per_s, kSpeed_m_per_s);
  const double force_N =
      std::min(greatest(exploration.normal_force_N, kForce_N), protocol.force_limit_N);
  if (!(speed_m_per_s > 0.0 && force_N > 0.0)) return {};
  Slew slew{};
  for (const double direction : {1.0, -1.0}) {
    const Slew one = slew_at_force(
        stimulus, stroke_of(stimulus, protocol, exploration, speed_m_per_s, direction), force_N,
        protocol.force_limit_N);
    slew.limited_ticks += one.limited_ticks;
    slew.near_ticks += one.near_ticks;
    slew.ticks += one.ticks;
  }
  const TouchDowns touch_downs =
      limited_touch_downs(stimulus, stroke_of(stimulus, protocol, exploration, speed_m_per_s, 1.0),
                          force_N, protocol.force_limit_N);
  LimitedMotions motions{.nearness = slew.near_ticks + touch_downs.near > 0 ? Nearness::near
                                                                            : Nearness::far};
  if (slew.limited_ticks > 0) {
    motions.text = phrase("Protocols", "%1 of %2 ticks of strokes at %3 mm/s and %4 N")
                       .with(std::to_string(slew.limited_ticks), std::to_string(slew.ticks),
                             number_text(1000.0 * speed_m_per_s), number_text(force_N));
  }
  if (touch_downs.limited > 0) {
    const Phrase limited =
        phrase("Protocols", "%1 of %2 touch-downs at %3 mm/s")
            .with(std::to_string(touch_downs.limited), std::to_string(kTouchDowns),
                  number_text(1000.0 * HandHabits{}.approach_speed_m_per_s));
    motions.text = motions.text.empty()
                       ? limited
                       : phrase("Protocols", "%1 and in %2").with(motions.text, limited);
  }
  return motions;
}

}  // namespace

std::vector<Diagnostic> warnings_about_slew(const CheckedProtocol& checked,
                                            StimulusBuilder& builder, const StimuliCourse& course) {
  const Protocol& protocol = checked.protocol;
  std::vector<Diagnostic> warnings{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for_each_stimulus_near_limit(
      protocol, checked.trials(), course, [&](const ExploredStimulus& one) {
        const StimulusDescription& stimulus = one.planned.stimulus;
        if (stimulus.surface || stimulus.tool || !builder.can_make(stimulus)) return Nearness::far;
        const std::string where = one.planned.stimulus_template + '\n' + one.exploration.name;
        if (reported.contains(where)) return Nearness::far;
        LimitedMotions motions{};
        try {
          motions = limited_motions(builder.prepare(one.planned), protocol, one.exploration);
        } catch (const std::exception&) {  // the session's preparation reports it
          return Nearness::near;
        }
        if (motions.text.empty()) return motions.nearness;
        reported.insert(where);
        warnings.push_back(checked.at_stimulus(
            one.planned.stimulus_template,
            phrase("Protocols",
                   "the force of the stimulus %1 (model %2) would be limited in %3 in the "
                   "exploration %4: within a millisecond it would grow or turn by more than %5 N, "
                   "and another texture would be felt; lower the amplitude, the stiffness or the "
                   "speed")
                .with(in_quotes(stimulus.name), stimulus.model, motions.text,
                      in_quotes(one.exploration.name), number_text(ForceLimits{}.slew_N))));
        return motions.nearness;
      });
  return warnings;
}

}  // namespace asperity
