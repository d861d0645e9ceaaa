// Implements the entries of an object and the names of places, by the tables of keys.

#include "protocols/form/form_entries.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "analysis/numbers/unit_of_name.h"
#include "protocols/design/json_pointer.h"
#include "protocols/keys/conditions.h"
#include "protocols/keys/names_in.h"
#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr std::size_t kPartsOfSummary = 3;
constexpr std::size_t kLongestSummary = 120;

bool is_deciding(const KeyTable& table, std::string_view key) {
  return std::find(table.deciding.begin(), table.deciding.end(), key) != table.deciding.end();
}

/// "2.3 mm" of 0.0023 m.
std::string with_unit(const NumberShape& shape, const json& value, const std::string& pointer) {
  const NumberShape shown = displayed_shape(shape, pointer);
  const std::string_view unit = shown.display.unit.empty() ? shown.unit : shown.display.unit;
  std::string number = displayed_number(shown, value.dump()).value_or(value.dump());
  if (number.ends_with(".0")) number.resize(number.size() - 2);
  return unit.empty() ? number : number + ' ' + std::string(unit);
}

bool is_paragraph(const ValueShape& shape) {
  const auto* const text = std::get_if<TextShape>(&shape);
  return text != nullptr && text->is_long;
}

std::string joined_text(std::string text, const std::string& more) {
  return text.empty() ? more : std::move(text) + " · " + more;
}

}  // namespace

std::vector<FormEntry> entries_of(const KeyTable& table, const json& object,
                                  const std::string& pointer, const json& protocol) {
  const bool is_decided =
      std::any_of(table.deciding.begin(), table.deciding.end(),
                  [&object](std::string_view key) { return object.contains(key); });
  std::vector<FormEntry> entries{};
  for (const ProtocolKey& key : table.keys) {
    const bool is_present = object.contains(key.name);
    const bool is_excluded = (is_decided && is_deciding(table, key.name)) ||
                             unmet_condition(key, object, protocol, pointer) != nullptr;
    if (!is_present && is_excluded) continue;
    entries.push_back({pointer_to(pointer, key.name), &key, is_present});
  }
  return entries;
}

std::vector<std::string> unknown_keys(const KeyTable& table, const json& object) {
  std::vector<std::string> keys{};
  if (table.is_open) return keys;
  for (const auto& [key, value] : object.items()) {
    if (!is_comment(key) && table.find(key) == nullptr) keys.push_back(key);
  }
  return keys;
}

NumberShape displayed_shape(const NumberShape& shape, const std::string& pointer) {
  if (!shape.unit.empty() || !shape.display.unit.empty()) return shape;
  json::json_pointer path(pointer);
  constexpr int kNamesToRead = 2;  // of the number and of the object around it
  for (int i = 0; i < kNamesToRead && !path.empty(); ++i, path.pop_back()) {
    NumberShape shown = shape;
    shown.unit = named_quantity(path.back()).unit;
    if (shown.unit == "m") shown.display = kMillimetres;
    if (shown.unit == "m/s") shown.display = {.unit = "mm/s", .power = -3};
    if (!shown.unit.empty()) return shown;
  }
  return shape;
}

std::vector<PathPart> path_of(const json& protocol, const std::string& pointer) {
  std::vector<PathPart> parts{};
  ValueShape shape = ObjectShape{&kProtocolTable};
  const json* value = &protocol;
  json::json_pointer rest(pointer);
  std::vector<std::string> keys{};
  for (; !rest.empty(); rest.pop_back()) keys.push_back(rest.back());
  std::reverse(keys.begin(), keys.end());
  for (const std::string& key : keys) {
    const ValueShape* const found = value == nullptr ? nullptr : shape_of(shape, *value);
    const json* next = nullptr;
    if (value != nullptr && value->is_object() && value->contains(key)) next = &value->at(key);
    if (value != nullptr && value->is_array()) {
      const std::size_t index = std::stoul(key);
      if (index < value->size()) next = &(*value)[index];
      const std::string name(next == nullptr ? std::string_view() : name_of_entry(*next));
      parts.push_back({.text = name.empty() ? std::to_string(index + 1) : name});
    } else {
      parts.push_back({.text = key});
    }
    value = next;
    if (found == nullptr) {
      value = nullptr;  // no shape is known from here on
    } else if (const auto* const object = std::get_if<ObjectShape>(found)) {
      const ProtocolKey* const declared = object->table->find(key);
      if (declared == nullptr) {
        value = nullptr;
      } else {
        parts.back() = {.text = std::string(declared->label), .is_label = true};
        shape = declared->shape;
      }
    } else if (const auto* const map = std::get_if<MapShape>(found)) {
      shape = *map->entry;
    } else if (const auto* const list = std::get_if<ListShape>(found)) {
      shape = *list->entry;
    }
    const ValueShape* const here = value == nullptr ? nullptr : shape_of(shape, *value);
    const auto* const object = here == nullptr ? nullptr : std::get_if<ObjectShape>(here);
    if (object != nullptr) parts.back().table = object->table;
  }
  return parts;
}

std::string summary_of(const ValueShape& shape, const json& value, const std::string& pointer,
                       const std::function<std::string(std::string_view word)>& name_of) {
  const ValueShape* const found = shape_of(shape, value);
  if (value.is_string()) {
    const auto given = value.get<std::string>();
    const auto* const name = found == nullptr ? nullptr : std::get_if<NameShape>(found);
    const bool is_role = name != nullptr && name->registry == kRoleNames;
    const bool is_word = found != nullptr && std::holds_alternative<WordShape>(*found);
    return is_word || is_role ? name_of(given) : given;
  }
  if (value.is_number()) {
    const auto* const number = found == nullptr ? nullptr : std::get_if<NumberShape>(found);
    return number == nullptr ? value.dump() : with_unit(*number, value, pointer);
  }
  if (found == nullptr) return {};
  std::string summary{};
  std::size_t parts = 0;
  const auto add = [&](const ValueShape& of_part, const json& part, const std::string& place) {
    if (parts == kPartsOfSummary) return;
    const std::string text = summary_of(of_part, part, place, name_of);
    if (text.empty()) return;
    summary = joined_text(std::move(summary), text);
    ++parts;
  };
  if (const auto* const object = std::get_if<ObjectShape>(found)) {
    // The groups of a screen come first; a long text would push them out of sight.
    const bool has_kinds = !object->table->deciding.empty();
    for (const bool is_last : {false, true}) {
      for (const ProtocolKey& key : object->table->keys) {
        const bool is_name = std::ranges::find(kNamesOfEntries, key.name) != kNamesOfEntries.end();
        if (value.contains(key.name) && !is_name &&
            (has_kinds && is_paragraph(key.shape)) == is_last)
          add(key.shape, value.at(key.name), pointer_to(pointer, key.name));
      }
    }
  } else if (const auto* const list = std::get_if<ListShape>(found)) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      add(*list->entry, value[i], pointer_to(pointer, i));
    }
  } else if (const auto* const map = std::get_if<MapShape>(found)) {
    for (const auto& [key, entry] : value.items()) {
      if (!is_comment(key)) add(*map->entry, entry, pointer_to(pointer, key));
    }
  }
  if (summary.size() <= kLongestSummary) return summary;
  std::size_t end = kLongestSummary;  // not within a character
  while ((static_cast<unsigned char>(summary[end]) & 0xC0U) == 0x80U) --end;
  return summary.substr(0, end) + "…";
}

}  // namespace asperity
