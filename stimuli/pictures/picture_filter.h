// Radial filters on pictures through the Fourier transform, with reflected borders.

#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// A filter H(ν) = a + b·exp(−ν²/(2 ν₀²)), with ν and ν₀ in cycles per pixel.
struct RadialFilter {
  double constant = 0.0;  ///< a
  double gaussian = 1.0;  ///< b
};

/// The spectrum of a picture, continued by reflection as texture_from_photograph.h says, to be
/// filtered once or many times with the same ν₀.
///
/// The numbers are those of cv::dft over the continued picture, bit for bit, whatever the number of
/// threads: rows and columns are transformed one by one either way. Rows that a reflection repeats
/// are transformed once, and rows that are cut off again not at all.
class PictureSpectrum final {
 public:
  /// `cutoff_wavelength`: 1/ν₀, in pixels. `threads`: that work at once, 1 or more.
  PictureSpectrum(const GreyImage& picture, double cutoff_wavelength, int threads);

  double cutoff_wavelength() const noexcept { return cutoff_wavelength_; }
  /// The picture through the filter.
  GreyImage filtered(const RadialFilter& filter) const;

 private:
  /// A side of the continued picture: so much before the picture, and in all.
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
  /// For each horizontal frequency 0, 1 … size/2 its column as complex numbers, one after another.
  std::unique_ptr<float[]> columns_{};
};

}  // namespace asperity
