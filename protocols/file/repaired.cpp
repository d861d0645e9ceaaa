// Implements the replacement of values that violate the schema.

#include "protocols/file/repaired.h"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <span>

#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/file/follow_ups.h"
#include "protocols/file/form_check.h"
#include "protocols/file/library_protocols.h"
#include "protocols/keys/key.h"

namespace asperity {

namespace {

using nlohmann::json;

std::vector<std::string> types_of(const json& schema) {
  const auto type = schema.find("type");
  if (type == schema.end()) return {};
  if (type->is_array()) return type->get<std::vector<std::string>>();
  return {type->get<std::string>()};
}

bool has_right_bounds(const json& schema, double value) {
  const auto bound = [&schema](const char* key) -> std::optional<double> {
    const auto found = schema.find(key);
    return found == schema.end() ? std::nullopt : std::optional(found->get<double>());
  };
  const auto minimum = bound("minimum");
  const auto maximum = bound("maximum");
  const auto above = bound("exclusiveMinimum");
  const auto below = bound("exclusiveMaximum");
  return (!minimum || value >= *minimum) && (!maximum || value <= *maximum) &&
         (!above || value > *above) && (!below || value < *below);
}

bool has_right_letters(const json& schema, const std::string& text) {
  constexpr std::size_t kLongestName = 256;  // std::regex recurses once per character
  if (text.size() < schema.value("minLength", std::size_t{0})) return false;
  if (text.size() > schema.value("maxLength", text.size())) return false;
  const auto pattern = schema.find("pattern");
  return pattern == schema.end() ||
         (text.size() <= kLongestName &&
          std::regex_search(text, std::regex(pattern->get<std::string>())));
}

/// The schema of a member; null if the schema does not describe it.
const json* member_schema(const json& schema, const std::string& key) {
  if (is_comment(key)) return nullptr;
  if (const auto properties = schema.find("properties"); properties != schema.end()) {
    if (const auto found = properties->find(key); found != properties->end()) return &*found;
  }
  const auto additional = schema.find("additionalProperties");
  return additional != schema.end() && additional->is_object() ? &*additional : nullptr;
}

/// One way of repairing a document. `variant` determines arbitrary choices, such as the value of an enumeration.
class Repairer final {
 public:
  /// `names`: those to which a replaced reference may refer.
  Repairer(const json& schema, std::span<const std::string> names, std::size_t variant)
      : root_(schema), names_(names), variant_(variant) {}

  std::optional<json> whole(const json& document) { return fitted(document, root_, ""); }
  const std::set<std::string>& places() const { return places_; }
  std::size_t choices() const { return choices_; }

 private:
  /// The value if the schema permits it; otherwise a replacement; nullopt if there is no neutral replacement.
  std::optional<json> fitted(const json& value, const json& schema, const std::string& pointer) {
    if (schema.contains("const") || schema.contains("enum")) {
      const bool is_one = schema.contains("const")
                              ? value == schema.at("const")
                              : std::find(schema.at("enum").begin(), schema.at("enum").end(),
                                          value) != schema.at("enum").end();
      return is_one ? value : replaced(schema, pointer);
    }
    const std::vector<std::string> types = types_of(schema);
    const bool has_type =
        types.empty() || std::any_of(types.begin(), types.end(), [&value](const auto& type) {
          return is_of_type(value, type);
        });
    if (!has_type) return replaced(schema, pointer);
    if (value.is_number() && !has_right_bounds(schema, value.get<double>())) {
      return replaced(schema, pointer);
    }
    if (value.is_string() && !has_right_letters(schema, value.get<std::string>())) {
      return replaced(schema, pointer);
    }
    if (value.is_array()) return fitted_list(value, schema, pointer);
    if (value.is_object()) return fitted_object(value, schema, pointer);
    return value;
  }

  std::optional<json> replaced(const json& schema, const std::string& pointer) {
    places_.insert(pointer);
    return any(schema);
  }

  std::optional<json> fitted_list(const json& list, const json& schema,
                                  const std::string& pointer) {
    json made = json::array();
    const auto items = schema.find("items");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto item = items == schema.end() ? std::optional(list[i])
                                              : fitted(list[i], *items, pointer_to(pointer, i));
      if (item) made.push_back(*item);
    }
    const std::size_t most = schema.value("maxItems", made.size());
    if (made.size() < schema.value("minItems", std::size_t{0}) || made.size() > most) {
      return replaced(schema, pointer);
    }
    return made;
  }

  std::optional<json> fitted_object(const json& object, const json& schema,
                                    const std::string& pointer) {
    const bool closed = schema.value("additionalProperties", json(true)) == json(false);
    json made = json::object();
    for (const auto& [key, member] : object.items()) {
      const std::string at = pointer_to(pointer, key);
      std::string meant = key;
      const json* inner = member_schema(schema, key);
      if (inner == nullptr && closed && !is_comment(key)) {
        places_.insert(at);
        std::vector<std::string> known{};
        for (const auto& [name, description] : schema.at("properties").items()) {
          if (!object.contains(name)) known.push_back(name);
        }
        const auto nearest = nearest_name(key, known);
        if (!nearest) continue;
        meant = *nearest;
        inner = member_schema(schema, meant);
      }
      if (inner == nullptr) {
        made[meant] = member;
      } else if (auto fit = fitted(member, *inner, at)) {
        made[meant] = std::move(*fit);
      }
    }
    for (const json& key : schema.value("required", json::array())) {
      if (!complete(made, schema, key.get<std::string>(), pointer)) return {};
    }
    if (!choose_one_form(made, schema, pointer)) return {};
    const json dependencies = schema.value("dependencies", json::object());
    for (const auto& [key, needed] : dependencies.items()) {
      const bool is_met = std::all_of(needed.begin(), needed.end(), [&made](const json& other) {
        return made.contains(other.get<std::string>());
      });
      if (is_met || made.erase(key) == 0) continue;
      places_.insert(pointer_to(pointer, key));
    }
    if (made.size() < schema.value("minProperties", std::size_t{0})) {
      places_.insert(pointer);
      return {};
    }
    return made;
  }

