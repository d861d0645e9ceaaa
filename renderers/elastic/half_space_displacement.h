// Declares the displacement of an elastic half-space under the pressures in a window of cells.

#pragma once

#include <array>
#include <cstddef>

#include "renderers/elastic/cell_field.h"

namespace asperity {

/// Computes u = K·s in a window, with K the displacement of one cell under a uniform load in another (love_kernel.h).
///
/// Units: s = p·c/E* [m], with p the pressure, c the side of a cell and E* the reduced modulus E/(1 − ν²); u [m]. K has no unit
/// and depends on neither. The force of a cell is p·c² = E*·c·s.
///
/// Method: the convolution is a product of Fourier transforms over a window of twice the width, filled with zeros, so that no
/// periodic image contributes [Stanley 1997]: exact up to rounding. K is symmetric in both axes, so that its transform
/// is real. Two columns share a complex transform; half of the spectrum is computed.
///
/// Real-time: `of` does not allocate, lock or throw, and takes the same time for every input. Threads: one at a time per
/// object.
class HalfSpaceDisplacement final {
 public:
  HalfSpaceDisplacement();

  void of(const CellField& load_m, CellField& displacement_m) noexcept;

 private:
  static constexpr std::size_t kPadded = 2 * kCellsAcross;
  static constexpr std::size_t kLines =
      kCellsAcross + 2;  ///< non-negative frequencies, to an even number
  static constexpr std::size_t kPairs = kCellsAcross / 2;  ///< complex columns
  using Lines = std::array<double, kPadded * kLines>;      ///< [x or its frequency][frequency of y]

  struct Complex {
    Lines re{};
    Lines im{};
  };

  void transform(std::size_t batch, double*& re, double*& im, double*& other_re,
                 double*& other_im) const noexcept;
  void unpack_columns(const double* re, const double* im, double* lines_re,
                      double* lines_im) const noexcept;
  void pack_columns(const double* lines_re, const double* lines_im, double* re,
                    double* im) const noexcept;

  std::array<double, kPadded> cosine_{};
  std::array<double, kPadded> sine_{};
  Lines spectrum_{};
  Complex one_{};
  Complex two_{};
};

}  // namespace asperity
