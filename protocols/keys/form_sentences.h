// Declares the sentences about values that do not have the form of their key.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/words/phrase.h"
#include "protocols/shapes/key.h"

namespace asperity {

/// A value as an error quotes it: a text in quotation marks, "an object {…}", "a list […]".
Phrase quoted_value(const nlohmann::json& value);

/// The number that a value of the shape can be; null if it can be none.
const NumberShape* number_in(const ValueShape& shape);

/// The context of problems with the meaning of the key: a form shows the meaning next to the field.
inline constexpr const char* kMeaningsOfKeys = "MeaningsOfKeys";
/// "PROBLEM. Expected here: MEANING"; the problem alone without a meaning.
Phrase with_meaning(const Phrase& problem, std::string_view meaning);

// The sentences. `meaning` is that of the key with the value; `known` and `words` are the permitted names.
Phrase unknown_key(const std::string& key, const std::vector<std::string>& known);
Phrase missing_key(std::string_view key, std::string_view meaning);
/// Of a key whose condition on the object, or on one around it, does not hold.
Phrase inapplicable_key(const KeyCondition& unmet);
Phrase not_a_name(const std::string& key);
/// `value` has none of the types of the shape. Of a number the sentence states the limits, but not where only quotation marks are
/// wrong.
Phrase wrong_type(const nlohmann::json& value, const ValueShape& shape, std::string_view meaning);
Phrase wrong_word(const nlohmann::json& value, const std::vector<std::string>& words);
/// `value` is a number outside the limits of the shape.
Phrase wrong_number(const nlohmann::json& value, const NumberShape& shape,
                    std::string_view meaning);
Phrase wrong_pattern(const nlohmann::json& value, std::string_view meaning);
Phrase empty_text(std::string_view meaning);
Phrase long_text(std::size_t longest);
Phrase too_few_entries(std::size_t entries, std::size_t fewest, std::string_view meaning);
Phrase too_many_entries(std::size_t entries, std::size_t most, std::string_view meaning);
Phrase repeated_entry(const nlohmann::json& entry);
Phrase empty_object(std::string_view meaning);
Phrase undecided_object(const std::vector<std::string>& keys);

}  // namespace asperity
