// Declares a key of a protocol and the table of an object's keys: everything that is known about a key, declared once.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "protocols/shapes/shape.h"

namespace asperity {

/// What has to hold where a key is stated: another key has one of several values.
struct KeyCondition {
  enum class Of {
    object,  ///< the object that has the key
    around,  ///< the nearest object around that one that has the other key
    /// The kind of experiment of the block, or any kind of the protocol. It holds for an additional question, which no kind
    /// owns. The default of the key is permitted with every kind: it is equivalent to the absence of the key.
    kind,
  };
  static constexpr std::size_t kMostValues = 6;

  std::string_view key{};  ///< empty: no condition
  Of of = Of::object;
  /// Words, and `kAbsent` where the other key may be absent. None: the other key is present.
  std::array<std::string_view, kMostValues> listed{};
  std::size_t count = 0;
  /// The problem where the condition does not hold; empty: the sentence that follows from the condition.
  std::string_view problem{};

  constexpr KeyCondition() = default;
  constexpr KeyCondition(std::string_view other,
                         std::initializer_list<std::string_view> values = {}, Of where = Of::object)
      : key(other), of(where), count(values.size()) {
    std::copy(values.begin(), values.end(), listed.begin());
  }
  constexpr std::span<const std::string_view> values() const { return {listed.data(), count}; }
};
/// The value of a key that is not stated.
inline constexpr std::string_view kAbsent{};

/// The other key is present, or absent, or has one of the values.
constexpr KeyCondition with(std::string_view key) { return {key}; }
constexpr KeyCondition without(std::string_view key) { return {key, {kAbsent}}; }
constexpr KeyCondition where(std::string_view key, std::initializer_list<std::string_view> values) {
  return {key, values};
}
/// The same of the nearest object around that has the other key.
constexpr KeyCondition where_around(std::string_view key,
                                    std::initializer_list<std::string_view> values) {
  return {key, values, KeyCondition::Of::around};
}
/// The kinds of experiment that own a key.
constexpr KeyCondition of_kinds(std::initializer_list<std::string_view> kinds) {
  return {"kind", kinds, KeyCondition::Of::kind};
}
/// The condition with a problem of its own, which states a reason or another remedy.
constexpr KeyCondition reported_as(std::string_view problem, KeyCondition condition) {
  condition.problem = problem;
  return condition;
}

/// Whether a condition on the object itself holds; true for others.
bool holds_in(const KeyCondition& condition, const nlohmann::json& object);

/// A key of an object. Rows are written with `member_key`, `inner_key` and `entry_key` (keys_of.h), which derive `store`
/// and `standard` from the member that receives the value.
struct ProtocolKey {
  std::string_view name{};
  std::string_view label{};    ///< of its field in a form
  std::string_view meaning{};  ///< see `meaning_of`
  ValueShape shape{};
  bool lists_words = false;  ///< the meanings of its words belong to its meaning
  bool is_required = false;
  /// When the key applies: if all of them hold. It is not permitted elsewhere, and forms do not offer it there.
  std::array<KeyCondition, 3> conditions{};
  /// The default that is computed from something else, in words: "95 % of `device.rate_Hz`". Empty: the default is that
  /// of the member, if there is one.
  std::string_view computed_default{};

  /// The part of the owner that receives the value, such as an alternative of a variant; null: the owner itself.
  void* (*part)(void* owner) = nullptr;
  /// Stores a value of this shape in the owner, of the type that the table describes.
  void (*store)(const ProtocolKey& key, const nlohmann::json& value, void* owner) = nullptr;
  /// The value of a new owner, as a file writes it; null for a member whose absence means something else.
  nlohmann::json (*standard)(const ProtocolKey& key) = nullptr;
};

/// The value that an absent key stands for; null if the key is required, or if its default is computed or there is none.
nlohmann::json default_of(const ProtocolKey& key);

/// The meaning of a value for schema, page, help and errors: `own`, or if it is empty that of the table of an object. It
/// ends with a full stop.
std::string_view meaning_of(const ValueShape& shape, std::string_view own);
std::string_view meaning_of(const ProtocolKey& key);
/// The meaning, and where it belongs to it that of every word: "The kind. rating: …; matching: …."
std::string full_meaning_of(const ProtocolKey& key);

/// The shape that applies to a value: of several forms that of its type; of a value that can be bound that of the
/// binding, an object, or that of the value. Null if the value has none of their types.
const ValueShape* shape_of(const ValueShape& shape, const nlohmann::json& value);

/// A key that a table had in an earlier version.
struct RemovedKey {
  std::string_view name{};
  std::string_view problem{};  ///< what to write instead
};

/// The keys of an object, in the order in which files and forms have them.
///
/// Every object also permits comments: "$comment" and keys that begin with "x-".
struct KeyTable {
  std::string_view meaning{};  ///< of the object; ends with a full stop
  std::span<const ProtocolKey> keys{};
  std::span<const RemovedKey> removed{};
  /// Keys of which an object has exactly one, such as the kinds of a step of the flow; empty: no such choice.
  std::span<const std::string_view> deciding{};
  bool is_open = false;      ///< other keys are permitted and not interpreted
  bool may_be_empty = true;  ///< otherwise an object has at least one key
  std::string_view noun{};   ///< of the object, for the page; empty: "object"

  /// The key with this name; null if there is none.
  const ProtocolKey* find(std::string_view name) const;
};

/// The shape of the value at a JSON pointer in `root`, an object of the table, or of a value that can be inserted there.
/// nullopt where the table states no shape: for comments, unknown keys, what they contain, and other types than the
/// permitted ones. Errors: nlohmann::json::out_of_range if the container of the value does not exist.
std::optional<ValueShape> shape_at(const KeyTable& table, const nlohmann::json& root,
                                   const std::string& pointer);

/// Stores the value of every key in its member; members without a key keep their value. `valid` is the part of an object
/// that has the form of the table.
void read_keys(const KeyTable& table, const nlohmann::json& valid, void* owner);

/// A table whose keys are stored in an Owner.
template <class Owner>
struct KeyTableOf : KeyTable {};

/// Whether a value is of a type that the schema names: "integer", "string".
bool is_of_type(const nlohmann::json& value, const std::string& type);

/// Whether a key is a comment of the author.
constexpr bool is_comment(std::string_view name) {
  return name.starts_with("x-") || name == "$comment";
}

}  // namespace asperity
