// Implements shading, stretching and the arrangement of pictures side by side.

#include "stimuli/photographs/preview.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace asperity {

namespace {

cv::Mat as_mat(const GreyImage& picture) {
  if (picture.values.empty() || picture.values.size() != picture.rows * picture.columns) {
    throw std::invalid_argument(
        "the numbers of rows, columns and values of a greyscale picture are " +
        std::to_string(picture.rows) + ", " + std::to_string(picture.columns) + " and " +
        std::to_string(picture.values.size()) +
        "; there must be rows · columns values, and at least one.");
  }
  return cv::Mat(static_cast<int>(picture.rows), static_cast<int>(picture.columns), CV_32FC1,
                 const_cast<float*>(picture.values.data()));
}

}  // namespace

GreyImage stretched(GreyImage picture) {
  std::vector<float> sorted = picture.values;
  const auto share = static_cast<std::ptrdiff_t>(sorted.size() / 100);
  std::nth_element(sorted.begin(), sorted.begin() + share, sorted.end());
  const float black = sorted[static_cast<std::size_t>(share)];
  // The values before this position are already the smaller ones.
  std::nth_element(sorted.begin() + share, sorted.end() - 1 - share, sorted.end());
  const float white = *(sorted.end() - 1 - share);
  for (float& value : picture.values) {
    value = white > black ? std::clamp((value - black) / (white - black), 0.0F, 1.0F) : 0.5F;
  }
  return picture;
}

GreyImage scaled_to_fit(const GreyImage& picture, std::size_t longest_side) {
  const cv::Mat source = as_mat(picture);
  const std::size_t longer = std::max(picture.rows, picture.columns);
  if (longest_side == 0) {
    throw std::invalid_argument("longest_side is 0; it must be at least 1 pixel.");
  }
  if (longer <= longest_side) return picture;
  const double factor = static_cast<double>(longest_side) / static_cast<double>(longer);
  cv::Mat scaled;
  cv::resize(
      source, scaled,
      {std::max(1, cvRound(factor * source.cols)), std::max(1, cvRound(factor * source.rows))}, 0.0,
      0.0, cv::INTER_AREA);
  GreyImage result{
      static_cast<std::size_t>(scaled.rows), static_cast<std::size_t>(scaled.cols), {}};
  result.values.assign(scaled.ptr<float>(0), scaled.ptr<float>(0) + scaled.total());
  return result;
}

GreyImage shaded_relief(const HeightField& field) {
  const HeightField::Grid& grid = field.grid();
  GreyImage relief{grid.rows, grid.columns, {}};
  relief.values.reserve(field.heights_m().size());
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.rows; ++i) {
    // At its own samples the slope of the interpolant is the central difference; the outermost samples are repeated
    // outside the field.
    const float* here_m = field.heights_m().data() + i * grid.columns;
    const float* up_m = i > 0 ? here_m - grid.columns : here_m;
    const float* down_m = i + 1 < grid.rows ? here_m + grid.columns : here_m;
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const auto left_m = static_cast<double>(here_m[j > 0 ? j - 1 : j]);
      const auto right_m = static_cast<double>(here_m[j + 1 < grid.columns ? j + 1 : j]);
      const double rise_m =
          right_m - left_m - (static_cast<double>(up_m[j]) - static_cast<double>(down_m[j]));
      // Light from (−1, 1): ground that rises to the right or falls to the top faces it.
      const double facing = 0.5 * rise_m / grid.pitch_m;
      sum += facing * facing;
      relief.values.push_back(static_cast<float>(facing));
    }
  }
  const double rms = std::sqrt(sum / static_cast<double>(relief.values.size()));
  constexpr double kContrast = 0.2;  // 2.5 RMS from mid-grey is black or white
  const auto scale = static_cast<float>(rms > 0.0 ? kContrast / rms : 0.0);
  for (float& value : relief.values) value = std::clamp(0.5F + scale * value, 0.0F, 1.0F);
  return relief;
}

GreyImage height_picture(const HeightField& field) {
  return stretched({field.grid().rows, field.grid().columns, field.heights_m()});
}

GreyImage side_by_side(std::span<const GreyImage> pictures, std::size_t rows) {
  if (pictures.empty() || rows == 0) {
    throw std::invalid_argument(
        "the number of pictures is " + std::to_string(pictures.size()) + " and rows is " +
        std::to_string(rows) + "; placing pictures next to each other needs at least one of each.");
  }
  constexpr int kGap = 6;
  const auto height = static_cast<int>(rows);
  cv::Mat strip;
  for (const GreyImage& picture : pictures) {
    const cv::Mat source = as_mat(picture);
    const double factor = static_cast<double>(rows) / static_cast<double>(picture.rows);
    const int width = std::max(1, cvRound(factor * source.cols));
    cv::Mat scaled;
    cv::resize(source, scaled, {width, height}, 0.0, 0.0,
               factor < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    if (!strip.empty()) cv::hconcat(strip, cv::Mat(height, kGap, CV_32FC1, cv::Scalar(1.0)), strip);
    strip.empty() ? scaled.copyTo(strip) : cv::hconcat(strip, scaled, strip);
  }
  GreyImage result{rows, static_cast<std::size_t>(strip.cols), {}};
  result.values.assign(strip.ptr<float>(0), strip.ptr<float>(0) + strip.total());
  return result;
}

GreyImage texture_steps(const PhotographTexture& texture, std::size_t rows) {
  const std::vector<GreyImage> steps{texture.grey, stretched(texture.evened),
                                     stretched(texture.low_pass), height_picture(texture.field),
                                     shaded_relief(texture.field)};
  return side_by_side(steps, rows);
}

}  // namespace asperity
