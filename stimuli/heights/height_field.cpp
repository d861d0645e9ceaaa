// Implements bicubic convolution on a bounded, repeated or mirrored grid.

#include "stimuli/heights/height_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

/// The values of Keys' kernel (a = −½) and of its derivative at the four nodes around a point; t in [0, 1] is the
/// point's distance from the second node, in samples.
struct Weights {
  std::array<double, 4> value{};
  std::array<double, 4> slope{};
};

Weights keys_weights(double t) noexcept {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return {{0.5 * (-t3 + 2.0 * t2 - t), 0.5 * (3.0 * t3 - 5.0 * t2 + 2.0),
           0.5 * (-3.0 * t3 + 4.0 * t2 + t), 0.5 * (t3 - t2)},
          {0.5 * (-3.0 * t2 + 4.0 * t - 1.0), 0.5 * (9.0 * t2 - 10.0 * t),
           0.5 * (-9.0 * t2 + 8.0 * t + 1.0), 0.5 * (3.0 * t2 - 2.0 * t)}};
}

/// The indices of the four samples around a coordinate, and its distance from the second, in samples.
struct Neighbours {
  std::array<std::size_t, 4> index{};
  double t = 0.0;
};

/// `u` modulo `period`, in [0, period); 0 if `u` is too large for a meaningful remainder.
double wrapped(double u, double period) noexcept {
  const double rest = u - period * std::floor(u / period);
  return rest >= 0.0 && rest < period ? rest : 0.0;
}

Neighbours neighbours(double u, std::size_t count, Tiling tiling) noexcept {
  const auto n = static_cast<std::ptrdiff_t>(count);
  const auto samples = static_cast<double>(count);
  switch (tiling) {
    case Tiling::bounded:
      // Two samples outside, all four neighbours are the edge sample and the value is constant.
      u = std::clamp(u, -2.0, samples + 1.0);
      break;
    case Tiling::repeat:
      u = wrapped(u, samples);
      break;
    case Tiling::mirror:
      u = wrapped(u, 2.0 * samples);
      break;
  }
  const double floor_u = std::floor(u);
  const auto first = static_cast<std::ptrdiff_t>(floor_u) - 1;
  Neighbours result{.index = {}, .t = u - floor_u};
  for (std::ptrdiff_t k = 0; k < 4; ++k) {
    std::ptrdiff_t i = first + k;
    if (i < 0 || i >= n) {
      switch (tiling) {
        case Tiling::bounded:
          i = std::clamp(i, std::ptrdiff_t{0}, n - 1);
          break;
        case Tiling::repeat:
          i = (i + n) % n;
          break;
        case Tiling::mirror:
          i = (i + 2 * n) % (2 * n);
          if (i >= n) i = 2 * n - 1 - i;
          break;
      }
    }
    result.index[static_cast<std::size_t>(k)] = static_cast<std::size_t>(i);
  }
  return result;
}

}  // namespace

HeightField::HeightField(const Grid& grid, std::vector<float> heights_m)
    : grid_(grid), heights_m_(std::move(heights_m)) {
  if (!std::isfinite(grid.pitch_m) || grid.pitch_m <= 0.0) {
    throw std::invalid_argument("pitch_m of a height field is " + number_text(grid.pitch_m) +
                                "; it must be a positive length in metres.");
  }
  if (grid.rows < 2 || grid.columns < 2) {
    throw std::invalid_argument("rows and columns of a height field are " +
                                std::to_string(grid.rows) + " and " + std::to_string(grid.columns) +
                                "; each must be at least 2.");
  }
  const std::size_t count = heights_m_.size();
  if (count % grid.columns != 0 || count / grid.columns != grid.rows) {
    throw std::invalid_argument("heights_m of a height field of " + std::to_string(grid.rows) +
                                " by " + std::to_string(grid.columns) +
                                ": the number of heights is " + std::to_string(count) +
                                "; it must be rows · columns.");
  }
  double sum_m = 0.0;
  float low_m = heights_m_.front();
  float high_m = low_m;
  for (const float height_m : heights_m_) {
    if (!std::isfinite(height_m)) {
      throw std::invalid_argument(
          "heights_m of a height field contains a height that is not finite; all must be finite.");
    }
    sum_m += static_cast<double>(height_m);
    low_m = std::min(low_m, height_m);
    high_m = std::max(high_m, height_m);
  }
  minimum_m_ = static_cast<double>(low_m);
  maximum_m_ = static_cast<double>(high_m);
  mean_m_ = sum_m / static_cast<double>(count);
  double sum_m2 = 0.0;
  for (const float height_m : heights_m_) {
    const double deviation_m = static_cast<double>(height_m) - mean_m_;
    sum_m2 += deviation_m * deviation_m;
  }
  rms_m_ = std::sqrt(sum_m2 / static_cast<double>(count));
}

HeightSample HeightField::sample(double x_m, double y_m, Tiling tiling) const noexcept {
  const double u = x_m / grid_.pitch_m + 0.5 * static_cast<double>(grid_.columns - 1);
  const double v = 0.5 * static_cast<double>(grid_.rows - 1) - y_m / grid_.pitch_m;
  const Neighbours across = neighbours(u, grid_.columns, tiling);
  const Neighbours down = neighbours(v, grid_.rows, tiling);
  const Weights wx = keys_weights(across.t);
  const Weights wy = keys_weights(down.t);

  HeightSample result{};
  for (std::size_t i = 0; i < 4; ++i) {
    const float* row_m = heights_m_.data() + down.index[i] * grid_.columns;
    double height_m = 0.0;
    double rise_m = 0.0;  // per sample, along u
    for (std::size_t j = 0; j < 4; ++j) {
      const auto node_m = static_cast<double>(row_m[across.index[j]]);
      height_m += wx.value[j] * node_m;
      rise_m += wx.slope[j] * node_m;
    }
    result.height_m += wy.value[i] * height_m;
    result.slope_x += wy.value[i] * rise_m;
    result.slope_y += wy.slope[i] * height_m;
  }
  result.slope_x /= grid_.pitch_m;
  result.slope_y /= -grid_.pitch_m;  // row indices increase downwards, y upwards
  return result;
}

}  // namespace asperity
