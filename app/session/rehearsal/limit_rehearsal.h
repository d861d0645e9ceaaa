// Compares the limits of a protocol for its device with a profile.

#pragma once

#include <vector>

#include "app/profiles/device_profile.h"
#include "app/session/rehearsal/rehearsal_warning.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// A warning "limit_…" for every declared limit that the profile does not meet, and "unmeasured_…" for every one whose
/// item was not measured. A simulated device meets every limit on timing; a device without a measured resonance meets
/// every limit on it, unless its resonance is marked as unknown.
std::vector<RehearsalWarning> limit_warnings(const Protocol& protocol,
                                             const DeviceProfile& profile);

}  // namespace asperity
