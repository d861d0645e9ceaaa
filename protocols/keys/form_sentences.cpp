// Implements the sentences about values that do not have the form of their key.

#include "protocols/keys/form_sentences.h"

#include <optional>
#include <variant>

#include <nlohmann/json.hpp>

#include "protocols/design/wording.h"
#include "stimuli/properties/other_unit.h"

namespace asperity {

namespace {

using nlohmann::json;

Phrase type_text(const std::string& type) {
  if (type == "object") return phrase("Protocols", "an object {…}");
  if (type == "array") return phrase("Protocols", "a list […]");
  if (type == "string") return phrase("Protocols", "text in quotation marks");
  if (type == "integer") return phrase("Protocols", "a whole number");
  if (type == "boolean") return phrase("Protocols", "true or false");
  return phrase("Protocols", "a number");
}

bool is_quoted_number(const json& value) {
  return value.is_string() &&
         json::parse(value.get_ref<const std::string&>(), nullptr, false).is_number();
}

/// "a number from 0 to 2", "a whole number (at least 1)".
Phrase permitted_numbers(const NumberShape& shape) {
  const auto limit = [](double number) { return number_of_file(digits(number)); };
  if (shape.minimum && shape.maximum) {
    return (shape.is_whole ? phrase("Protocols", "a whole number from %1 to %2")
                           : phrase("Protocols", "a number from %1 to %2"))
        .with(limit(*shape.minimum), limit(*shape.maximum));
  }
  std::vector<Phrase> limits{};
  const auto add = [&](const std::optional<double>& number, const Phrase& sentence) {
    if (number) limits.push_back(sentence.with(limit(*number)));
  };
  add(shape.minimum, phrase("Protocols", "at least %1"));
  add(shape.above, phrase("Protocols", "greater than %1"));
  add(shape.maximum, phrase("Protocols", "at most %1"));
  add(shape.below, phrase("Protocols", "less than %1"));
  const Phrase number = type_text(shape.is_whole ? "integer" : "number");
  return limits.empty() ? number
                        : phrase("Protocols", "%1 (%2)").with(number, joined_by_and(limits));
}

/// "a number or text in quotation marks": the types of the shape, with the limits of `number` if it is not null.
Phrase permitted_values(const ValueShape& shape, const NumberShape* number) {
  Phrase text{};
  for (const std::string& type : types_of(shape)) {
    const bool has_limits = number != nullptr && (type == "number" || type == "integer");
    const Phrase one = has_limits ? permitted_numbers(*number) : type_text(type);
    text = text.empty() ? one : phrase("Protocols", "%1 or %2").with(text, one);
  }
  return text;
}

}  // namespace

const NumberShape* number_in(const ValueShape& shape) {
  if (const auto* const number = std::get_if<NumberShape>(&shape)) return number;
  if (const auto* const bound = std::get_if<BoundShape>(&shape)) return number_in(*bound->value);
  if (const auto* const choice = std::get_if<FormsShape>(&shape)) {
    for (const ValueShape& form : choice->forms) {
      if (const NumberShape* const number = number_in(form)) return number;
    }
  }
  return nullptr;
}

Phrase quoted_value(const json& value) {
  switch (value.type()) {
    case json::value_t::string:
      return in_quotes(value.get_ref<const std::string&>());
    case json::value_t::object:
      return type_text("object");
    case json::value_t::array:
      return type_text("array");
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

Phrase with_meaning(const Phrase& problem, std::string_view meaning) {
  // kMeaningsOfKeys, as the literal from which the words are extracted.
  return meaning.empty() ? problem
                         : phrase("MeaningsOfKeys", "%1. Expected here: %2")
                               .with(problem, phrase_of_key(meaning));
}

Phrase unknown_key(const std::string& key, const std::vector<std::string>& known) {
  const Phrase problem = phrase("Protocols", "there is no key %1 here").with(in_quotes(key));
  if (const auto nearest = nearest_name(key, known)) {
    return phrase("Protocols", "%1; did you mean %2?").with(problem, key_name(*nearest));
  }
  return phrase("Protocols", "%1; it could be %2").with(problem, joined_by_or(key_names(known)));
}

Phrase missing_key(std::string_view key, std::string_view meaning) {
  return with_meaning(phrase("Protocols", "the key %1 is missing; add it").with(key_name(key)),
                      meaning);
}

Phrase inapplicable_key(const KeyCondition& unmet) {
  if (!unmet.problem.empty()) return phrase_of_key(unmet.problem);
  const Phrase other = key_name(unmet.key);
  if (unmet.count == 0) {
    return phrase("Protocols",
                  "this key requires the key %1, which is missing; add it, or remove this key")
        .with(other);
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
  if (words.empty()) {
    return phrase("Protocols", "this key and %1 exclude each other; keep one of the two")
        .with(other);
  }
  const Phrase sentence =
      may_be_absent
          ? phrase("Protocols",
                   "this key applies only where %1 is %2 or absent; remove this key, or change %1")
          : phrase("Protocols",
                   "this key applies only where %1 is %2; remove this key, or set %1 to %2");
  return sentence.with(other, joined_by_or(quoted(words)));
}

Phrase not_a_name(const std::string& key) {
  return phrase("Protocols",
                "%1 is not a name: use lower-case letters, digits and underscores, starting with "
                "a letter, at most 64 characters")
      .with(in_quotes(key));
}

Phrase wrong_type(const json& value, const ValueShape& shape, std::string_view meaning) {
  const NumberShape* const number = number_in(shape);
  const bool is_quoted = number != nullptr && is_quoted_number(value);
  const Phrase sentence =
      is_quoted ? phrase("Protocols", "%1 is not permitted here: write %2, without quotation marks")
                : phrase("Protocols", "%1 is not permitted here: write %2");
  return with_meaning(
      sentence.with(quoted_value(value), permitted_values(shape, is_quoted ? nullptr : number)),
      meaning);
}

Phrase wrong_word(const json& value, const std::vector<std::string>& words) {
  const Phrase permitted = joined_by_or(quoted(words));
  if (words.size() == 1) {
    return phrase("Protocols", "%1 is not supported: write %2")
        .with(quoted_value(value), permitted);
  }
  const Phrase problem = phrase("Protocols", "%1 is not permitted here: write %2")
                             .with(quoted_value(value), permitted);
  return value.is_string() ? with_guess(problem, value.get<std::string>(), words) : problem;
}

Phrase wrong_number(const json& value, const NumberShape& shape, std::string_view meaning) {
  const auto number = value.get<double>();
  const auto within = [&shape](double one) { return lies_within(shape, one); };
  const bool is_low =
      (shape.minimum && number < *shape.minimum) || (shape.above && number <= *shape.above);
  const bool is_open = is_low ? !shape.minimum : !shape.maximum;
  const double limit = is_low ? shape.minimum.value_or(shape.above.value_or(0.0))
                              : shape.maximum.value_or(shape.below.value_or(0.0));
  const Phrase of_low = is_open
                            ? phrase("Protocols", "%1 is too small: it must be greater than %2%3")
                            : phrase("Protocols", "%1 is too small: it must be at least %2%3");
  const Phrase of_high = is_open ? phrase("Protocols", "%1 is too large: it must be less than %2%3")
                                 : phrase("Protocols", "%1 is too large: it must be at most %2%3");
  return with_meaning(
      (is_low ? of_low : of_high)
          .with(number_of_file(quoted_value(value).english()), number_of_file(digits(limit)),
                meant_in_other_unit(number, shape.unit, within)),
      meaning);
}

Phrase wrong_pattern(const json& value, std::string_view meaning) {
  // Only the meaning states the form, so that it stays next to a field too.
  const Phrase problem = phrase("Protocols", "%1 does not have the required form; correct it")
                             .with(quoted_value(value));
  if (meaning.empty()) return problem;
  return phrase("Protocols", "%1. Expected here: %2").with(problem, phrase_of_key(meaning));
}

Phrase empty_text(std::string_view meaning) {
  return with_meaning(phrase("Protocols", "this text is empty; enter a text"), meaning);
}

Phrase long_text(std::size_t longest) {
  return phrase("Protocols", "this text is longer than %1 characters; shorten it")
      .with(std::to_string(longest));
}

Phrase too_few_entries(std::size_t entries, std::size_t fewest, std::string_view meaning) {
  const Phrase sentence = entries == 1
                              ? phrase("Protocols", "%1 entry is too few: write at least %2")
                              : phrase("Protocols", "%1 entries are too few: write at least %2");
  return with_meaning(sentence.with(std::to_string(entries), std::to_string(fewest)), meaning);
}

Phrase too_many_entries(std::size_t entries, std::size_t most, std::string_view meaning) {
  const Phrase sentence = entries == 1
                              ? phrase("Protocols", "%1 entry is too many: write at most %2")
                              : phrase("Protocols", "%1 entries are too many: write at most %2");
  return with_meaning(sentence.with(std::to_string(entries), std::to_string(most)), meaning);
}

Phrase repeated_entry(const json& entry) {
  return phrase("Protocols", "%1 occurs twice in this list; keep one").with(quoted_value(entry));
}

Phrase empty_object(std::string_view meaning) {
  return with_meaning(phrase("Protocols", "this object is empty; add an entry"), meaning);
}

Phrase undecided_object(const std::vector<std::string>& keys) {
  return phrase("Protocols", "write exactly one of the keys %1 here")
      .with(joined_by_or(key_names(keys)));
}

}  // namespace asperity
