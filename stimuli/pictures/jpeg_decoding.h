// Declares a JPEG decoder that uses libjpeg directly, because OpenCV lets libjpeg print to the terminal and guess
// damaged data.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace asperity {

/// The decoded channels of a pixel: one number, or red, green and blue, in this order.
enum class JpegPixels { luminance, colour };

/// Decodes a grey or colour JPEG to `pixels`, row by row; their number must be that of the header. False if libjpeg
/// reported a problem; `complaint` then contains its message.
bool decode_jpeg(std::span<const std::byte> bytes, JpegPixels wanted,
                 std::span<std::uint8_t> pixels, std::size_t columns, std::string& complaint);

}  // namespace asperity
