// Decodes a JPEG with its own library, which OpenCV lets complain on the terminal and guess.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace asperity {

/// Writes the luminance of a grey or colour JPEG to `pixels`, row by row; they are as many as its
/// header says. False where the library had anything to complain about, in its words.
bool decode_jpeg_luminance(std::span<const std::byte> bytes, std::span<std::uint8_t> pixels,
                           std::size_t columns, std::string& complaint);

}  // namespace asperity
