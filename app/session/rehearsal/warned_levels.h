// Joins the warnings that levels of a parameter, or other stimuli, have in common.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/rehearsal/rehearsal_warning.h"
#include "protocols/design/protocol.h"
#include "protocols/design/trial.h"

namespace asperity {

/// The varied level of a planned stimulus; nullopt if its block does not vary its parameters.
std::optional<WarnedLevel> level_of(const Protocol& protocol, const Trial& trial,
                                    const PlannedPresentation& planned);

/// One warning in place of those that differ only in the level of a varied parameter: the one whose two numbers differ
/// most, with a sentence that states for which levels there is such a warning. Then one in place of those that differ
/// only in the name of the stimulus, with the other names. The order is that of the first warning of each group.
std::vector<RehearsalWarning> one_for_alike(std::vector<RehearsalWarning> warnings,
                                            const Protocol& protocol);

}  // namespace asperity
