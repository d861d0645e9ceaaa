// Compares the steps of varied levels with the noise of the force on a device.

#pragma once

#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// A warning for every block whose smallest step of a height is lost in the noise of the force: the step changes the
/// force by Δ·K, with the stiffness K of the material, and the force noise is K times the larger one of the device's
/// position noise (RMS) and its position resolution. A step below three times that noise is reported.
///
/// Only for the amplitude parameter of a model, in metres: with it a level is the height of the surface. Items that were not
/// measured are not compared.
std::vector<RehearsalWarning> level_warnings(const Protocol& protocol, const DeviceProfile& profile,
                                             const ModelRegistry& models);

}  // namespace asperity
