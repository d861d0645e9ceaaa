// Implements the search for names as one walk over the values of a protocol and their shapes.

#include "protocols/keys/names_in.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "protocols/design/arithmetic.h"
#include "protocols/design/json_pointer.h"
#include "protocols/design/wording.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

using nlohmann::json;

class NameWalk final {
 public:
  explicit NameWalk(ProtocolNames& names) : names_(names) {}

  void protocol(const json& root) {
    if (!root.is_object()) return;
    for (const ProtocolKey& key : kProtocolTable.keys) {
      const auto found = root.find(key.name);
      if (found == root.end()) continue;
      ValueShape shape = key.shape;
      if (auto* const map = std::get_if<MapShape>(&shape)) map->key = {key.name, true};
      visit(*found, shape, {pointer_to("", key.name), {}});
    }
    for (NameUse& use : names_.uses) {
      if (use.registry == kGroupNames && !names_.groups.empty()) use.registry = names_.groups;
    }
    add_numbers_of_groups(root);
  }

 private:
  struct Place {
    std::string pointer{};
    std::string factor{};  ///< whose levels are written here; empty: none
  };

  void visit(const json& value, const ValueShape& shape, const Place& place) {
    add_links(value, shape);
    const ValueShape* const one = shape_of(shape, value);
    if (one == nullptr) return;
    std::visit([&](const auto& found) { names_of(found, value, place); }, *one);
  }

  template <class Shape>
  void names_of(const Shape&, const json&, const Place&) {}  // contains no names

  void names_of(const NameShape& shape, const json& value, const Place& place) {
    add(shape, value.get<std::string>(), {.pointer = place.pointer}, place);
  }
  void names_of(const TextShape& shape, const json& value, const Place& place) {
    const auto text = value.get<std::string>();
    if (!shape.is_formula) return add(shape.name, text, {.pointer = place.pointer}, place);
    const auto formula = Arithmetic::parse(text);
    const auto* const valid = std::get_if<Arithmetic>(&formula);
    if (valid == nullptr) return;
    for (const std::string& name : valid->names()) {
      add(shape.name, name, {.pointer = place.pointer, .is_in_formula = true}, place);
    }
  }
  void names_of(const ListShape& shape, const json& value, const Place& place) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      visit(value[i], *shape.entry, {pointer_to(place.pointer, i), place.factor});
    }
  }
  void names_of(const MapShape& shape, const json& value, const Place& place) {
    for (const auto& [key, member] : value.items()) {
      if (is_comment(key)) continue;
      const std::string pointer = pointer_to(place.pointer, key);
      add(shape.key, key, {.pointer = pointer, .is_key = true}, place);
      const bool is_of_factor = shape.key.registry == kFactorNames;
      visit(member, *shape.entry, {pointer, is_of_factor ? key : place.factor});
    }
  }
  void names_of(const ObjectShape& shape, const json& value, const Place& place) {
    const std::string own = governing_factor(*shape.table, value, true);
    for (const ProtocolKey& key : shape.table->keys) {
      const auto found = value.find(key.name);
      if (found == value.end()) continue;
      visit(*found, key.shape,
            {pointer_to(place.pointer, key.name), own.empty() ? place.factor : own});
    }
  }

  /// The factor whose levels are in the object, as one of its keys states, or a key of an object in it.
  static std::string governing_factor(const KeyTable& table, const json& object, bool or_inside) {
    for (const ProtocolKey& key : table.keys) {
      const auto found = object.find(key.name);
      if (found == object.end()) continue;
      const auto* const name = std::get_if<NameShape>(&key.shape);
      if (name != nullptr && name->governs_levels && found->is_string()) {
        return found->get<std::string>();
      }
      const auto* const inner = std::get_if<ObjectShape>(&key.shape);
      if (inner == nullptr || !or_inside || !found->is_object()) continue;
      std::string factor = governing_factor(*inner->table, *found, false);
      if (!factor.empty()) return factor;
    }
    return {};
  }

  void add(const NameShape& shape, const std::string& name, NameUse use, const Place& place) {
    const bool is_level = shape.registry == kLevelNames;
    if (shape.registry.empty() || (is_level && place.factor.empty())) return;
    use.registry = is_level ? levels_of(place.factor) : shape.registry;
    use.name = name;
    use.is_declared = shape.is_declared;
    names_.uses.push_back(std::move(use));
  }

  /// That the levels of a factor are names of another registry, by the value of a key of this shape.
  void add_links(const json& value, const ValueShape& shape) {
    if (const auto* const name = std::get_if<NameShape>(&shape)) {
      if (name->levels.empty() || !value.is_string()) return;
      const std::string levels = levels_of(value.get<std::string>());
      if (name->levels == kGroupNames) {
        names_.groups = levels;
      } else {
        names_.links.emplace_back(levels, name->levels);
      }
    } else if (const auto* const bound = std::get_if<BoundShape>(&shape)) {
      const auto* const inner = std::get_if<NameShape>(bound->value);
      if (inner == nullptr || !value.is_object() || !value.contains("factor")) return;
      const json& factor = value.at("factor");
      if (!factor.is_string()) return;
      names_.links.emplace_back(levels_of(factor.get<std::string>()), inner->registry);
    }
  }

  void add_numbers_of_groups(const json& root) {
    const json::json_pointer factor("/groups/factor");
    if (!root.contains(factor) || !root.at(factor).is_string()) return;
    const auto levels =
        json::json_pointer("/factors") / root.at(factor).get<std::string>() / "levels";
    if (!root.contains(levels)) return;
    for (const json& level : root.at(levels)) {
      if (level.is_number()) names_.numbers_of_groups.push_back(digits(level.get<double>()));
    }
  }

  ProtocolNames& names_;
};

