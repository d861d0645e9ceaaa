// Implements the rows of the page of the format.

#include "protocols/keys/page_of.h"

#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocols/keys/schema_of.h"

namespace asperity {

namespace {

std::string code(std::string_view text) { return '`' + std::string(text) + '`'; }

std::string shape_text(const ValueShape& shape);

std::string size_text(std::size_t shortest, const std::optional<std::size_t>& longest) {
  if (longest == shortest) return " (" + std::to_string(shortest) + ')';
  if (shortest <= 1) return "";
  const std::string upper = longest ? " to " + std::to_string(*longest) : " or more";
  return " (" + std::to_string(shortest) + upper + ')';
}

/// The column "value".
struct ShapeText {
  std::string operator()(const NumberShape& shape) const {
    std::string limits{};
    const auto add = [&limits](const char* relation, const std::optional<double>& limit) {
      if (!limit) return;
      limits +=
          (limits.empty() ? " " : ", ") + std::string(relation) + written_number(*limit).dump();
    };
    add("≥ ", shape.minimum);
    add("> ", shape.above);
    add("≤ ", shape.maximum);
    add("below ", shape.below);
    return (shape.is_whole ? "whole number" : "number") + limits;
  }
  std::string operator()(const TruthShape&) const { return "true or false"; }
  std::string operator()(const WordShape& shape) const {
    std::string words{};
    for (const KeyWord& word : shape.words) {
      words += (words.empty() ? "" : ", ") + code(word.name);
    }
    return words;
  }
  std::string operator()(const TextShape&) const { return "text"; }
  std::string operator()(const NameShape&) const { return "name"; }
  std::string operator()(const ListShape& shape) const {
    return "list of " + shape_text(*shape.entry) + size_text(shape.shortest, shape.longest);
  }
  std::string operator()(const MapShape& shape) const {
    return "by name: " + shape_text(*shape.entry);
  }
  std::string operator()(const ObjectShape& shape) const {
    return shape.table->noun.empty() ? "object" : std::string(shape.table->noun);
  }
  std::string operator()(const BoundShape& shape) const {
    return shape_text(*shape.value) + " or `{\"factor\": …}`";
  }
  std::string operator()(const FormsShape& shape) const {
    std::string forms{};
    for (const ValueShape& form : shape.forms) {
      forms += (forms.empty() ? "" : " or ") + shape_text(form);
    }
    return forms;
  }
};

std::string shape_text(const ValueShape& shape) { return std::visit(ShapeText{}, shape); }

/// The column "default".
std::string default_text(const ProtocolKey& key) {
  if (key.is_required) return "required";
  if (!key.computed_default.empty()) return std::string(key.computed_default);
  const nlohmann::json standard = default_of(key);
  if (standard.is_null()) return {};
  if (standard.is_string()) return code(standard.get<std::string>());
  return code((standard.is_number() ? written_number(standard.get<double>()) : standard).dump());
}

/// The keys that have to be stated with this one.
std::string needed_text(const ProtocolKey& key) {
  std::string text{};
  for (const KeyCondition& condition : key.conditions) {
    const bool is_presence = condition.of == KeyCondition::Of::object && condition.count == 0;
    if (!condition.key.empty() && is_presence) text += " Only with " + code(condition.key) + '.';
  }
  return text;
}

}  // namespace

std::string page_rows_of(const KeyTable& table) {
  std::string rows{};
  for (const ProtocolKey& key : table.keys) {
    rows += "| " + code(key.name) + " | " + shape_text(key.shape) + " | " + default_text(key) +
            " | " + full_meaning_of(key) + needed_text(key) + " |\n";
  }
  return rows;
}

}  // namespace asperity
