// The values of a protocol that a form shows.

#pragma once

#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/form/form_entries.h"
#include "protocols/keys/tables.h"

namespace asperity::test {

/// The values of a protocol that a form shows as fields and lists, with their shapes.
struct ShownValue {
  std::string pointer{};
  ValueShape shape{};
  bool is_present = false;
};
inline void collect(const nlohmann::json& value, const ValueShape& shape,
                    const std::string& pointer, const nlohmann::json& protocol,
                    std::vector<ShownValue>& all) {
  all.push_back({pointer, shape, true});
  const ValueShape* const found = shape_of(shape, value);
  if (found == nullptr) return;
  if (const auto* const object = std::get_if<ObjectShape>(found)) {
    for (const FormEntry& entry : entries_of(*object->table, value, pointer, protocol)) {
      if (entry.is_present) {
        collect(value.at(entry.key->name), entry.key->shape, entry.pointer, protocol, all);
      } else {
        all.push_back({entry.pointer, entry.key->shape, false});
      }
    }
  } else if (const auto* const map = std::get_if<MapShape>(found)) {
    for (const auto& [key, entry] : value.items()) {
      if (!is_comment(key)) collect(entry, *map->entry, pointer_to(pointer, key), protocol, all);
    }
  } else if (const auto* const list = std::get_if<ListShape>(found)) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect(value[i], *list->entry, pointer_to(pointer, i), protocol, all);
    }
  }
}

/// All of them, with the keys that have no value.
inline std::vector<ShownValue> values_of_form(const nlohmann::json& protocol) {
  std::vector<ShownValue> all{};
  collect(protocol, ObjectShape{&kProtocolTable}, "", protocol, all);
  return all;
}

}  // namespace asperity::test
