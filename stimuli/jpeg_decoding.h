// Decodes a JPEG with its own library, which OpenCV lets complain on the terminal and guess.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Luminance of a grey or colour JPEG, row by row, or nothing where the library had anything to
/// complain about; then `complaint` holds its words. `pixels` is sized by the caller to rows ·
/// columns.
bool decode_jpeg_luminance(std::span<const std::byte> bytes, std::span<std::uint8_t> pixels,
                           std::size_t columns, std::string& complaint);

}  // namespace asperity