bool has_name(const ProtocolNames& names, const std::string& registry, std::string_view name) {
  return std::any_of(names.uses.begin(), names.uses.end(), [&](const NameUse& use) {
    return use.registry == registry && use.name == name;
  });
}

}  // namespace

std::string levels_of(std::string_view factor) {
  return std::string(kLevelNames) + " of " + std::string(factor);
}

ProtocolNames names_in(const json& protocol) {
  ProtocolNames names{};
  NameWalk(names).protocol(protocol);
  return names;
}

std::string_view name_of_entry(const json& entry) {
  if (!entry.is_object()) return {};
  for (const std::string_view key : kNamesOfEntries) {
    const auto found = entry.find(key);
    if (found != entry.end() && found->is_string()) {
      return found->get_ref<const std::string&>();
    }
  }
  return {};
}

const NameUse* declaration_at(const ProtocolNames& names, const std::string& pointer, bool is_key) {
  const auto found = std::ranges::find_if(names.uses, [&](const NameUse& use) {
    return use.pointer == pointer && use.is_key == is_key && use.is_declared;
  });
  return found == names.uses.end() ? nullptr : &*found;
}

std::set<std::string> registries_of(const ProtocolNames& names, const std::string& registry,
                                    std::string_view name) {
  std::set<std::string> found{registry};
  for (std::size_t before = 0; before != found.size();) {
    before = found.size();
    for (const auto& [levels, other] : names.links) {
      // A level is a name of the other registry; the reverse only if the factor has this level.
      if (found.contains(levels)) found.insert(other);
      if (found.contains(other) && has_name(names, levels, name)) found.insert(levels);
    }
  }
  return found;
}

std::vector<NameUse> uses_of(const ProtocolNames& names, const std::string& registry,
                             std::string_view name) {
  const std::set<std::string> registries = registries_of(names, registry, name);
  std::vector<NameUse> uses{};
  for (const NameUse& use : names.uses) {
    if (use.name == name && registries.contains(use.registry)) uses.push_back(use);
  }
  return uses;
}

}  // namespace asperity
