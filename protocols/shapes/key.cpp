// Implements the properties of keys and shapes, and the reading of the keys of a table.

#include "protocols/shapes/key.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"

namespace asperity {

bool is_name(std::string_view text) {
  if (text.empty() || text.size() > kMaximumNameLength || text[0] < 'a' || text[0] > 'z')
    return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

bool holds_in(const KeyCondition& condition, const nlohmann::json& object) {
  if (condition.key.empty() || condition.of != KeyCondition::Of::object) return true;
  const auto found = object.find(condition.key);
  if (condition.count == 0) return found != object.end();
  if (found != object.end() && !found->is_string())
    return !std::ranges::equal(condition.values(), std::array{kAbsent});
  const std::string value = found == object.end() ? std::string() : found->get<std::string>();
  return std::ranges::find(condition.values(), value) != condition.values().end();
}

bool lies_within(const NumberShape& shape, double number) {
  return (!shape.minimum || number >= *shape.minimum) && (!shape.above || number > *shape.above) &&
         (!shape.maximum || number <= *shape.maximum) && (!shape.below || number < *shape.below);
}

const ProtocolKey* KeyTable::find(std::string_view name) const {
  const auto found = std::find_if(keys.begin(), keys.end(),
                                  [name](const ProtocolKey& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

std::string_view meaning_of(const ValueShape& shape, std::string_view own) {
  const auto* const object = std::get_if<ObjectShape>(&shape);
  return own.empty() && object != nullptr ? object->table->meaning : own;
}

std::string_view meaning_of(const ProtocolKey& key) { return meaning_of(key.shape, key.meaning); }

std::string full_meaning_of(const ProtocolKey& key) {
  std::string meaning(meaning_of(key));
  if (!key.lists_words) return meaning;
  std::string words{};
  for (const KeyWord& word : std::get<WordShape>(key.shape).words) {
    words +=
        (words.empty() ? " " : "; ") + std::string(word.name) + ": " + std::string(word.meaning);
  }
  return meaning + words + '.';
}

nlohmann::json default_of(const ProtocolKey& key) {
  if (key.is_required || !key.computed_default.empty()) return nullptr;
  return key.standard(key);
}

bool is_of_type(const nlohmann::json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return value.is_number();
}

std::vector<std::string> types_of(const ValueShape& shape) {
  struct Types {
    std::vector<std::string> operator()(const NumberShape& number) const {
      return {number.is_whole ? "integer" : "number"};
    }
    std::vector<std::string> operator()(const TruthShape&) const { return {"boolean"}; }
    std::vector<std::string> operator()(const WordShape&) const { return {"string"}; }
    std::vector<std::string> operator()(const TextShape&) const { return {"string"}; }
    std::vector<std::string> operator()(const NameShape&) const { return {"string"}; }
    std::vector<std::string> operator()(const ListShape&) const { return {"array"}; }
    std::vector<std::string> operator()(const MapShape&) const { return {"object"}; }
    std::vector<std::string> operator()(const ObjectShape&) const { return {"object"}; }
    std::vector<std::string> operator()(const BoundShape& bound) const {
      std::vector<std::string> types = types_of(*bound.value);
      types.emplace_back("object");
      return types;
    }
    std::vector<std::string> operator()(const FormsShape& shape) const {
      std::vector<std::string> types{};
      for (const ValueShape& form : shape.forms) {
        for (std::string& type : types_of(form)) types.push_back(std::move(type));
      }
      return types;
    }
  };
  return std::visit(Types{}, shape);
}

namespace {

constexpr ProtocolKey kFactorOfBinding{.name = "factor",
                                       .meaning = kNameMeaning,
                                       .shape = NameShape{kFactorNames},
                                       .is_required = true};
constexpr KeyTable kBindingTable{.keys = {&kFactorOfBinding, 1}};
constexpr ValueShape kBinding = ObjectShape{&kBindingTable};

}  // namespace

const ValueShape* shape_of(const ValueShape& shape, const nlohmann::json& value) {
  if (const auto* const bound = std::get_if<BoundShape>(&shape)) {
    return value.is_object() ? &kBinding : shape_of(*bound->value, value);
  }
  const auto* const choice = std::get_if<FormsShape>(&shape);
  if (choice != nullptr) {
    for (const ValueShape& form : choice->forms) {
      if (const ValueShape* const found = shape_of(form, value)) return found;
    }
    return nullptr;
  }
  const std::vector<std::string> types = types_of(shape);
  const bool has_type = std::any_of(types.begin(), types.end(), [&value](const std::string& type) {
    return is_of_type(value, type);
  });
  return has_type ? &shape : nullptr;
}

std::optional<ValueShape> shape_at(const KeyTable& table, const nlohmann::json& root,
                                   const std::string& pointer) {
  const nlohmann::json::json_pointer path(pointer);
  if (path.empty()) return ObjectShape{&table};
  const std::string container = path.parent_pointer().to_string();
  const std::optional<ValueShape> outer = shape_at(table, root, container);
  const nlohmann::json& value = root.at(path.parent_pointer());
  const ValueShape* const shape = outer ? shape_of(*outer, value) : nullptr;
  if (shape == nullptr) return {};
  if (const auto* const object = std::get_if<ObjectShape>(shape)) {
    const ProtocolKey* const key = object->table->find(path.back());
    return key == nullptr ? std::nullopt : std::optional(key->shape);
  }
  if (const auto* const map = std::get_if<MapShape>(shape)) {
    return is_comment(path.back()) ? std::nullopt : std::optional(*map->entry);
  }
  if (const auto* const list = std::get_if<ListShape>(shape)) return *list->entry;
  return {};
}

std::optional<std::string> number_in_file(const NumberShape& shape, std::string_view displayed) {
  if (shape.display.factor == 1.0) return shifted_decimal(displayed, shape.display.power);
  const std::optional<std::string> number = shifted_decimal(displayed, 0);
  if (!number) return {};
  return number_text(nlohmann::json::parse(*number).get<double>() * shape.display.factor);
}

std::optional<std::string> displayed_number(const NumberShape& shape, std::string_view in_file) {
  if (shape.display.factor == 1.0) return shifted_decimal(in_file, -shape.display.power);
  const std::optional<std::string> number = shifted_decimal(in_file, 0);
  if (!number) return {};
  const double value = nlohmann::json::parse(*number).get<double>() / shape.display.factor;
  return number_text(without_rounding_errors(value));
}

void read_keys(const KeyTable& table, const nlohmann::json& valid, void* owner) {
  for (const ProtocolKey& key : table.keys) {
    const auto found = valid.find(key.name);
    if (found == valid.end()) continue;
    key.store(key, *found, key.part == nullptr ? owner : key.part(owner));
  }
}

}  // namespace asperity
