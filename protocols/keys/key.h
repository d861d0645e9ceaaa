// Declares a key of a protocol and the table of an object's keys: everything that is known about a key, declared once.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "protocols/keys/shape.h"

namespace asperity {

/// A key of an object. Rows are written with `member_key`, `inner_key` and `entry_key` (keys_of.h), which derive `store`
/// and `standard` from the member that receives the value.
struct ProtocolKey {
  std::string_view name{};
  std::string_view label{};    ///< of its field in a form
  std::string_view meaning{};  ///< see `meaning_of`
  ValueShape shape{};
  bool is_required = false;
  std::string_view needs{};  ///< another key of the object without which this one is not permitted
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

/// The shape that applies to a value: of several forms that of its type; of a value that can be bound that of the
/// binding, an object, or that of the value. Null if the value has none of their types.
const ValueShape* shape_of(const ValueShape& shape, const nlohmann::json& value);

/// The keys of an object, in the order in which files and forms have them.
///
/// Every object also permits comments: "$comment" and keys that begin with "x-".
struct KeyTable {
  std::string_view meaning{};  ///< of the object; ends with a full stop
  std::span<const ProtocolKey> keys{};
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
