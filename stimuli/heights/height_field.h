// Declares the height field, the fine relief of a surface as heights above a plane.

#pragma once

#include <cstddef>
#include <vector>

#include "stimuli/properties/surface_patch.h"

namespace asperity {

/// The height and its gradient at one point.
struct HeightSample {
  double height_m = 0.0;
  double slope_x = 0.0;  ///< ∂h/∂x, dimensionless
  double slope_y = 0.0;  ///< ∂h/∂y, dimensionless
};

/// Stores heights on a square grid and interpolates them by bicubic convolution.
///
/// The interpolant h(x, y) = Σ h_ij w((x − x_j)/p) w((y − y_i)/p), with pitch p and Keys' kernel (a = −½) as w, passes
/// through every sample, has a continuous gradient everywhere (C1), and reproduces a plane exactly except in the
/// outermost cells, where the samples beyond the grid do not lie on the plane. `sample` returns the exact gradient of
/// this interpolant.
///
/// Frame and units: metres. The origin is the centre of the field; column j lies at x = (j − (columns − 1)/2)·p and row
/// i at y = ((rows − 1)/2 − i)·p, so that the first row is the top of the picture and y points upwards in it.
///
/// Outside the samples the interpolant uses continued samples: `Tiling::bounded` repeats the outermost row and column,
/// `Tiling::repeat` has the period columns·p by rows·p, and `Tiling::mirror` reflects at the lines half a pitch outside
/// the outermost samples, with twice that period. All three are C1 everywhere; whether `repeat` has a visible seam
/// depends on the samples.
///
/// Errors: the constructor throws std::invalid_argument, naming the field, for a pitch that is not positive, fewer than
/// 2 × 2 samples, a number of heights that does not match the grid, or a height that is not finite.
///
/// Real-time: `sample` does not allocate, lock or throw; it accepts all finite positions.
///
/// [Keys 1981] Keys: Cubic convolution interpolation for digital image processing.
class HeightField final {
 public:
  struct Grid {
    std::size_t rows = 0;
    std::size_t columns = 0;
    double pitch_m = 0.0;
  };

  /// `heights_m` is stored row by row, the top row first.
  HeightField(const Grid& grid, std::vector<float> heights_m);

  const Grid& grid() const noexcept { return grid_; }
  const std::vector<float>& heights_m() const noexcept { return heights_m_; }
  double width_m() const noexcept { return static_cast<double>(grid_.columns) * grid_.pitch_m; }
  double length_m() const noexcept { return static_cast<double>(grid_.rows) * grid_.pitch_m; }
  double minimum_m() const noexcept { return minimum_m_; }
  double maximum_m() const noexcept { return maximum_m_; }
  double mean_m() const noexcept { return mean_m_; }
  /// Root mean square about the mean (Sq of ISO 25178).
  double rms_m() const noexcept { return rms_m_; }

  HeightSample sample(double x_m, double y_m, Tiling tiling) const noexcept;

 private:
  Grid grid_{};
  std::vector<float> heights_m_{};
  double minimum_m_ = 0.0;
  double maximum_m_ = 0.0;
  double mean_m_ = 0.0;
  double rms_m_ = 0.0;
};

}  // namespace asperity
