// Declares the conversion of a block of a document that follows the schema.

#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// All keys except "procedure", which depends on other parts of the document (levels_from_json.h). `kind_of_protocol`: the kind of
/// a block that does not state its own.
Protocol::Block block_of(const std::string& name, const nlohmann::json& object,
                         const std::string& kind_of_protocol);

}  // namespace asperity
