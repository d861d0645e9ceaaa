// Implements the resampling of a stroke in equal steps.

#include "renderers/recordings/even_stroke.h"

#include <algorithm>
#include <cmath>

namespace asperity {

// In as many steps as it has samples, so that a stroke of constant speed keeps its samples.
EvenStroke even_stroke(const RecordedStroke& stroke, SpectrumAxis axis, double force_exponent) {
  const std::vector<double>& at = axis == SpectrumAxis::spatial ? stroke.path_m : stroke.time_s;
  const std::size_t count = at.size();
  EvenStroke result{.step = (at.back() - at.front()) / static_cast<double>(count - 1),
                    .force = std::vector<double>(count),
                    .speed_m_per_s = stroke.speed_m_per_s()};
  const double scale = std::pow(stroke.mean_normal_N(), -force_exponent);
  std::size_t after = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = at.front() + static_cast<double>(i) * result.step;
    while (after + 1 < count && at[after] < place) ++after;
    const double gap = at[after] - at[after - 1];
    const double part = gap > 0.0 ? std::clamp((place - at[after - 1]) / gap, 0.0, 1.0) : 1.0;
    result.force[i] = scale * (stroke.force_N[after - 1] +
                               part * (stroke.force_N[after] - stroke.force_N[after - 1]));
  }
  // The least-squares line: a trend would leak into all lines.
  const double middle = 0.5 * static_cast<double>(count - 1);
  double mean = 0.0;
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) - middle;
    mean += result.force[i] / static_cast<double>(count);
    product += x * result.force[i];
    square += x * x;
  }
  for (std::size_t i = 0; i < count; ++i) {
    result.force[i] -= mean + product / square * (static_cast<double>(i) - middle);
  }
  return result;
}

}  // namespace asperity
