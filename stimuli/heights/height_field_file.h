// A height field as two files: a 16-bit grey PNG and a JSON sidecar beside it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/heights/height_field.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// How a height field came about; stored with it, so that it can be made again.
struct HeightFieldProvenance {
  std::string kind{};  ///< "photograph", or the kind of a synthetic surface
  ParameterValues parameters{};
  std::optional<std::uint64_t> seed{};  ///< of a synthetic surface
  std::string source_name{};            ///< the photograph's file name; empty where there is none
  std::string source_sha256{};          ///< of that file
  std::string program_version{};
};

/// A height field read back, and what its sidecar says of it.
struct StoredHeightField {
  HeightField field;
  HeightFieldProvenance provenance{};
  std::string sha256{};  ///< what the PNG's digest ought to be; comparing is the caller's
};

/// The bytes of a 16-bit grey PNG: level = 65535 (h − h_min)/(h_max − h_min), rounded. A field of
/// one height is all 0.
std::vector<std::byte> encode_height_field_png(const HeightField& field);

/// The text of the sidecar (docs/formats/height_field.md). `png_sha256` is that of the PNG's bytes,
/// in hexadecimal.
std::string encode_height_field_sidecar(const HeightField& field,
                                        const HeightFieldProvenance& provenance,
                                        std::string_view png_sha256);

/// What the two say. Heights come back within half a level, (h_max − h_min)/131070, and the
/// smallest and largest exactly.
///
/// Errors: std::invalid_argument, a sentence that begins with `name` (the PNG's; the sidecar is
/// called by it with ".json" at its end): not JSON, a field that is missing or cannot be, a format
/// or version that is not known, a picture that is not 16-bit grey.
StoredHeightField decode_height_field(std::span<const std::byte> png, std::string_view sidecar,
                                      const std::string& name);

}  // namespace asperity
