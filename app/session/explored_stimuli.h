// Lists every stimulus that the sessions of a protocol can present, with each of its explorations.

#pragma once

#include <functional>
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
};

/// Calls `examine` for every stimulus that a session of the protocol can present (possible_trials), once for each of its
/// explorations, in the order of the trials. Two stimuli of one name are different where factors or roving choose other
/// parameters, materials, bodies or files for them.
///
/// Errors: those of `examine`.
void for_each_stimulus(const Protocol& protocol, const StimuliCourse& course,
                       const std::function<void(const ExploredStimulus&)>& examine);

}  // namespace asperity
