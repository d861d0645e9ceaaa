// The filter against the plain way: continue the picture, transform it whole, multiply, go back.

#include "stimuli/pictures/picture_filter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace asperity {
namespace {

GreyImage noise(std::size_t rows, std::size_t columns) {
  GreyImage image{rows, columns, {}};
  std::uint32_t state = 12345;
  for (std::size_t i = 0; i < rows * columns; ++i) {
    state = 1664525U * state + 1013904223U;
    image.values.push_back(static_cast<float>(state >> 8U) / 16777216.0F);
  }
  return image;
}

float gaussian_factor(int frequency, int n, double cutoff_wavelength) {
  const double ratio = static_cast<double>(frequency) / n * cutoff_wavelength;
  return static_cast<float>(std::exp(-0.5 * ratio * ratio));
}

/// OpenCV packs the half spectrum of a real n-vector as Re₀ Re₁ Im₁ Re₂ Im₂ …; in two dimensions the
/// first and the last column that way downwards, the others are complex columns.
void multiply(cv::Mat& spectrum, double cutoff_wavelength, const RadialFilter& filter) {
  const int rows = spectrum.rows;
  const int columns = spectrum.cols;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const bool packed_downwards = j == 0 || j == columns - 1;
      const int down = packed_downwards ? (i + 1) / 2 : std::min(i, rows - i);
      const float across = static_cast<float>(filter.gaussian) *
                           gaussian_factor((j + 1) / 2, columns, cutoff_wavelength);
      spectrum.at<float>(i, j) *= static_cast<float>(filter.constant) +
                                  across * gaussian_factor(down, rows, cutoff_wavelength);
    }
  }
}

std::vector<float> plainly_filtered(const GreyImage& image, double cutoff_wavelength,
                                    const RadialFilter& filter) {
  const auto before = [cutoff_wavelength](std::size_t size) {
    const double margin = std::ceil(3.0 * cutoff_wavelength / (2.0 * std::numbers::pi));
    return static_cast<int>(std::min(margin, static_cast<double>(size)));
  };
  const auto continued = [&before](std::size_t size) {
    return 2 * cv::getOptimalDFTSize((static_cast<int>(size) + 2 * before(size) + 1) / 2);
  };
  const int top = before(image.rows);
  const int left = before(image.columns);
  const cv::Mat picture(static_cast<int>(image.rows), static_cast<int>(image.columns), CV_32FC1,
                        const_cast<float*>(image.values.data()));
  cv::Mat whole;
  cv::copyMakeBorder(picture, whole, top, continued(image.rows) - picture.rows - top, left,
                     continued(image.columns) - picture.cols - left, cv::BORDER_REFLECT);
  cv::dft(whole, whole);
  multiply(whole, cutoff_wavelength, filter);
  cv::dft(whole, whole, cv::DFT_INVERSE | cv::DFT_SCALE);
  const cv::Mat result = whole(cv::Rect(left, top, picture.cols, picture.rows)).clone();
  return {result.ptr<float>(0), result.ptr<float>(0) + result.total()};
}

TEST(PictureSpectrum, GivesTheNumbersOfOneTransformOfTheWholePictureOnAnyNumberOfThreads) {
  const RadialFilter low_pass{};
  const RadialFilter raising{.constant = 2.0, .gaussian = -1.5};
  // Narrow ones are reflected more than once, and 17 + 2·17 is continued beyond that.
  for (const auto& [rows, columns] :
       {std::pair<std::size_t, std::size_t>{64, 48}, {17, 130}, {101, 33}, {250, 96}}) {
    const GreyImage image = noise(rows, columns);
    for (const double cutoff_wavelength : {2.5, 20.0, 300.0}) {
      for (const int threads : {1, 2, 3, 7}) {
        const PictureSpectrum spectrum(image, cutoff_wavelength, threads);
        for (const RadialFilter& filter : {low_pass, raising, low_pass}) {
          const GreyImage result = spectrum.filtered(filter);
          EXPECT_EQ(result.rows, rows);
          EXPECT_EQ(result.columns, columns);
          EXPECT_EQ(result.values, plainly_filtered(image, cutoff_wavelength, filter))
              << rows << " by " << columns << ", " << cutoff_wavelength << " pixels, " << threads
              << " threads";
        }
      }
    }
  }
}

}  // namespace
}  // namespace asperity
