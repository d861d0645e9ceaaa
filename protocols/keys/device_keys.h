// Declares the keys of "device": the requirements of the haptic device.

#pragma once

#include <map>
#include <string>

#include "protocols/design/protocol.h"
#include "protocols/keys/key.h"

namespace asperity {

const KeyTableOf<Protocol>& device_keys();

/// The keys of "limits" in it, which are items of a device. All of them are numbers.
const KeyTableOf<std::map<std::string, double>>& device_limit_keys();

}  // namespace asperity
