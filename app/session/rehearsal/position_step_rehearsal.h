// Compares stimuli with the position step of a device.

#pragma once

#include <vector>

#include "app/session/rehearsal/rehearsal_warning.h"
#include "app/session/stimulus_builder.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// "position_step" for every stimulus on which one position step Δ of the device changes the force by more than kFeltForce_N
/// (perceived_instability.h):
///
///   K·Δ > kFeltForce_N
///
/// K is the stiffness across the surface without its texture: that of the Material; of a model with its own law of indentation
/// the greatest one up to the requested force (indentation_law.h); of bodies behind a virtual coupling that of the coupling,
/// whose tool does not move within a tick. A count varies at rest wherever a position lies near the border of two steps.
///
/// Stimuli whose files are missing, or that cannot be rendered, are left out.
std::vector<RehearsalWarning> position_step_warnings(const Protocol& protocol,
                                                     StimulusBuilder& builder, double step_m);

/// "path_step" for every stimulus that measures the path of the hand (path_clock.h) without a stated `device_step_m`, for a
/// device whose position step is unknown: a session then assumes 0.
std::vector<RehearsalWarning> unknown_step_warnings(const Protocol& protocol,
                                                    const ModelRegistry& models);

}  // namespace asperity
