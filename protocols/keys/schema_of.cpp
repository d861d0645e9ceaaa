// Implements the conversion of tables and shapes to pieces of the schema.

#include "protocols/keys/schema_of.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace asperity {

namespace {

using nlohmann::json;

constexpr const char* kCommentPattern = "^(x-|\\$comment$)";
constexpr const char* kNameOrCommentPattern = "^([a-z][a-z0-9_]*|x-.*|\\$comment)$";

json as_written(const json& value) {
  return value.is_number() ? written_number(value.get<double>()) : value;
}

/// The keywords of a shape except "type" and "description".
struct Keywords {
  json operator()(const NumberShape& shape) const {
    json keywords = json::object();
    if (shape.minimum) keywords["minimum"] = written_number(*shape.minimum);
    if (shape.above) keywords["exclusiveMinimum"] = written_number(*shape.above);
    if (shape.maximum) keywords["maximum"] = written_number(*shape.maximum);
    if (shape.below) keywords["exclusiveMaximum"] = written_number(*shape.below);
    return keywords;
  }
  json operator()(const TruthShape&) const { return json::object(); }
  json operator()(const WordShape& shape) const {
    json words = json::array();
    for (const KeyWord& word : shape.words) words.push_back(word.name);
    if (words.size() == 1) return {{"const", words.front()}};
    return {{"enum", std::move(words)}};
  }
  json operator()(const TextShape& shape) const {
    json keywords{{"maxLength", shape.longest}};
    if (!shape.may_be_empty) keywords["minLength"] = 1;
    if (!shape.pattern.empty()) keywords["pattern"] = shape.pattern;
    return keywords;
  }
  json operator()(const NameShape&) const {
    return {{"pattern", kNamePattern}, {"maxLength", kMaximumNameLength}};
  }
  json operator()(const ListShape& shape) const {
    json keywords{{"items", schema_of(*shape.entry, shape.meaning)}};
    if (shape.shortest > 0) keywords["minItems"] = shape.shortest;
    if (shape.longest) keywords["maxItems"] = *shape.longest;
    if (shape.is_distinct) keywords["uniqueItems"] = true;
    return keywords;
  }
  json operator()(const MapShape& shape) const {
    json keywords{{"additionalProperties", schema_of(*shape.entry, shape.meaning)},
                  {"patternProperties", {{kCommentPattern, json::object()}}},
                  {"propertyNames", {{"maxLength", shape.longest_name}}}};
    if (shape.has_names) keywords["propertyNames"]["pattern"] = kNameOrCommentPattern;
    if (shape.shortest > 0) keywords["minProperties"] = shape.shortest;
    if (shape.longest) keywords["maxProperties"] = *shape.longest;
    return keywords;
  }
  json operator()(const ObjectShape& shape) const {
    json keywords = schema_of(*shape.table);
    keywords.erase("description");
    keywords.erase("type");
    return keywords;
  }
  json operator()(const BoundShape& shape) const {
    json keywords = std::visit(*this, *shape.value);
    keywords["required"] = {"factor"};
    keywords["properties"] = {{"factor", schema_of(NameShape{}, kNameMeaning)}};
    keywords["additionalProperties"] = false;
    return keywords;
  }
  /// Keywords of different types do not affect each other, except for words, which become a pattern of texts.
  json operator()(const FormsShape& shape) const {
    json keywords = json::object();
    for (const ValueShape& form : shape.forms) {
      const auto* const choice = std::get_if<WordShape>(&form);
      if (choice == nullptr) {
        keywords.update(std::visit(*this, form));
        continue;
      }
      std::string pattern{};
      for (const KeyWord& word : choice->words) {
        pattern += (pattern.empty() ? "" : "|") + std::string(word.name);
      }
      const bool is_one = choice->words.size() == 1;
      keywords["pattern"] = is_one ? '^' + pattern + '$' : "^(" + pattern + ")$";
    }
    return keywords;
  }
};

}  // namespace

json written_number(double value) {
  constexpr double kExact = 9'007'199'254'740'992.0;  // 2^53
  if (value == std::trunc(value) && std::abs(value) < kExact) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

json schema_of(const ValueShape& shape, std::string_view meaning) {
  json schema = std::visit(Keywords{}, shape);
  if (!std::holds_alternative<WordShape>(shape)) {
    const std::vector<std::string> types = types_of(shape);
    schema["type"] = types.size() == 1 ? json(types.front()) : json(types);
  }
  meaning = meaning_of(shape, meaning);
  if (!meaning.empty()) schema["description"] = meaning;
  return schema;
}

namespace {

/// What draft-07 can state of a condition: as the schema of the object that has the key.
void add_condition(const KeyCondition& condition, json& schema) {
  const std::string other(condition.key);
  json words = json::array();
  bool may_be_absent = false;
  for (const std::string_view value : condition.values()) {
    if (value == kAbsent) {
      may_be_absent = true;
    } else {
      words.push_back(value);
    }
  }
  if (!may_be_absent) schema["required"].push_back(other);
  if (!words.empty()) {
    schema["properties"][other] = {{"enum", words}};
  } else if (may_be_absent) {
    schema["properties"][other] = false;
  }
}

}  // namespace

json schema_of(const KeyTable& table) {
  json properties = json::object();
  json required = json::array();
  json needs = json::object();
  for (const ProtocolKey& key : table.keys) {
    const std::string name(key.name);
    properties[name] = schema_of(key.shape, key.lists_words ? full_meaning_of(key) : key.meaning);
    if (key.is_required) required.push_back(name);
    for (const KeyCondition& condition : key.conditions) {
      if (condition.key.empty() || condition.of != KeyCondition::Of::object) continue;
      add_condition(condition, needs[name]);
    }
    if (const json standard = default_of(key); !standard.is_null()) {
      properties[name]["default"] = as_written(standard);
    }
  }
  json schema{{"description", table.meaning}, {"type", "object"}};
  if (!properties.empty()) schema["properties"] = std::move(properties);
  if (!required.empty()) schema["required"] = std::move(required);
  if (!table.may_be_empty) schema["minProperties"] = 1;
  if (!needs.empty()) schema["dependencies"] = std::move(needs);
  for (const std::string_view key : table.deciding) {
    schema["oneOf"].push_back({{"required", {key}}});
  }
  if (!table.is_open) {
    schema["patternProperties"] = {{kCommentPattern, json::object()}};
    schema["additionalProperties"] = false;
  }
  return schema;
}

}  // namespace asperity
