// Declares the conversion of a document that follows the schema to a Protocol.

#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// Converts a document that follows the schema, without checking its meaning. `models` declare the units of varied
/// parameters.
Protocol protocol_from_json(const nlohmann::json& root,
                            const std::vector<ModelDeclaration>& models);

}  // namespace asperity
