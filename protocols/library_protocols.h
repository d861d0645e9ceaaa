// The protocols and the schema that come with the program, built into it.

#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// A file of protocols/library/.
struct LibraryProtocol {
  std::string_view name{};  ///< without folder and ending, e.g. "chapter_selection"
  std::string_view text{};  ///< the JSON, byte for byte
};

/// Every library protocol, by name.
std::span<const LibraryProtocol> library_protocols() noexcept;

/// protocols/schema/protocol-1.schema.json (JSON Schema, draft-07), for the reader and for editors.
std::string_view protocol_schema() noexcept;

}  // namespace asperity
