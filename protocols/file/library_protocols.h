// Declares the protocols and the schema that are built into the program.

#pragma once

#include <span>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace asperity {

/// A file of protocols/library/: NAME.json in English, NAME.de.json in German. Both have the same name and give the
/// same plans; only texts differ.
struct LibraryProtocol {
  std::string_view name{};  ///< without folder and extension, e.g. "chapter_selection"
  std::string_view text{};  ///< the JSON, byte for byte
};

/// All library protocols by name, in English ("en") or German ("de"); empty for another language.
std::span<const LibraryProtocol> library_protocols(std::string_view language = "en") noexcept;

/// The schema of protocols (JSON Schema, draft-07), for the reader and for editors: that of the tables of keys
/// (protocols/keys/tables.h).
const nlohmann::json& protocol_schema();

}  // namespace asperity
