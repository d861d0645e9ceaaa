// Declares the protocols and the schema that are built into the program.

#pragma once

#include <span>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace asperity {

/// A file NAME.LANGUAGE.json of protocols/library/ (translation.h).
struct LibraryTranslation {
  std::string_view language{};
  std::string_view text{};
};

/// A file NAME.json of protocols/library/, in English.
struct LibraryProtocol {
  std::string_view name{};  ///< without folder and extension, e.g. "chapter_selection"
  std::string_view text{};  ///< the JSON, byte for byte
  std::span<const LibraryTranslation> translations{};
};

/// All library protocols by name.
std::span<const LibraryProtocol> library_protocols() noexcept;

/// The schema of protocols (JSON Schema, draft-07), for editors and validators: that of the tables of keys
/// (protocols/keys/tables.h).
const nlohmann::json& protocol_schema();

}  // namespace asperity
