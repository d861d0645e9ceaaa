// Declares JSON text with the positions of its keys and values.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "protocols/file/diagnostic.h"

namespace asperity {

/// The bytes of a value in the text: from `value` to before `end`. `key` is the first one of its key, or of the value
/// itself if it has none.
struct JsonPlace {
  std::size_t key = 0;
  std::size_t value = 0;
  std::size_t end = 0;
};

/// Stores a parsed file with the position of every key and value.
///
/// The accepted text is stricter than JSON, which bounds all subsequent recursion and search: UTF-8 without byte order
/// mark, at most 4 MiB, 64 levels, 4096 elements per array or keys per object, 8192 bytes per string and 256 per key. A
/// key may occur only once in an object. The character U+0000 is not permitted: texts and keys become cells of tables and
/// labels of values, where it ends a text in some programs.
class JsonDocument final {
 public:
  /// Errors: ProtocolError with the one syntax error, or with all duplicate keys and all texts and keys with U+0000. If
  /// `problems_of_texts` is given, these are stored in it instead, and the last value of each key is used.
  JsonDocument(std::string_view text, std::string file,
               std::vector<Diagnostic>* problems_of_texts = nullptr);

  const nlohmann::json& root() const noexcept { return root_; }
  /// The characters that were parsed; the caller keeps them.
  std::string_view text() const noexcept { return text_; }
  /// A copy with another tree. Values that occur in both trees have their positions in the text.
  JsonDocument with_root(nlohmann::json root) const;
  /// A diagnostic at a value, or at its nearest existing ancestor.
  Diagnostic at(const std::string& pointer, Phrase message) const;
  /// Windows could not translate it.
  Diagnostic at(const std::string& pointer, const std::string& message) const = delete;
  /// The place of the value in the text; nullopt if it does not exist.
  std::optional<JsonPlace> place_of(const std::string& pointer) const;
  /// A diagnostic at the last key of the pointer.
  Diagnostic at_key(const std::string& pointer, Phrase message) const;
  Diagnostic at_key(const std::string& pointer, const std::string& message) const = delete;

 private:
  class Handler;
  Diagnostic diagnostic(std::size_t offset, const std::string& pointer, Phrase message) const;

  std::string_view text_{};
  std::string file_{};
  nlohmann::json root_{};
  std::map<std::string, JsonPlace, std::less<>> places_{};
};

}  // namespace asperity
