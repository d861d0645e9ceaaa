// Compares the requirements of a protocol with the capability of a device.

#pragma once

#include <vector>

#include "analysis/words/phrase.h"
#include "device/device_capability.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The requirements of a protocol that a device does not meet, a sentence each.
std::vector<Phrase> complaints_about_device(const Protocol& protocol,
                                            const DeviceCapability& device);

}  // namespace asperity
