// Declares the check that a document has the form of a protocol.

#pragma once

#include <vector>

#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"

namespace asperity {

/// All locations at which the document does not have the form of a protocol. The objects whose keys are declared in
/// tables (protocols/keys) are checked by these, all others by the schema.
std::vector<Diagnostic> check_schema(const JsonDocument& document);

/// All locations at which the document violates protocols/schema/protocol-1.schema.json.
std::vector<Diagnostic> check_by_schema(const JsonDocument& document);

/// Whether there are no violations.
bool follows_schema(const nlohmann::json& document);

}  // namespace asperity
