// Writes the rows of a table with the members that receive the values: reading and defaults follow from a row.

#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "protocols/shapes/binding.h"
#include "protocols/shapes/key.h"

namespace asperity {

template <class Member>
concept NumberMember = std::is_arithmetic_v<Member> && !std::is_same_v<Member, bool>;
template <class Member>
concept WordMember = std::is_enum_v<Member> || std::is_same_v<Member, bool>;

// How a value of a shape is stored in a member: a pair of a shape and a type without a function does not compile. The
// members of a list or a map are of the type of its entries.

template <NumberMember Number>
void store_value(const NumberShape&, const nlohmann::json& value, Number& member) {
  member = value.get<Number>();
}
inline void store_value(const TruthShape&, const nlohmann::json& value, bool& member) {
  member = value.get<bool>();
}
template <WordMember Value>
void store_value(const WordShape& shape, const nlohmann::json& value, Value& member) {
  for (const KeyWord& word : shape.words) {
    if (value == word.name) member = static_cast<Value>(word.value);
  }
}
inline void store_value(const WordShape&, const nlohmann::json& value, std::string& member) {
  member = value.get<std::string>();
}
inline void store_value(const TextShape&, const nlohmann::json& value, std::string& member) {
  member = value.get<std::string>();
}
inline void store_value(const NameShape&, const nlohmann::json& value, std::string& member) {
  member = value.get<std::string>();
}
template <class Owner>
void store_value(const ObjectShape& shape, const nlohmann::json& value, Owner& member) {
  read_keys(*shape.table, value, static_cast<void*>(&member));
}
template <class Owner>
void store_value(const ObjectShape& shape, const nlohmann::json& value,
                 std::optional<Owner>& member) {
  store_value(shape, value, member.emplace());
}
/// An entry of a list or a map.
template <class Value>
void store_entry(const ValueShape& shape, const nlohmann::json& value, Value& member) {
  const auto store = [&](const auto& one) {
    if constexpr (requires { store_value(one, value, member); }) store_value(one, value, member);
  };
  std::visit(store, shape);
}
template <class Value>
void store_value(const ListShape& shape, const nlohmann::json& value, std::vector<Value>& member) {
  for (const nlohmann::json& entry : value) store_entry(*shape.entry, entry, member.emplace_back());
}
template <glm::length_t N, glm::qualifier Q>
void store_value(const ListShape& shape, const nlohmann::json& value,
                 glm::vec<N, double, Q>& member) {
  for (glm::length_t i = 0; i < N; ++i) {
    store_entry(*shape.entry, value.at(static_cast<std::size_t>(i)), member[i]);
  }
}
template <class Value, std::size_t N>
void store_value(const ListShape& shape, const nlohmann::json& value,
                 std::array<Value, N>& member) {
  for (std::size_t i = 0; i < N; ++i) store_entry(*shape.entry, value.at(i), member[i]);
}
/// A value that has a name receives its key.
template <class Value, class Order>
void store_value(const MapShape& shape, const nlohmann::json& value,
                 std::map<std::string, Value, Order>& member) {
  for (const auto& [name, entry] : value.items()) {
    Value& stored = member[name];
    if constexpr (requires { stored.name = name; }) stored.name = name;
    store_entry(*shape.entry, entry, stored);
  }
}
inline void store_value(const FormsShape&, const nlohmann::json& value,
                        std::variant<double, std::string>& member) {
  if (value.is_number()) {
    member = value.get<double>();
  } else {
    member = value.get<std::string>();
  }
}
template <class Value>
void store_value(const BoundShape& shape, const nlohmann::json& value, Binding<Value>& member) {
  if (value.is_object()) {
    member.factor = value.at("factor").get<std::string>();
  } else {
    store_entry(*shape.value, value, member.value.emplace());
  }
}
template <class ShapeOfValue, class Value>
void store_value(const ShapeOfValue& shape, const nlohmann::json& value,
                 std::optional<Value>& member) {
  store_value(shape, value, member.emplace());
}

// The default, as a file writes the value of a new member; null for a member whose absence means something else.

template <class ShapeOfValue, class Value>
nlohmann::json standard_value(const ShapeOfValue&, const Value&) {
  return nullptr;
}
template <NumberMember Number>
nlohmann::json standard_value(const NumberShape& shape, const Number& member) {
  // A number that the key does not permit stands for the absence of the key.
  return lies_within(shape, static_cast<double>(member)) ? nlohmann::json(member) : nullptr;
}
inline nlohmann::json standard_value(const TruthShape&, const bool& member) { return member; }
template <WordMember Value>
nlohmann::json standard_value(const WordShape& shape, const Value& member) {
  for (const KeyWord& word : shape.words) {
    if (word.value == static_cast<int>(member)) return word.name;
  }
  return nullptr;
}

/// A text that is not empty is that of a key with a default: "en" of the language.
inline nlohmann::json standard_value(const TextShape&, const std::string& member) {
  return member.empty() ? nlohmann::json(nullptr) : nlohmann::json(member);
}

/// The words of a shape with the values of one type.
template <class Value, std::size_t N>
struct WordsOf {
  std::array<KeyWord, N> words{};
};
template <class Value>
struct WordFor {
  std::string_view name{};
  Value value{};
  std::string_view meaning{};
};
template <class Value, std::size_t N>
consteval WordsOf<Value, N> words_of(const WordFor<Value> (&given)[N]) {
  WordsOf<Value, N> made{};
  for (std::size_t i = 0; i < N; ++i) {
    made.words[i] = {given[i].name, static_cast<int>(given[i].value), given[i].meaning};
  }
  return made;
}

template <class List>
struct EntryOf {
  using Type = typename List::value_type;
};
template <class Value, class Order>
struct EntryOf<std::map<std::string, Value, Order>> {
  using Type = Value;
};
template <class Value>
struct EntryOf<std::optional<Value>> : EntryOf<Value> {};

/// Whether there is a function that stores a value of the shape, and of the shape of its entries. Whether an object is of
/// the type of its table is checked where the table is named.
template <class Member, class ShapeOfValue>
constexpr bool can_store(const ShapeOfValue& shape) {
  constexpr bool kHasFunction = requires(const nlohmann::json& value, Member& member) {
    store_value(shape, value, member);
  };
  if constexpr (kHasFunction && requires { shape.entry->index(); }) {
    using Entry = typename EntryOf<Member>::Type;
    const auto can_store_it = []<class ShapeOfEntry>(const ShapeOfEntry& entry) {
      return !std::is_same_v<ShapeOfEntry, ObjectShape> && can_store<Entry>(entry);
    };
    return std::visit(can_store_it, *shape.entry);
  }
  return kHasFunction;
}

/// A row of the table of an Owner.
template <class Owner>
struct KeyOf : ProtocolKey {};

template <class Member>
struct MemberOf;
template <class OwnerOfMember, class ValueOfMember>
struct MemberOf<ValueOfMember OwnerOfMember::*> {
  using Owner = OwnerOfMember;
};

template <class Function>
struct OwnerOfStore;
template <class OwnerOfFunction>
struct OwnerOfStore<void (*)(const nlohmann::json&, OwnerOfFunction&)> {
  using Owner = OwnerOfFunction;
};

/// A key whose value is stored in `owner.*member`, if there is a function for its shape.
template <auto member, class ShapeOfValue>
consteval auto unchecked_key(std::string_view name, std::string_view label,
                             std::string_view meaning, const ShapeOfValue& shape) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  KeyOf<Owner> row{};
  row.name = name;
  row.label = label;
  row.meaning = meaning;
  row.shape = shape;
  row.store = [](const ProtocolKey& self, const nlohmann::json& value, void* owner) {
    store_value(std::get<ShapeOfValue>(self.shape), value, static_cast<Owner*>(owner)->*member);
  };
  row.standard = [](const ProtocolKey& self) {
    return standard_value(std::get<ShapeOfValue>(self.shape), Owner{}.*member);
  };
  return row;
}
/// A key whose value is stored in `owner.*member`.
template <auto member, class ShapeOfValue>
consteval auto member_key(std::string_view name, std::string_view label, std::string_view meaning,
                          const ShapeOfValue& shape) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  if (!can_store<Member>(shape)) throw "there is no function that stores the shape in the member";
  return unchecked_key<member>(name, label, meaning, shape);
}
/// A key with the words of the type of its member. `words` is a constant with static storage.
template <auto member, class Value, std::size_t N>
consteval auto member_key(std::string_view name, std::string_view label, std::string_view meaning,
                          const WordsOf<Value, N>& words) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<Member, Value> || std::is_same_v<Member, std::optional<Value>>);
  return member_key<member>(name, label, meaning, WordShape{words.words});
}
/// A key with an object that is stored in `owner.*member`; its meaning is that of the table, unless
/// another is stated.
template <auto member, class Inner>
consteval auto member_key(std::string_view name, std::string_view label,
                          const KeyTableOf<Inner>& table, std::string_view meaning = "") {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<Member, Inner> || std::is_same_v<Member, std::optional<Inner>>);
  return unchecked_key<member>(name, label, meaning, ObjectShape{&table});
}
/// An object with the keys of a table, as the shape of an entry.
template <const auto& table>
inline constexpr ValueShape kObjectOf = ObjectShape{&table};

