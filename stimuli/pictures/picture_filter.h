// Declares radial filters on pictures by Fourier transform, with reflected borders.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// A filter H(ν) = (a + b·exp(−ν²/(2 ν₀²)))·max(1, ν/ν₀)⁻ᵖ, with ν and ν₀ in cycles per pixel.
struct RadialFilter {
  double constant = 0.0;  ///< a
  double gaussian = 1.0;  ///< b
  double tilt = 0.0;      ///< p
};

/// Stores the spectrum of a picture, continued by reflection as texture_from_photograph.h describes, for one or several
/// filters with the same ν₀.
///
/// The result equals that of cv::dft over the continued picture, bit for bit, for any number of threads: rows and
/// columns are transformed one by one in both cases. Rows that the reflection repeats are transformed once, and rows
/// that are cropped again are not transformed.
class PictureSpectrum final {
 public:
  /// `cutoff_wavelength`: 1/ν₀, in pixels. `threads`: the number of threads, 1 or more.
  PictureSpectrum(const GreyImage& picture, double cutoff_wavelength, int threads);

  double cutoff_wavelength() const noexcept { return cutoff_wavelength_; }
  /// Applies the filter to the picture.
  GreyImage filtered(const RadialFilter& filter) const;

 private:
  /// One dimension of the continued picture: the size of the picture, the margin before it, and the total.
  struct Side {
    std::size_t picture = 0;
    std::size_t before = 0;
    std::size_t size = 0;
  };
  static Side continued(std::size_t picture, double cutoff_wavelength);
  static std::vector<std::size_t> reflected_places(const Side& side);
  void transform_rows(const GreyImage& picture);
  void transform_columns();

  double cutoff_wavelength_ = 0.0;
  int threads_ = 1;
  Side down_{};
  Side across_{};
  /// The column of each horizontal frequency 0, 1 … size/2 as complex numbers, consecutively.
  std::unique_ptr<float[]> columns_{};
};

}  // namespace asperity
