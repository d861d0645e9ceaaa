// JSON text that remembers where everything stood.

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

/// A parsed file with the place of every key and value.
///
/// Stricter than JSON, so that nothing that follows can be made to recurse or search without end:
/// UTF-8 without byte order mark, at most 4 MiB, 64 levels, 4096 elements per array or keys per
/// object, 8192 bytes per string and 256 per key. A key may stand once in an object.
class JsonDocument final {
 public:
  /// Errors: ProtocolError with the one error of syntax, or every duplicate key; the latter go to `duplicates` where it
  /// is given, and of each key the last value counts.
  JsonDocument(std::string_view text, std::string file,
               std::vector<Diagnostic>* duplicates = nullptr);

  const nlohmann::json& root() const noexcept { return root_; }
  /// Another tree in place of this one. What stands in both has the place that it has in the text.
  JsonDocument with_root(nlohmann::json root) const;
  /// A diagnostic at a value, or at the nearest value above it that exists.
  Diagnostic at(const std::string& pointer, std::string message) const;
  /// Where the value begins in the text; nothing where there is none.
  std::optional<std::size_t> place_of(const std::string& pointer) const;
  /// A diagnostic at the key that the pointer ends in.
  Diagnostic at_key(const std::string& pointer, std::string message) const;

 private:
  struct Place {
    std::size_t key = 0;
    std::size_t value = 0;
  };
  class Handler;
  Diagnostic diagnostic(std::size_t offset, const std::string& pointer, std::string message) const;

  std::string_view text_{};
  std::string file_{};
  nlohmann::json root_{};
  std::map<std::string, Place, std::less<>> places_{};
};

}  // namespace asperity
