// Compares what the friction of stimuli requires near rest with the properties of a device.

#pragma once

#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"
#include "renderers/offline/friction_near_rest.h"

namespace asperity {

/// The comparison of a plan's friction with a device.
struct FrictionRehearsal {
  /// "friction_damping" for every stimulus whose friction near rest is a damper on which the loop would vibrate, and
  /// "friction_stiffness" for every one whose friction near rest is a spring that requires more damping than the device has
  /// (friction_near_rest.h), in a loop of the protocol's rate.
  std::vector<RehearsalWarning> warnings{};
  /// "friction_not_compared", with the greatest required damping, for every template of stimuli whose friction near rest
  /// is a spring, if the damping of the device is unknown.
  std::vector<RehearsalWarning> not_compared{};
  bool has_compared = false;  ///< the friction of at least one stimulus
};

/// The normal force is the greatest that the instructed exploration accepts, or else its target. A warning of a damper
/// names v₀ and a normal force with which the loop would not vibrate, v₀ as far as the model accepts it, or the mass and
/// the delay that the law has to assume; one of a spring names the greatest stiffness. The mass is assumed where it is
/// unknown. Bodies behind a virtual coupling are not compared.
FrictionRehearsal rehearse_friction(const Protocol& protocol, const ModelRegistry& models,
                                    const DampedResponse& device);

/// Of a measured device: its damping is that along the surface.
DampedResponse damped_response_of(const DeviceProfile& profile);

}  // namespace asperity
