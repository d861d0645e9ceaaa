// Declares pictures as arrays of brightness and their encoding as 8-bit PNG.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace asperity {

/// Stores brightness row by row, the top row first. Black is 0 and white is 1; intermediate results may be outside this
/// range. `values` contains rows · columns numbers.
struct GreyImage {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<float> values{};
};

/// The red, green and blue planes of a picture, in this order; equal in size.
using ColorPlanes = std::array<GreyImage, 3>;

/// Encodes an 8-bit greyscale PNG: 0 is black, 1 is white, values outside are clipped.
///
/// Errors: std::invalid_argument for a picture without pixels, or with a number of values that does not match its size.
std::vector<std::byte> encode_png(const GreyImage& image);
/// Encodes an 8-bit colour PNG. Errors: those of `encode_png`, and for planes of different sizes.
std::vector<std::byte> encode_color_png(const ColorPlanes& planes);

}  // namespace asperity
