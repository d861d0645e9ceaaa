// Writes the rows of a table with the members that receive the values: reading and defaults follow from a row.

#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/keys/key.h"

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
inline void store_value(const TextShape&, const nlohmann::json& value, std::string& member) {
  member = value.get<std::string>();
}
template <class Owner>
void store_value(const ObjectShape& shape, const nlohmann::json& value, Owner& member) {
  read_keys(*shape.table, value, static_cast<void*>(&member));
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
nlohmann::json standard_value(const NumberShape&, const Number& member) {
  return member;
}
inline nlohmann::json standard_value(const TruthShape&, const bool& member) { return member; }
template <WordMember Value>
nlohmann::json standard_value(const WordShape& shape, const Value& member) {
  for (const KeyWord& word : shape.words) {
    if (word.value == static_cast<int>(member)) return word.name;
  }
  return nullptr;
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

/// A row of the table of an Owner.
template <class Owner>
struct KeyOf : ProtocolKey {};

template <class Member>
struct MemberOf;
template <class OwnerOfMember, class ValueOfMember>
struct MemberOf<ValueOfMember OwnerOfMember::*> {
  using Owner = OwnerOfMember;
};

/// A key whose value is stored in `owner.*member`.
template <auto member, class ShapeOfValue>
consteval auto member_key(std::string_view name, std::string_view label, std::string_view meaning,
                          const ShapeOfValue& shape) {
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
/// A key with the words of the type of its member. `words` is a constant with static storage.
template <auto member, class Value, std::size_t N>
consteval auto member_key(std::string_view name, std::string_view label, std::string_view meaning,
                          const WordsOf<Value, N>& words) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<Member, Value> || std::is_same_v<Member, std::optional<Value>>);
  return member_key<member>(name, label, meaning, WordShape{words.words});
}
/// A key with an object that is stored in `owner.*member`.
template <auto member, class Inner>
consteval auto member_key(std::string_view name, std::string_view label,
                          const KeyTableOf<Inner>& table) {
  using Owner = typename MemberOf<decltype(member)>::Owner;
  using Member = std::remove_cvref_t<decltype(std::declval<Owner>().*member)>;
  static_assert(std::is_same_v<Member, Inner> || std::is_same_v<Member, std::optional<Inner>>);
  return member_key<member>(name, label, table.meaning, ObjectShape{&table});
}
/// A key with an object whose keys are stored in the owner of the key itself.
template <class Owner>
consteval KeyOf<Owner> inner_key(std::string_view name, std::string_view label,
                                 const KeyTableOf<Owner>& table) {
  KeyOf<Owner> row{};
  row.name = name;
  row.label = label;
  row.meaning = table.meaning;
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
template <class Owner, std::size_t N>
consteval KeyTableOf<Owner> table_of(std::string_view meaning, const KeysOf<Owner, N>& keys) {
  KeyTableOf<Owner> table{};
  table.meaning = meaning;
  table.keys = keys.rows;
  return table;
}

}  // namespace asperity
