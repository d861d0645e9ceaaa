// Declares the conformance suite of force models.

#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "renderers/force/force_model.h"

namespace asperity {

/// The result of one check of a model.
enum class Conformance {
  met,
  violated,
  not_applicable,  ///< the check has no meaning for this model; `measured` states the reason
};

struct ConformanceCheck {
  std::string_view name{};  ///< `[a-z_]+`; points to a literal
  Conformance result = Conformance::met;
  std::string measured{};
  std::string required{};
};

/// The median time of a tick that a model may need: half the period of a servo loop of 1 kHz. The other half is left for the
/// device and for ticks with cold caches.
inline constexpr double kLongestMedianTick_s = 5e-4;

/// How a run of the suite can be followed and stopped.
struct ConformanceCourse {
  std::stop_token stop{};
  std::function<void(double)> progress{};  ///< receives 0 to 1; may be empty
};

/// Checks a force model, built-in or of a plug-in, against what every part of the program relies on. One row per check, in
/// this order:
///
///   zero_amplitude  with the amplitude parameter at 0 and without friction, a stroke at depth d has the force k·d along +z and
///                   the penetration d: the plate without texture. Not of models with two bodies or with their own law of
///                   indentation
///   deterministic   two renderers with the same inputs, and one that is reset, give the same bits on the same path
///   finite          force, torque and penetration are finite as stored (rendered_tick.h), the penetration is not negative, and
///                   there is no force without contact: on a path into and out of contact and across the border of the patch, up to 1 m/s, with every
///                   parameter of the model at its lower and its upper limit, and with 16 combinations of limits of all
///                   parameters; a point model also on a sphere
///   no_allocation   `reset` and `tick` make no heap calls
///   band            at 40 mm/s at least 85 % of the power of the varying force lies below twice the declared band. The rest is
///                   left for harmonics and for the side lobes of held noise, which a band does not include
///   time_per_tick   the median time of a tick at 1 kHz is at most kLongestMedianTick_s
///
/// All use a stiffness of 1 kN/m and no friction (except `finite`), and where the model needs it a grating of 2 mm, the files
/// that the model makes of that grating, or a ball of 2 mm on a plate with it. A check that cannot make or run a renderer is
/// violated and states the error.
///
/// The time is measured with the monotonic clock; all other rows are deterministic. When a stop is requested, the checks made until
/// then are returned, of which the last one may be incomplete. Threads: one at a time.
std::vector<ConformanceCheck> conformance_of(const ForceModel& model,
                                             const ConformanceCourse& course = {});

/// Whether no check is violated.
bool is_conformant(const std::vector<ConformanceCheck>& checks);

}  // namespace asperity
