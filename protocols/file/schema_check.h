// Whether a document has the form of a protocol.

#pragma once

#include <vector>

#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"

namespace asperity {

/// Every place where the document does not follow protocols/schema/protocol-1.schema.json.
std::vector<Diagnostic> check_schema(const JsonDocument& document);

/// Whether there is no such place.
bool follows_schema(const nlohmann::json& document);

}  // namespace asperity
