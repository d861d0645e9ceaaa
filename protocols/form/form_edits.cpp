// Implements the edits of a form as edits of the text.

#include "protocols/form/form_edits.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "protocols/design/json_pointer.h"
#include "protocols/editing/edits.h"
#include "protocols/editing/renaming.h"
#include "protocols/editing/text_entries.h"
#include "protocols/form/new_entries.h"
#include "protocols/form/new_values.h"
#include "protocols/form/offered_names.h"
#include "protocols/keys/tables.h"

namespace asperity {

namespace {

using nlohmann::json;

constexpr const char* kEdited = "the edited protocol";

[[noreturn]] void refuse_entry(const JsonDocument& protocol, const std::string& container) {
  refuse(protocol, container,
         phrase("Protocols", "a form cannot add an entry here; add it in the text"));
}

std::string parent_of(const std::string& pointer) {
  return json::json_pointer(pointer).parent_pointer().to_string();
}
std::string key_of(const std::string& pointer) { return json::json_pointer(pointer).back(); }

std::optional<ValueShape> container_shape(const JsonDocument& protocol,
                                          const std::string& container) {
  const auto shape = shape_at(kProtocolTable, protocol.root(), container);
  if (!shape) return {};
  const ValueShape* const found = shape_of(*shape, value_at(protocol, container));
  return found == nullptr ? std::nullopt : std::optional(*found);
}

/// The entry of a list that is the name at the place, a combination of levels with it, or what is done with the thing, such as the
/// run of a block; nullopt for other places.
std::optional<std::string> entry_about(const JsonDocument& protocol, const std::string& pointer) {
  const std::string around = parent_of(pointer);
  if (value_at(protocol, around).is_array()) return pointer;
  const auto list = container_shape(protocol, parent_of(around));
  if (!list || !std::holds_alternative<ListShape>(*list)) return {};
  const ValueShape* const entry =
      shape_of(*std::get<ListShape>(*list).entry, value_at(protocol, around));
  if (entry == nullptr) return {};
  const auto* const object = std::get_if<ObjectShape>(entry);
  const bool is_about =
      object == nullptr || std::ranges::count(object->table->deciding, key_of(pointer)) > 0;
  return is_about ? std::optional(around) : std::nullopt;
}

/// What the keys of a map refer to; at the top of a protocol they declare.
NameShape names_of_keys(const MapShape& map, const std::string& pointer) {
  const json::json_pointer path(pointer);
  if (path.parent_pointer().empty() && !path.empty()) {
    return {.registry = kProtocolTable.find(path.back())->name, .is_declared = true};
  }
  return map.key;
}

std::vector<std::string> keys_of_object(const json& object) {
  std::vector<std::string> keys{};
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// A key for a copy: the first one that is free, of the name or with a number behind it.
std::string key_of_copy(const JsonDocument& protocol, const std::string& container,
                        const NameShape& keys, const std::string& wish) {
  std::vector<std::string> taken = keys_of_object(value_at(protocol, container));
  const std::vector<std::string> known = declared_names(names_in(protocol.root()), keys.registry);
  if (!keys.registry.empty() && !keys.is_declared) {
    for (const std::string& name : known) {
      if (std::find(taken.begin(), taken.end(), name) == taken.end()) return name;
    }
  }
  taken.insert(taken.end(), known.begin(), known.end());
  return free_name(taken, wish);
}

/// Names that the copy declares next to those of the entry that it was copied from are other ones.
FormEdit with_own_names(FormEdit copied) {
  const ProtocolNames names = names_in(JsonDocument(copied.text, kEdited).root());
  for (const NameUse& use : names.uses) {
    if (!use.is_declared || use.is_key || parent_of(use.pointer) != copied.pointer) continue;
    const std::string name = free_name(declared_names(names, use.registry), use.name);
    const JsonDocument protocol(copied.text, kEdited);
    copied.text = changed(copied.text, set_value(protocol, use.pointer, json_string(name)));
  }
  return copied;
}

/// A copied texture has a code that no other has: the next one of T1, T2, …
FormEdit with_own_code(FormEdit copied) {
  const JsonDocument protocol(copied.text, kEdited);
  const std::string container = parent_of(copied.pointer);
  const json& textures = value_at(protocol, container);
  const json& own = value_at(protocol, copied.pointer);
  if (!own.is_object() || !own.contains("code")) return copied;
  std::set<std::string> taken{};
  for (const json& texture : textures) {
    if (texture.is_object()) taken.insert(texture.value("code", json()).dump());
  }
  std::string code{};
  for (int number = 1; code.empty() || taken.contains(code); ++number) {
    code = json_string("T" + std::to_string(number));
  }
  copied.text = changed(copied.text, set_value(protocol, pointer_to(copied.pointer, "code"), code));
  return copied;
}

}  // namespace

FormEdit with_value(const JsonDocument& protocol, const std::string& pointer,
                    std::string_view value) {
  const json::json_pointer path(pointer);
  if (protocol.root().contains(path)) {
    return {changed(protocol.text(), set_value(protocol, pointer, value)), pointer};
  }
  // The outermost object that is absent is written with the objects in it.
  json::json_pointer container = path.parent_pointer();
  std::string key = path.back();
  std::string written(value);
  while (!protocol.root().contains(container)) {
    written = "{" + json_string(key) + ": " + written + "}";
    key = container.back();
    container = container.parent_pointer();
  }
  return {changed(protocol.text(), insert_member(protocol, container.to_string(), key, written)),
          pointer};
}

FormEdit with_new_value(const JsonDocument& protocol, const std::string& pointer,
                        const ProtocolKey& key) {
  const nlohmann::ordered_json value = new_value(key.shape, names_of_form(protocol));
  if (pointer == "/groups" && value.at("factor") == "") {
    return {with_factor_of_groups(protocol).text, pointer};
  }
  return with_value(protocol, pointer, value.dump());
}

FormEdit without(const JsonDocument& protocol, std::span<const std::string> pointers) {
  return {changed(protocol.text(), remove_entries(protocol, pointers)),
          pointers.empty() ? std::string() : parent_of(pointers.front())};
}

std::vector<std::string> entries_naming(const JsonDocument& protocol, const ProtocolNames& names,
                                        std::span<const std::string> pointers) {
  const auto is_gone = [pointers](const NameUse& use) {
    return std::ranges::any_of(pointers, [&use](const std::string& pointer) {
      return use.pointer == pointer || use.pointer.starts_with(pointer + "/");
    });
  };
  std::vector<const NameUse*> declared{};
  for (const NameUse& use : names.uses) {
    if (use.is_declared && is_gone(use)) declared.push_back(&use);
  }
  const auto is_same = [](const NameUse& one, const NameUse& other) {
    return one.name == other.name && one.registry == other.registry;
  };
  std::erase_if(declared, [&](const NameUse* one) {  // what another value declares too
    return std::ranges::any_of(names.uses, [&](const NameUse& use) {
      return use.is_declared && is_same(use, *one) && !is_gone(use);
    });
  });
  // A level that is a texture leaves with the texture, and the texture stays where a level leaves.
  const auto names_it = [&](const NameUse& use, const NameUse& one) {
    return is_same(use, one) ||
           (use.name == one.name && std::ranges::any_of(names.links, [&](const auto& link) {
              return link.first == use.registry && link.second == one.registry;
            }));
  };
  std::vector<std::string> entries{};
  for (const NameUse& use : names.uses) {
    if (use.is_key || use.is_in_formula || is_gone(use)) continue;
    const bool is_named =
        std::ranges::any_of(declared, [&](const NameUse* one) { return names_it(use, *one); });
    if (!is_named) continue;
    const auto entry = entry_about(protocol, use.pointer);
    // A listed trial can name it twice.
    if (entry && std::ranges::count(entries, *entry) == 0) entries.push_back(*entry);
  }
  return entries;
}

FormEdit with_removed(const JsonDocument& protocol, std::vector<std::string> pointers) {
  const ProtocolNames before = names_of_form(protocol);
  std::ranges::copy(entries_naming(protocol, before, pointers), std::back_inserter(pointers));
  FormEdit edit = without(protocol, pointers);
  const JsonDocument removed(edit.text, kEdited);
  const ProtocolNames after = names_of_form(removed);
  constexpr NameShape kTest{.registry = kTestNames};
  const auto has = [&kTest](const ProtocolNames& names, const std::string& test) {
    return std::ranges::count(offered_names(names, kTest), test) > 0;
  };
  std::vector<std::string> tests{};  // that no block has any more
  for (const NameUse& use : after.uses) {
    const bool is_gone = has(before, use.name) && !has(after, use.name);
    if (use.registry == kTestNames && is_gone) tests.push_back(use.pointer);
  }
  if (tests.empty()) return edit;
  const std::string family = parent_of(tests.front());
  if (value_at(removed, family).size() == tests.size()) tests = {family};
  return {without(removed, tests).text, edit.pointer};
}

FormEdit with_entry(const JsonDocument& protocol, const std::string& container,
                    std::string_view key) {
  const TextContainer entries(protocol, container);
  std::vector<std::string> keys{};  // of the members; empty ones of the entries of a list
  for (const TextEntry& entry : entries.entries()) {
    if (!is_comment(entry.key)) keys.push_back(entry.key);
  }
  const auto shape = container_shape(protocol, container);
  const ProtocolNames names = names_of_form(protocol);
  if (!entries.is_object()) {
    const auto* const list = shape ? std::get_if<ListShape>(&*shape) : nullptr;
    if (list == nullptr) refuse_entry(protocol, container);
    const std::size_t count = keys.size();
    nlohmann::ordered_json value{};
    const auto* const object = std::get_if<ObjectShape>(list->entry);
    const ProtocolKey* const kind =
        object == nullptr || key.empty() ? nullptr : object->table->find(key);
    if (kind != nullptr) {
      value[std::string(key)] = new_value(kind->shape, names);
    } else if (auto entry = new_entry(protocol, names, container, *list, count)) {
      value = std::move(*entry);
    } else if (count > 0) {
      return with_copy(protocol, pointer_to(container, count - 1));
    } else {
      value = new_value(*list->entry, names);
    }
    return {changed(protocol.text(), insert_entry(protocol, container, count, value.dump())),
            pointer_to(container, count)};
  }
  const auto* const map = shape ? std::get_if<MapShape>(&*shape) : nullptr;
  if (map == nullptr) refuse_entry(protocol, container);
  if (key.empty() && !keys.empty()) {
    return with_copy(protocol, pointer_to(container, keys.back()));
  }
  const std::string name =
      key.empty() ? key_of_copy(protocol, container, names_of_keys(*map, container), "new")
                  : std::string(key);
  return {changed(protocol.text(),
                  insert_member(protocol, container, name, new_value(*map->entry, names).dump())),
          pointer_to(container, name)};
}

FormEdit with_copy(const JsonDocument& protocol, const std::string& pointer) {
  const std::string container = parent_of(pointer);
  const auto [entries, index] = entry_at(protocol, pointer);
  const auto shape = container_shape(protocol, container);
  if (!entries.is_object()) {
    const auto* const list = shape ? std::get_if<ListShape>(&*shape) : nullptr;
    const auto own =
        list == nullptr ? std::nullopt
                        : new_entry(protocol, names_of_form(protocol), container, *list, index + 1);
    const std::string after =
        changed(protocol.text(), own ? insert_entry(protocol, container, index + 1, own->dump())
                                     : duplicate_entry(protocol, pointer));
    return with_own_names({after, pointer_to(container, index + 1)});
  }
  const auto* const map = shape ? std::get_if<MapShape>(&*shape) : nullptr;
  const NameShape keys = map == nullptr ? NameShape{} : names_of_keys(*map, container);
  const std::string name = key_of_copy(protocol, container, keys, key_of(pointer));
  FormEdit copied{changed(protocol.text(), duplicate_entry(protocol, pointer, name)),
                  pointer_to(container, name)};
  return container == "/textures" ? with_own_code(std::move(copied)) : copied;
}

FormEdit with_moved(const JsonDocument& protocol, const std::string& pointer, std::size_t index) {
  const std::string container = parent_of(pointer);
  const bool is_object = TextContainer(protocol, container).is_object();
  return {changed(protocol.text(), move_entry(protocol, pointer, index)),
          is_object ? pointer : pointer_to(container, index)};
}

FormEdit with_name(const JsonDocument& protocol, const std::string& pointer, Named named,
                   std::string_view after) {
  const bool is_key = named == Named::by_key;
  const std::string renamed = is_key ? pointer_to(parent_of(pointer), after) : pointer;
  const ProtocolNames names = names_in(protocol.root());
  if (const NameUse* const declared = declaration_at(names, pointer, is_key)) {
    return {changed(protocol.text(),
                    rename_or_replace(protocol, declared->registry, declared->name, after)),
            renamed};
  }
  if (!is_key) return with_value(protocol, pointer, json_string(after));
  // The key alone: a copy behind the member, without the member.
  if (key_of(pointer) == after) return {std::string(protocol.text()), pointer};
  const std::string copied = changed(protocol.text(), duplicate_entry(protocol, pointer, after));
  return {changed(copied, remove_entry(JsonDocument(copied, kEdited), pointer)), renamed};
}

FormEdit with_factor_of_groups(const JsonDocument& protocol) {
  const std::string name =
      free_name(declared_names(names_in(protocol.root()), kFactorNames), "group");
  FormEdit edit =
      with_value(protocol, pointer_to("/factors", name), R"({"levels": ["group_1", "group_2"]})");
  edit.text =
      with_value(JsonDocument(edit.text, kEdited), "/groups/factor", json_string(name)).text;
  return edit;
}

}  // namespace asperity
