// Implements two linear methods of shape from shading.

#include "stimuli/photographs/shape_from_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "analysis/numbers/number_text.h"
#include "stimuli/pictures/reflected_filter.h"

namespace asperity {

namespace {

void subtract_mean(GreyImage& picture) {
  double sum = 0.0;
  for (const float value : picture.values) sum += static_cast<double>(value);
  const auto mean = static_cast<float>(sum / static_cast<double>(picture.values.size()));
  for (float& value : picture.values) value -= mean;
}

/// One pass over all pixels: heights after the iteration, and the sum of f² before it.
class ReflectanceEquation final {
 public:
  ReflectanceEquation(const GreyImage& relative_light, const LightDirection& light)
      : light_(relative_light) {
    const double cotangent = 1.0 / std::tan(light.elevation_rad);
    p_s_ = static_cast<float>(-cotangent * std::cos(light.azimuth_rad));
    q_s_ = static_cast<float>(-cotangent * std::sin(light.azimuth_rad));
    const float steepest = std::abs(p_s_) + std::abs(q_s_);
    w_squared_ = 0.01F * steepest * steepest;
  }

  double step(const GreyImage& from, GreyImage& to) const {
    const std::size_t rows = from.rows;
    const std::size_t columns = from.columns;
    // ∂p/∂Z and ∂q/∂Z have the signs of p_s and q_s.
    const float sign_x = p_s_ < 0.0F ? -1.0F : 1.0F;
    const float sign_y = q_s_ < 0.0F ? -1.0F : 1.0F;
    double squares = 0.0;
    for (std::size_t i = 0; i < rows; ++i) {
      // With sign_y > 0, q = Z − (height below). Rows count downwards. Beyond the border the slope is 0.
      const bool below = sign_y > 0.0F;
      const std::size_t other = below ? (i + 1 < rows ? i + 1 : i) : (i > 0 ? i - 1 : i);
      double squares_of_row = 0.0;
      for (std::size_t j = 0; j < columns; ++j) {
        const bool left = sign_x > 0.0F;
        const std::size_t beside = left ? (j > 0 ? j - 1 : j) : (j + 1 < columns ? j + 1 : j);
        const float here = from.values[i * columns + j];
        const float p = sign_x * (here - from.values[i * columns + beside]);
        const float q = sign_y * (here - from.values[other * columns + j]);
        const float inverse = 1.0F / std::sqrt(1.0F + p * p + q * q);
        const float reflectance = (1.0F + p * p_s_ + q * q_s_) * inverse;
        const float f = light_.values[i * columns + j] - reflectance;
        const float shrink = reflectance * inverse * inverse;
        const float slope =
            -(sign_x * (p_s_ * inverse - p * shrink) + sign_y * (q_s_ * inverse - q * shrink));
        to.values[i * columns + j] = here - 0.5F * f * slope / (slope * slope + w_squared_);
        squares_of_row += static_cast<double>(f) * static_cast<double>(f);
      }
      squares += squares_of_row;
    }
    return squares;
  }

 private:
  const GreyImage& light_;
  float p_s_ = 0.0F;
  float q_s_ = 0.0F;
  float w_squared_ = 0.0F;
};

}  // namespace

void check_light(double azimuth_deg, double elevation_deg, const std::string& method) {
  if (!std::isfinite(azimuth_deg)) {
    throw std::invalid_argument(
        "light_azimuth_deg is not a finite number; give the direction of the light in degrees, "
        "counterclockwise from the right of the picture.");
  }
  if (elevation_deg >= kLowestLight_deg && elevation_deg <= kHighestLight_deg) return;
  std::string sentence = "light_elevation_deg is " + number_text(elevation_deg) + "; the method " +
                         method + " needs oblique light, from " + number_text(kLowestLight_deg) +
                         "° to " + number_text(kHighestLight_deg) + "° above the surface. ";
  if (elevation_deg > kHighestLight_deg) {
    sentence +=
        "Under nearly vertical light the brightness does not determine the direction of a slope. "
        "Take the photograph with a lower light, or use the method wu or brightness.";
  } else {
    sentence +=
        "Lower light casts shadows, which are not shading. Take the photograph with a higher "
        "light.";
  }
  throw std::invalid_argument(sentence);
}

GreyImage relief_by_pentland(const GreyImage& relative_light, const LightDirection& light) {
  ComplexPicture slope{relative_light.rows, relative_light.columns, {}};
  slope.values.reserve(relative_light.values.size());
  const auto tangent = static_cast<float>(std::tan(light.elevation_rad));
  for (const float value : relative_light.values)
    slope.values.emplace_back((1.0F - value) * tangent);
  const double l_x = std::cos(light.azimuth_rad);
  const double l_y = std::sin(light.azimuth_rad);
  constexpr double kEpsilon = kPentlandRegularisation;
  const ComplexPicture relief =
      reflected_filter(slope, {}, {}, [l_x, l_y](double nu_x, double nu_y) -> std::complex<double> {
        const double square = nu_x * nu_x + nu_y * nu_y;
        if (square == 0.0) return 0.0;
        const double along = nu_x * l_x + nu_y * l_y;
        const double factor =
            along / (2.0 * std::numbers::pi * (along * along + kEpsilon * kEpsilon * square));
        return {0.0, -factor};
      });
  GreyImage heights{relief.rows, relief.columns, {}};
  heights.values.reserve(relief.values.size());
  for (const std::complex<float>& value : relief.values) heights.values.push_back(value.real());
  subtract_mean(heights);
  return heights;
}

namespace {

constexpr std::size_t kCoarsestSide = 16;

GreyImage resized(const GreyImage& picture, std::size_t rows, std::size_t columns,
                  cv::InterpolationFlags by) {
  GreyImage result{rows, columns, std::vector<float>(rows * columns)};
  const cv::Mat from(static_cast<int>(picture.rows), static_cast<int>(picture.columns), CV_32FC1,
                     const_cast<float*>(picture.values.data()));
  cv::Mat to(static_cast<int>(rows), static_cast<int>(columns), CV_32FC1, result.values.data());
  cv::resize(from, to, to.size(), 0.0, 0.0, by);
  return result;
}

/// The heights from which the iterations begin: those of the halved picture, or 0 for a small one.
GreyImage initial_heights(const GreyImage& relative_light, const LightDirection& light) {
  const std::size_t rows = relative_light.rows;
  const std::size_t columns = relative_light.columns;
  if (std::min(rows, columns) < 2 * kCoarsestSide) {
    return {rows, columns, std::vector<float>(rows * columns, 0.0F)};
  }
  const GreyImage halved =
      resized(relative_light, (rows + 1) / 2, (columns + 1) / 2, cv::INTER_AREA);
  GreyImage heights = resized(relief_by_tsai_shah(halved, light), rows, columns, cv::INTER_LINEAR);
  for (float& height : heights.values) height *= 2.0F;  // pixels are half as large
  return heights;
}

}  // namespace

GreyImage relief_by_tsai_shah(const GreyImage& relative_light, const LightDirection& light) {
  const ReflectanceEquation equation(relative_light, light);
  GreyImage heights = initial_heights(relative_light, light);
  GreyImage next = heights;
  GreyImage best = heights;
  double least = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration <= kTsaiShahIterations; ++iteration) {
    const double squares = equation.step(heights, next);
    if (squares < least) {
      least = squares;
      best.values = heights.values;
    }
    std::swap(heights, next);
  }
  subtract_mean(best);
  return best;
}

}  // namespace asperity
