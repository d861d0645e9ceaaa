// Implements the sentences about values that do not have the form of their key.

#include "protocols/keys/form_sentences.h"

#include <nlohmann/json.hpp>

#include "protocols/design/wording.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

using nlohmann::json;

std::string type_text(const std::string& type) {
  if (type == "object") return "an object {…}";
  if (type == "array") return "a list […]";
  if (type == "string") return "text in quotation marks";
  if (type == "integer") return "a whole number";
  if (type == "boolean") return "true or false";
  return "a number";
}

bool is_quoted_number(const json& value) {
  return value.is_string() &&
         json::parse(value.get_ref<const std::string&>(), nullptr, false).is_number();
}

std::string entries_text(std::size_t entries) {
  return std::to_string(entries) + (entries == 1 ? " entry is too " : " entries are too ");
}

}  // namespace

std::string quoted_value(const json& value) {
  switch (value.type()) {
    case json::value_t::string:
      return in_quotes(value.get_ref<const std::string&>());
    case json::value_t::object:
      return "an object {…}";
    case json::value_t::array:
      return "a list […]";
    case json::value_t::number_float:
      return digits(value.get<double>());
    case json::value_t::null:
    case json::value_t::boolean:
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
    case json::value_t::binary:
    case json::value_t::discarded:
      break;
  }
  return value.dump();
}

std::string types_text(const std::vector<std::string>& types) {
  std::string text{};
  for (const std::string& type : types) text += (text.empty() ? "" : " or ") + type_text(type);
  return text;
}

std::string expected_here(std::string_view meaning) {
  return meaning.empty() ? "" : ". Expected here: " + std::string(meaning);
}

std::string unknown_key(const std::string& key, const std::vector<std::string>& known) {
  const std::string guess = did_you_mean(key, known);
  return "there is no key " + in_quotes(key) + " here" +
         (guess.empty() ? "; it could be " + one_of(known) : guess);
}

std::string missing_key(std::string_view key, std::string_view meaning) {
  return "the key " + in_quotes(key) + " is missing; add it" + expected_here(meaning);
}

std::string inapplicable_key(const KeyCondition& unmet) {
  if (!unmet.problem.empty()) return std::string(unmet.problem);
  const std::string other = in_quotes(unmet.key);
  if (unmet.count == 0) {
    return "this key requires the key " + other + ", which is missing; add it, or remove this key";
  }
  std::vector<std::string> words{};
  bool may_be_absent = false;
  for (const std::string_view value : unmet.values()) {
    if (value == kAbsent) {
      may_be_absent = true;
    } else {
      words.emplace_back(value);
    }
  }
  if (words.empty()) return "this key and " + other + " exclude each other; keep one of the two";
  const std::string permitted = one_of(words);
  return "this key applies only where " + other + " is " + permitted +
         (may_be_absent ? " or absent; remove this key, or change "
                        : "; remove this key, or set ") +
         other + (may_be_absent ? "" : " to " + permitted);
}

std::string not_a_name(const std::string& key) {
  return in_quotes(key) +
         " is not a name: use lower-case letters, digits and underscores, starting with a letter, "
         "at most 64 characters";
}

std::string wrong_type(const json& value, const std::vector<std::string>& types,
                       std::string_view meaning) {
  const std::string wanted = types_text(types);
  const bool is_number = wanted.find("number") != std::string::npos && is_quoted_number(value);
  return quoted_value(value) + " is not permitted here: write " + wanted +
         (is_number ? ", without quotation marks" : "") + expected_here(meaning);
}

std::string wrong_word(const json& value, const std::vector<std::string>& words) {
  if (words.size() == 1) return quoted_value(value) + " is not supported: write " + one_of(words);
  return quoted_value(value) + " is not permitted here: write " + one_of(words) +
         (value.is_string() ? did_you_mean(value.get<std::string>(), words) : "");
}

std::string wrong_number(const json& value, const NumberShape& shape, std::string_view meaning) {
  const auto number = value.get<double>();
  const auto within = [&shape](double one) { return lies_within(shape, one); };
  const bool is_low =
      (shape.minimum && number < *shape.minimum) || (shape.above && number <= *shape.above);
  const bool is_open = is_low ? !shape.minimum : !shape.maximum;
  const double limit = is_low ? shape.minimum.value_or(shape.above.value_or(0.0))
                              : shape.maximum.value_or(shape.below.value_or(0.0));
  const char* const relation =
      is_open ? (is_low ? "greater than " : "less than ") : (is_low ? "at least " : "at most ");
  return quoted_value(value) +
         (is_low ? " is too small: it must be " : " is too large: it must be ") + relation +
         digits(limit) + meant_in_other_unit(number, shape.unit, within) + expected_here(meaning);
}

std::string wrong_pattern(const json& value, std::string_view meaning) {
  return quoted_value(value) + " does not have the required form; correct it" +
         expected_here(meaning);
}

std::string empty_text(std::string_view meaning) {
  return "this text is empty; enter a text" + expected_here(meaning);
}

std::string long_text(std::size_t longest) {
  return "this text is longer than " + std::to_string(longest) + " characters; shorten it";
}

std::string too_few_entries(std::size_t entries, std::size_t fewest, std::string_view meaning) {
  return entries_text(entries) + "few: write at least " + std::to_string(fewest) +
         expected_here(meaning);
}

std::string too_many_entries(std::size_t entries, std::size_t most, std::string_view meaning) {
  return entries_text(entries) + "many: write at most " + std::to_string(most) +
         expected_here(meaning);
}

std::string repeated_entry(const json& entry) {
  return quoted_value(entry) + " occurs twice in this list; keep one";
}

std::string empty_object(std::string_view meaning) {
  return "this object is empty; add an entry" + expected_here(meaning);
}

std::string undecided_object(const std::vector<std::string>& keys) {
  return "write exactly one of the keys " + one_of(keys) + " here";
}

}  // namespace asperity
