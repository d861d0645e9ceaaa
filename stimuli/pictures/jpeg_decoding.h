// Decodes a JPEG with its own library, which OpenCV lets complain on the terminal and guess.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace asperity {

/// What is decoded of each pixel: one number, or red, green and blue, in this order.
enum class JpegPixels { luminance, colour };

/// Writes a grey or colour JPEG to `pixels`, row by row; there are as many pixels as its header
/// states. False where the library had anything to complain about, in its words.
bool decode_jpeg(std::span<const std::byte> bytes, JpegPixels wanted,
                 std::span<std::uint8_t> pixels, std::size_t columns, std::string& complaint);

}  // namespace asperity