template <class Owner>
Owner owner_of(const KeyTableOf<Owner>& table);

/// A key with objects by name that are stored in `owner.*member`, a map.
template <auto member, const auto& table>
consteval auto map_key(std::string_view name, std::string_view label, std::string_view meaning,
                       MapShape sizes = {}) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<typename EntryOf<Member>::Type, decltype(owner_of(table))>);
  sizes.entry = &kObjectOf<table>;
  return unchecked_key<member>(name, label, meaning, sizes);
}
/// The same with objects in a list, a vector.
template <auto member, const auto& table>
consteval auto list_key(std::string_view name, std::string_view label, std::string_view meaning,
                        ListShape sizes) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<typename EntryOf<Member>::Type, decltype(owner_of(table))>);
  sizes.entry = &kObjectOf<table>;
  return unchecked_key<member>(name, label, meaning, sizes);
}
/// A key whose value a function stores: void(const nlohmann::json& value, Owner& owner).
template <auto function>
consteval auto custom_key(std::string_view name, std::string_view label, std::string_view meaning,
                          const ValueShape& shape) {
  using Owner = typename OwnerOfStore<decltype(function)>::Owner;
  KeyOf<Owner> row{};
  row.name = name;
  row.label = label;
  row.meaning = meaning;
  row.shape = shape;
  row.store = [](const ProtocolKey&, const nlohmann::json& value, void* owner) {
    function(value, *static_cast<Owner*>(owner));
  };
  row.standard = [](const ProtocolKey&) { return nlohmann::json(nullptr); };
  return row;
}
/// A key with an object whose keys are stored in the owner of the key itself; its meaning is that of the table.
template <class Owner>
consteval KeyOf<Owner> inner_key(std::string_view name, std::string_view label,
                                 const KeyTableOf<Owner>& table) {
  KeyOf<Owner> row{};
  row.name = name;
  row.label = label;
  row.shape = ObjectShape{&table};
  row.store = [](const ProtocolKey& self, const nlohmann::json& value, void* owner) {
    read_keys(*std::get<ObjectShape>(self.shape).table, value, owner);
  };
  row.standard = [](const ProtocolKey&) { return nlohmann::json(nullptr); };
  return row;
}
/// A key whose value is stored in a map, under the name of the key.
template <class Map, class ShapeOfValue>
consteval KeyOf<Map> entry_key(std::string_view name, std::string_view label,
                               std::string_view meaning, const ShapeOfValue& shape) {
  KeyOf<Map> row{};
  row.name = name;
  row.label = label;
  row.meaning = meaning;
  row.shape = shape;
  row.store = [](const ProtocolKey& self, const nlohmann::json& value, void* owner) {
    store_value(std::get<ShapeOfValue>(self.shape), value,
                (*static_cast<Map*>(owner))[std::string(self.name)]);
  };
  row.standard = [](const ProtocolKey&) { return nlohmann::json(nullptr); };
  return row;
}

