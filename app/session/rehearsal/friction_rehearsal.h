// Compares the friction of stimuli near rest with the stability limit of a device's loop.

#pragma once

#include <vector>

#include "app/session/rehearsal/rehearsal_warning.h"
#include "app/session/study_friction.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/friction_damper.h"

namespace asperity {

/// A warning "friction_damping" for every stimulus of the plan whose friction near rest is a damper (friction_damper.h)
/// on which the loop would vibrate, in a loop of the protocol's rate.
///
/// The normal force is the greatest that the instructed exploration accepts, or else its target. The warning names v₀
/// and a normal force with which the loop would not vibrate, v₀ as far as the model accepts it, and the mass that is
/// assumed where it is unknown. Bodies behind a virtual coupling are not compared. `friction` is the law of stimuli that
/// state none.
std::vector<RehearsalWarning> friction_warnings(const Protocol& protocol,
                                                const ModelRegistry& models,
                                                const DampedResponse& device,
                                                UnstatedFriction friction);

}  // namespace asperity
