// Implements the conditions of keys, and the search for keys that do not apply as one walk over the objects of a protocol.

#include "protocols/keys/conditions.h"

#include <algorithm>
#include <variant>

#include <nlohmann/json.hpp>

#include "protocols/design/json_pointer.h"
#include "protocols/keys/tables.h"
#include "protocols/shapes/common_shapes.h"

namespace asperity {

namespace {

using nlohmann::json;

std::string text_at(const json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

bool includes(const KeyCondition& condition, const std::string& value) {
  return std::ranges::find(condition.values(), value) != condition.values().end();
}

/// Whether the nearest object around the one at `pointer` that has the other key has one of the values.
bool holds_around(const KeyCondition& condition, const json& protocol, const std::string& pointer) {
  json::json_pointer place(pointer);
  while (!place.empty()) {
    place.pop_back();
    if (!protocol.contains(place)) continue;
    const json& object = protocol.at(place);
    if (!object.is_object() || !object.contains(condition.key)) continue;
    const json& value = object.at(condition.key);
    return value.is_string() && includes(condition, value.get<std::string>());
  }
  return true;
}

/// Whether the key applies to the object: without a condition if it does.
InapplicableKey applied(const ProtocolKey& key, const json& object, const json& protocol,
                        const std::string& pointer) {
  const auto holds = [&](const KeyCondition& condition) {
    switch (condition.of) {
      case KeyCondition::Of::object:
        return holds_in(condition, object);
      case KeyCondition::Of::around:
        return holds_around(condition, protocol, pointer);
      case KeyCondition::Of::kind: {
        if (!holds_in(kScaleOfTheKind, object)) return true;  // an additional question
        const std::set<std::string> kinds = kinds_at(protocol, pointer);
        return std::ranges::any_of(
            kinds, [&condition](const std::string& kind) { return includes(condition, kind); });
      }
    }
    return true;
  };
  InapplicableKey found{.pointer = pointer_to(pointer, key.name)};
  const auto stated = object.find(key.name);
  const bool is_default = stated != object.end() && *stated == default_of(key);
  for (const KeyCondition& condition : key.conditions) {
    if (holds(condition)) continue;
    found.condition = &condition;
    found.is_permitted = is_default && condition.of != KeyCondition::Of::object;
    if (!found.is_permitted) break;
  }
  return found;
}

/// Visits every object with its table.
class ConditionWalk final {
 public:
  ConditionWalk(const json& protocol, std::vector<InapplicableKey>& found)
      : protocol_(protocol), found_(found) {}

  void visit(const json& value, const ValueShape& shape, const std::string& pointer) {
    const ValueShape* const one = shape_of(shape, value);
    if (one == nullptr) return;
    if (const auto* const object = std::get_if<ObjectShape>(one)) {
      visit_object(value, *object->table, pointer);
    } else if (const auto* const list = std::get_if<ListShape>(one)) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        visit(value[i], *list->entry, pointer_to(pointer, i));
      }
    } else if (const auto* const map = std::get_if<MapShape>(one)) {
      for (const auto& [name, member] : value.items()) {
        if (!is_comment(name)) visit(member, *map->entry, pointer_to(pointer, name));
      }
    }
  }

 private:
  void visit_object(const json& object, const KeyTable& table, const std::string& pointer) {
    for (const ProtocolKey& key : table.keys) {
      const auto member = object.find(key.name);
      if (member == object.end()) continue;
      const InapplicableKey found = applied(key, object, protocol_, pointer);
      if (found.condition == nullptr) {
        visit(*member, key.shape, found.pointer);
      } else {
        found_.push_back(found);
      }
    }
  }

  const json& protocol_;
  std::vector<InapplicableKey>& found_;
};

}  // namespace

std::set<std::string> kinds_at(const json& protocol, const std::string& pointer) {
  const std::string of_protocol = text_at(protocol, "kind");
  const auto blocks = protocol.find("blocks");
  std::set<std::string> kinds{};
  if (blocks != protocol.end() && blocks->is_object()) {
    for (const auto& [name, block] : blocks->items()) {
      if (is_comment(name)) continue;
      const std::string own = text_at(block, "kind");
      const std::string& kind = own.empty() ? of_protocol : own;
      const std::string place = pointer_to("/blocks", name);
      if (pointer == place || pointer.starts_with(place + '/')) return {kind};
      kinds.insert(kind);
    }
  }
  if (kinds.empty()) kinds.insert(of_protocol);
  return kinds;
}

const KeyCondition* unmet_condition(const ProtocolKey& key, const json& object,
                                    const json& protocol, const std::string& pointer) {
  const InapplicableKey found = applied(key, object, protocol, pointer);
  return found.is_permitted ? nullptr : found.condition;
}

json without_keys(json protocol, const std::vector<InapplicableKey>& keys) {
  for (const InapplicableKey& key : keys) {
    const json::json_pointer place(key.pointer);
    protocol.at(place.parent_pointer()).erase(place.back());
  }
  return protocol;
}

std::vector<InapplicableKey> inapplicable_keys(const json& protocol) {
  std::vector<InapplicableKey> found{};
  ConditionWalk(protocol, found).visit(protocol, ObjectShape{&kProtocolTable}, "");
  return found;
}

}  // namespace asperity
