// Lists every stimulus that the sessions of a protocol can present, with each of its explorations.

#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>

#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity {

/// For a caller that waits: to examine all stimuli of a protocol may take minutes.
struct StimuliCourse {
  std::stop_token stop{};                  ///< what was not examined before is left out
  std::function<void(double)> progress{};  ///< 0 to 1; may be empty
};

/// A stimulus that a session can present, and how it is explored.
struct ExploredStimulus {
  const Trial& trial;  ///< the first that presents it
  const PlannedPresentation& planned;
  const Exploration& exploration;
  std::size_t index = 0;  ///< in the order of the trials
};

/// Calls `examine` for every stimulus that a session of the protocol can present (`trials`: possible_trials), once for each of its
/// explorations, in the order of the trials. Two stimuli of one name are different where factors or roving choose other
/// parameters, materials, bodies or files for them.
///
/// Errors: those of `examine`.
void for_each_stimulus(const Protocol& protocol, std::span<const Trial> trials,
                       const StimuliCourse& course,
                       const std::function<void(const ExploredStimulus&)>& examine);

/// How near a stimulus is to the limit of a warning.
enum class Nearness {
  far,   ///< at most half of the limit
  near,  ///< more than that, or beyond the limit
};

/// As `for_each_stimulus`, for a warning about a quantity with a limit; of the levels of a varied parameter (level_of) only
/// those that may be beyond it. Of one stimulus in one exploration the lowest level is examined, the highest, and the one in the
/// middle of their order; then each half in the same manner, unless both of its ends are far from the limit.
///
/// A quantity that only rises or only falls with the level is greatest at an end of each half: none of the levels that are left
/// out is beyond the limit. This is so where the level multiplies the force of every motion, as a Young's modulus does, or its
/// texture. A quantity that rises and falls again, as at a resonance, would have to more than double and to fall by half between
/// two ends to be missed.
void for_each_stimulus_near_limit(const Protocol& protocol, std::span<const Trial> trials,
                                  const StimuliCourse& course,
                                  const std::function<Nearness(const ExploredStimulus&)>& examine);

}  // namespace asperity
