// Declares the piece of the schema (JSON Schema, draft-07) that states a table or a shape.

#pragma once

#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/key.h"

namespace asperity {

/// The schema of an object with these keys. It contains no references.
nlohmann::json schema_of(const KeyTable& table);
/// The schema of a value of this shape; `meaning` is its description, none if it is empty.
nlohmann::json schema_of(const ValueShape& shape, std::string_view meaning);

/// A number as a file writes it: a whole one without a decimal point or an exponent.
nlohmann::json written_number(double value);

}  // namespace asperity