template <class Owner>
consteval KeyOf<Owner> required_key(KeyOf<Owner> row) {
  row.is_required = true;
  return row;
}
/// A key that applies where all of the conditions hold.
template <class Owner, class... Conditions>
requires(sizeof...(Conditions) > 0) consteval KeyOf<Owner> when(KeyOf<Owner> row,
                                                                const Conditions&... conditions) {
  row.conditions = {conditions...};
  return row;
}
/// The alternative of a variant, which becomes the current one.
template <class Alternative, class Variant>
Alternative& alternative_in(Variant& variant) {
  if (!std::holds_alternative<Alternative>(variant)) variant.template emplace<Alternative>();
  return std::get<Alternative>(variant);
}
/// A key of one alternative of a variant, which its value makes the current one.
template <class Variant, class Alternative>
consteval KeyOf<Variant> alternative_of(const KeyOf<Alternative>& row) {
  KeyOf<Variant> made{};
  static_cast<ProtocolKey&>(made) = row;
  made.standard = [](const ProtocolKey&) { return nlohmann::json(nullptr); };
  made.part = [](void* owner) -> void* {
    return &alternative_in<Alternative>(*static_cast<Variant*>(owner));
  };
  return made;
}
/// A key whose meaning includes those of its words.
template <class Owner>
consteval KeyOf<Owner> listing_words(KeyOf<Owner> row) {
  (void)std::get<WordShape>(row.shape);
  row.lists_words = true;
  return row;
}
/// A key whose default is not the value of its member.
template <class Owner>
consteval KeyOf<Owner> with_standard(KeyOf<Owner> row,
                                     nlohmann::json (*standard)(const ProtocolKey&)) {
  row.standard = standard;
  return row;
}
template <class Owner>
consteval KeyOf<Owner> with_computed_default(KeyOf<Owner> row, std::string_view text) {
  row.computed_default = text;
  return row;
}

