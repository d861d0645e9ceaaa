// Declares the file format of a height field: a 16-bit greyscale PNG and its JSON sidecar.

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

/// The origin of a height field; stored with it, so that it can be reproduced.
struct HeightFieldProvenance {
  std::string kind{};  ///< "photograph", or the kind of a synthetic surface
  ParameterValues parameters{};
  std::optional<std::uint64_t> seed{};  ///< of a synthetic surface
  std::string source_name{};            ///< the photograph's file name; otherwise empty
  std::string source_sha256{};          ///< of that file
  std::string program_version{};
};

/// A height field that was read from its files, and the contents of its sidecar.
struct StoredHeightField {
  HeightField field;
  HeightFieldProvenance provenance{};
  std::string sha256{};  ///< the expected digest of the PNG; the caller compares it
};

/// Encodes the heights as a 16-bit greyscale PNG: level = 65535 (h − h_min)/(h_max − h_min), rounded. In a field of constant
/// height all levels are 0.
std::vector<std::byte> encode_height_field_png(const HeightField& field);

/// The text of the sidecar (docs/formats/height_field.md). `png_sha256` is the digest of the PNG's bytes, in
/// hexadecimal.
std::string encode_height_field_sidecar(const HeightField& field,
                                        const HeightFieldProvenance& provenance,
                                        std::string_view png_sha256);

/// Decodes a height field from its two files. Heights are accurate to half a level, (h_max − h_min)/131070; the
/// smallest and the largest are exact.
///
/// Errors: std::invalid_argument with a sentence that begins with `name` (the PNG's; the sidecar's name is `name` with
/// ".json" appended): invalid JSON, a missing field or one with an impossible value, an unknown format or version, a
/// picture that is not 16-bit greyscale.
StoredHeightField decode_height_field(std::span<const std::byte> png, std::string_view sidecar,
                                      const std::string& name);

}  // namespace asperity
