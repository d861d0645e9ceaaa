// Declares the conversion of what a document that follows the schema states about the setting of its sessions.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// The keys "environment", "device", "instability", "surface" and "material".
void read_setting(const nlohmann::json& root, Protocol& protocol);

}  // namespace asperity
