// A picture as numbers, and as an 8-bit PNG.

#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace asperity {

/// Brightness, row by row, the top row first. Black is 0 and white is 1; a picture half way through
/// a calculation may leave that range. `values` holds rows · columns numbers.
struct GreyImage {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<float> values{};
};

/// Red, green and blue of a picture, in this order; equal in size.
using ColorPlanes = std::array<GreyImage, 3>;

/// The bytes of an 8-bit grey PNG: 0 becomes black, 1 white, what lies outside is clipped.
///
/// Errors: std::invalid_argument for a picture without pixels, or whose count does not fit.
std::vector<std::byte> encode_png(const GreyImage& image);
/// The bytes of an 8-bit colour PNG. Errors: as above, and for planes of different sizes.
std::vector<std::byte> encode_color_png(const ColorPlanes& planes);

}  // namespace asperity
