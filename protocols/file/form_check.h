// Declares the check that a document has the form of a protocol.

#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// All locations at which the document does not have the form of the table, in the order of the text.
std::vector<Diagnostic> check_form(const JsonDocument& document, const KeyTable& table);

/// All locations at which the document does not have the form that the tables of keys declare, in the order of the text.
std::vector<Diagnostic> check_form(const JsonDocument& document);

/// Whether there is no such location.
bool has_form_of_protocol(const nlohmann::json& root);

}  // namespace asperity
