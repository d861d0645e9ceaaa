// Declares the sentences about values that do not have the form of their key.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/key.h"

namespace asperity {

/// A value as an error quotes it: a text in quotation marks, "an object {…}", "a list […]".
std::string quoted_value(const nlohmann::json& value);

/// "a number or text in quotation marks", for types as the schema names them.
std::string types_text(const std::vector<std::string>& types);

/// ". Expected here: …"; empty without a meaning.
std::string expected_here(std::string_view meaning);

// The sentences. `meaning` is that of the key with the value; `known` and `words` are the permitted names.
std::string unknown_key(const std::string& key, const std::vector<std::string>& known);
std::string missing_key(std::string_view key, std::string_view meaning);
/// Of a key whose condition on the object, or on one around it, does not hold.
std::string inapplicable_key(const KeyCondition& unmet);
std::string not_a_name(const std::string& key);
std::string wrong_type(const nlohmann::json& value, const std::vector<std::string>& types,
                       std::string_view meaning);
std::string wrong_word(const nlohmann::json& value, const std::vector<std::string>& words);
/// `value` is a number outside the limits of the shape.
std::string wrong_number(const nlohmann::json& value, const NumberShape& shape,
                         std::string_view meaning);
std::string wrong_pattern(const nlohmann::json& value, std::string_view meaning);
std::string empty_text(std::string_view meaning);
std::string long_text(std::size_t longest);
std::string too_few_entries(std::size_t entries, std::size_t fewest, std::string_view meaning);
std::string too_many_entries(std::size_t entries, std::size_t most, std::string_view meaning);
std::string repeated_entry(const nlohmann::json& entry);
std::string empty_object(std::string_view meaning);
std::string undecided_object(const std::vector<std::string>& keys);

}  // namespace asperity
