// Declares linear filters on pictures of complex numbers by Fourier transform, with reflected borders.

#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <vector>

namespace asperity {

/// How a picture continues beyond its border: with its mirror image, or with the negative of it.
enum class Reflection { even, odd };

/// The continuation of a real picture beyond the left and right borders, and beyond the top and bottom ones.
struct Continuation {
  Reflection across = Reflection::even;
  Reflection down = Reflection::even;
};

/// Two real pictures of the same size as one picture of complex numbers, row by row, the top row first.
struct ComplexPicture {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::complex<float>> values{};
};

/// H(ν_x, ν_y), with ν_x to the right and ν_y upwards, in cycles per pixel, from −½ to ½.
using TransferFunction = std::function<std::complex<double>(double nu_x, double nu_y)>;

/// ℱ⁻¹[H ℱ u] of the picture u, which is continued by reflection at lines half a pixel outside its border: the real parts
/// as `real` states, the imaginary parts as `imaginary` states.
///
/// A derivative along x of a picture that is continued evenly is continued oddly across and evenly down, so that the
/// integration of slopes has no step at the border. The continued picture has twice the size of the picture, enlarged to
/// a size that transforms quickly.
///
/// Memory: about 50 bytes per pixel. Errors: std::invalid_argument for a number of values that does not match the size.
ComplexPicture reflected_filter(const ComplexPicture& picture, const Continuation& real,
                                const Continuation& imaginary, const TransferFunction& transfer);

}  // namespace asperity