/// The rows of the table of an Owner: constants with static storage.
template <class Owner, std::size_t N>
struct KeysOf {
  std::array<ProtocolKey, N> rows{};
};
template <class Owner, class... Others>
consteval auto keys_of(const KeyOf<Owner>& first, const Others&... others) {
  static_assert((std::is_same_v<Others, KeyOf<Owner>> && ...), "rows of one owner");
  return KeysOf<Owner, 1 + sizeof...(Others)>{{first, others...}};
}
/// The rows of a part, for the table of the object that contains it.
template <class Owner, class Part, std::size_t N>
consteval KeysOf<Owner, N> in_part(const KeysOf<Part, N>& keys, void* (*part)(void* owner)) {
  KeysOf<Owner, N> made{keys.rows};
  for (ProtocolKey& row : made.rows) row.part = part;
  return made;
}
/// Rows that kinds of experiment own.
template <class Owner, std::size_t N>
consteval KeysOf<Owner, N> owned_by(std::initializer_list<std::string_view> kinds,
                                    KeysOf<Owner, N> keys) {
  for (ProtocolKey& row : keys.rows) {
    KeyCondition* free = row.conditions.begin();
    while (!free->key.empty()) ++free;
    *free = of_kinds(kinds);
  }
  return keys;
}
/// The rows of one alternative of a variant, for the table of the object that has the variant: a value of such a key makes
/// the alternative the current one. `variant_of` finds the variant in the owner.
template <class Owner, auto variant_of, class Alternative, std::size_t N>
consteval KeysOf<Owner, N> own_keys(const KeysOf<Alternative, N>& keys) {
  return in_part<Owner>(
      keys, [](void* owner) -> void* { return &alternative_in<Alternative>(variant_of(owner)); });
}
template <class Owner, std::size_t N, std::size_t M>
consteval auto joined(const KeysOf<Owner, N>& first, const KeysOf<Owner, M>& second) {
  KeysOf<Owner, N + M> made{};
  for (std::size_t i = 0; i < N + M; ++i) {
    made.rows[i] = i < N ? first.rows[i] : second.rows[i - N];
  }
  return made;
}
template <class Owner, std::size_t N>
consteval KeyTableOf<Owner> table_of(std::string_view meaning, const KeysOf<Owner, N>& keys,
                                     std::string_view noun = "") {
  KeyTableOf<Owner> table{};
  table.noun = noun;
  table.meaning = meaning;
  table.keys = keys.rows;
  return table;
}
template <class Owner, std::size_t N>
consteval KeyTableOf<Owner> decided_by(KeyTableOf<Owner> table,
                                       const std::array<std::string_view, N>& keys) {
  table.deciding = keys;
  return table;
}
template <class Owner, std::size_t N>
consteval KeyTableOf<Owner> with_removed_keys(KeyTableOf<Owner> table,
                                              const std::array<RemovedKey, N>& keys) {
  table.removed = keys;
  return table;
}
template <class Owner>
consteval KeyTableOf<Owner> not_empty(KeyTableOf<Owner> table) {
  table.may_be_empty = false;
  return table;
}

}  // namespace asperity
