// Declares the check that a document follows the schema of protocols.

#pragma once

#include <vector>

#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"

namespace asperity {

/// All locations at which the document violates protocols/schema/protocol-1.schema.json.
std::vector<Diagnostic> check_schema(const JsonDocument& document);

/// Whether there are no violations.
bool follows_schema(const nlohmann::json& document);

}  // namespace asperity