  /// Adds a required key.
  bool complete(json& object, const json& schema, const std::string& key,
                const std::string& pointer) {
    if (object.contains(key)) return true;
    const json* const inner = member_schema(schema, key);
    const auto value = inner == nullptr ? std::nullopt : replaced(*inner, pointer_to(pointer, key));
    if (!value) return false;
    object[key] = *value;
    return true;
  }

  /// Reduces an object whose form is determined by exactly one of several keys, such as a step of the flow, to one
  /// form.
  bool choose_one_form(json& object, const json& schema, const std::string& pointer) {
    const auto forms = schema.find("oneOf");
    if (forms == schema.end()) return true;
    std::vector<std::string> there{};
    for (const json& form : *forms) {
      const std::string key = form.at("required").at(0);
      if (object.contains(key)) there.push_back(key);
    }
    if (there.size() == 1) return true;
    places_.insert(pointer);
    if (there.empty()) return false;
    for (std::size_t i = 1; i < there.size(); ++i) object.erase(there[i]);
    return true;
  }

  std::optional<json> any(const json& schema) {
    if (schema.contains("const")) return schema.at("const");
    if (const auto choices = schema.find("enum"); choices != schema.end()) {
      choices_ = std::max(choices_, choices->size());
      return choices->at(variant_ % choices->size());
    }
    const std::vector<std::string> types = types_of(schema);
    if (types.empty()) return {};
    const std::string& type = types.front();
    if (type == "boolean") return variant_ % 2 == 1;
    if (type == "string") {
      const bool is_reference =
          !names_.empty() && schema.value("pattern", std::string{}) == kNamePattern;
      if (is_reference) choices_ = std::max(choices_, 1 + names_.size());
      if (is_reference && variant_ > 0) return names_[(variant_ - 1) % names_.size()];
      for (const char* text : {"x", "1.0.0"}) {
        if (has_right_letters(schema, text)) return text;
      }
      return {};
    }
    if (type == "integer" || type == "number") {
      const double number = any_number(schema);
      if (!has_right_bounds(schema, number)) return {};
      if (type == "integer") return static_cast<std::int64_t>(number);
      return number;
    }
    if (type == "array") {
      json made = json::array();
      for (std::size_t i = 0; i < schema.value("minItems", std::size_t{0}); ++i) {
        const auto item = any(schema.at("items"));
        if (!item) return {};
        made.push_back(*item);
      }
      return made;
    }
    json made = json::object();
    if (schema.contains("minProperties") || schema.contains("oneOf")) return {};
    for (const json& key : schema.value("required", json::array())) {
      const json* const inner = member_schema(schema, key.get<std::string>());
      const auto value = inner == nullptr ? std::nullopt : any(*inner);
      if (!value) return {};
      made[key.get<std::string>()] = *value;
    }
    return made;
  }

  /// The default, small and large numbers, by variant.
  double any_number(const json& schema) {
    std::vector<double> numbers{};
    for (const double value :
         {schema.value("default", 1.0), schema.value("minimum", 0.0), schema.value("maximum", 1e3),
          schema.value("exclusiveMaximum", 1.0) * 0.5}) {
      if (has_right_bounds(schema, value)) numbers.push_back(value);
    }
    if (numbers.empty()) return 0.0;
    choices_ = std::max(choices_, numbers.size());
    return numbers[variant_ % numbers.size()];
  }

  const json& root_;
  std::span<const std::string> names_;
  std::size_t variant_;
  std::size_t choices_ = 1;  ///< the greatest number of alternatives for one value
  std::set<std::string> places_{};
};

}  // namespace

Repair repaired(const JsonDocument& document) {
  constexpr std::size_t kMostVariants = 24;
  const json& schema = protocol_schema();
  const std::vector<std::string> names =
      document.root().is_object() ? declared_names(document.root()) : std::vector<std::string>{};
  Repair repair{};
  std::size_t variants = 1;
  for (std::size_t variant = 0; variant < std::min(variants, kMostVariants); ++variant) {
    Repairer repairer(schema, names, variant);
    auto root = repairer.whole(document.root());
    if (!root || !has_form_of_protocol(*root)) return {};
    variants = std::max(variants, repairer.choices());
    repair.roots.push_back(std::move(*root));
    repair.places.assign(repairer.places().begin(), repairer.places().end());
  }
  return repair;
}

bool may_follow_from(const Repair& repair, const std::string& pointer, const std::string& message) {
  const auto lies_in = [](const std::string& inner, const std::string& outer) {
    return inner == outer || inner.starts_with(outer + '/');
  };
  // A level with an unknown name is invalid regardless of the factor's other levels.
  const bool is_unknown_level = lies_in(pointer, "/factors") && message.starts_with("there is no ");
  return std::any_of(repair.places.begin(), repair.places.end(), [&](const std::string& place) {
    if (place.empty()) return true;
    const std::string object = place.substr(0, place.rfind('/'));
    const std::string name = place.substr(object.size() + 1);
    const bool is_of_same_object = !is_unknown_level && !object.empty() && lies_in(pointer, object);
    const bool is_made_of_levels = lies_in(place, "/factors") && lies_in(pointer, "/blocks");
    return is_of_same_object || is_made_of_levels || lies_in(place, pointer) ||
           lies_in(pointer, place) || message.find(in_quotes(name)) != std::string::npos;
  });
}

}  // namespace asperity
