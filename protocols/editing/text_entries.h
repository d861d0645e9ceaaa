// Declares the entries of a container in the order and with the places that they have in the text.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/file/json_document.h"

namespace asperity {

/// A member of an object, or an entry of an array.
struct TextEntry {
  std::string key{};  ///< empty in an array
  JsonPlace place{};  ///< of an entry of an array, `key` is `value`
};

/// An object or an array, as it is written.
///
/// Together with the characters between them, the entries are the complete text of the container: a bracket, then
/// white space, entries, commas, and the other bracket.
class TextContainer final {
 public:
  /// Errors: ProtocolError if there is no container at `pointer`.
  TextContainer(const JsonDocument& document, std::string pointer);

  const std::string& pointer() const noexcept { return pointer_; }
  const std::vector<TextEntry>& entries() const noexcept { return entries_; }
  bool is_object() const noexcept { return is_object_; }
  bool has(std::string_view key) const noexcept;
  /// The index of the member with this key; the number of entries if there is none.
  std::size_t index_of(std::string_view key) const noexcept;
  /// The key with its quotation marks, the colon and the white space around it: what stands before the value.
  std::string_view text_before_value(std::size_t index) const;
  /// The characters of the entry.
  std::string_view text_of(std::size_t index) const;
  /// The first byte after the opening bracket.
  std::size_t begin() const noexcept { return begin_; }
  /// The white space before an entry: after the comma before it or after the bracket. Of the index after the last
  /// entry, the white space before the closing bracket.
  std::string_view space_before(std::size_t index) const;

 private:
  std::string_view text_{};
  std::string pointer_{};
  std::vector<TextEntry> entries_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  bool is_object_ = false;
};

/// The container with the entry at `pointer`, and the index of the entry in it.
struct EntryOfContainer {
  TextContainer container;
  std::size_t index = 0;
};
/// Errors: ProtocolError if there is no such value, or if it is the complete document, which has no container.
EntryOfContainer entry_at(const JsonDocument& document, const std::string& pointer);

/// Throws ProtocolError with the place of the value, or of its nearest ancestor.
[[noreturn]] void refuse(const JsonDocument& document, const std::string& pointer, Phrase message);

/// The value at `pointer`. Errors: ProtocolError at its nearest ancestor if there is none.
const nlohmann::json& value_at(const JsonDocument& document, const std::string& pointer);

}  // namespace asperity
