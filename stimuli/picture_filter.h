// Radial filters on pictures through the Fourier transform, with reflected borders.

#pragma once

#include <opencv2/core.hpp>

namespace asperity {

/// A filter H(ν) = a + b·exp(−ν²/(2 ν₀²)), with ν and ν₀ in cycles per pixel.
struct RadialFilter {
  double constant = 0.0;           ///< a
  double gaussian = 1.0;           ///< b
  double cutoff_wavelength = 1.0;  ///< 1/ν₀, in pixels
};

/// `picture` (float, one channel) filtered, continued by reflection as texture_from_photograph.h
/// says.
cv::Mat filtered(const cv::Mat& picture, const RadialFilter& filter);

}  // namespace asperity
