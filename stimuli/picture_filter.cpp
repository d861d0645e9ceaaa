// Filters by multiplying the packed spectrum of a real picture.

#include "stimuli/picture_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace asperity {

namespace {

/// exp(−ν²/(2 ν₀²)) for ν = 0, 1/n, 2/n … ½. A Gaussian in two dimensions is the product of two.
std::vector<float> gaussian_factors(int n, double cutoff_wavelength) {
  std::vector<float> factors(static_cast<std::size_t>(n / 2 + 1));
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const double ratio = static_cast<double>(k) / n * cutoff_wavelength;
    factors[k] = static_cast<float>(std::exp(-0.5 * ratio * ratio));
  }
  return factors;
}

/// OpenCV packs the half spectrum of a real n-vector as Re₀ Re₁ Im₁ Re₂ Im₂ …: frequency of slot i.
std::size_t packed_frequency(int i) noexcept { return static_cast<std::size_t>((i + 1) / 2); }

/// In two dimensions the columns of horizontal frequency 0 and ½ are packed that way downwards;
/// the others are complex columns with plain frequencies 0 … n − 1.
void multiply_packed(cv::Mat& spectrum, const RadialFilter& filter) {
  const int rows = spectrum.rows;
  const int columns = spectrum.cols;
  const std::vector<float> across = gaussian_factors(columns, filter.cutoff_wavelength);
  const std::vector<float> down = gaussian_factors(rows, filter.cutoff_wavelength);
  const auto constant = static_cast<float>(filter.constant);
  const auto gaussian = static_cast<float>(filter.gaussian);

  std::vector<float> across_packed(static_cast<std::size_t>(columns));
  for (int j = 0; j < columns; ++j) {
    across_packed[static_cast<std::size_t>(j)] = gaussian * across[packed_frequency(j)];
  }
  for (int i = 0; i < rows; ++i) {
    float* row = spectrum.ptr<float>(i);
    const float complex_factor = down[static_cast<std::size_t>(std::min(i, rows - i))];
    const float packed_factor = down[packed_frequency(i)];
    const auto last = static_cast<std::size_t>(columns - 1);
    const float first_value = row[0] * (constant + across_packed[0] * packed_factor);
    const float last_value = row[last] * (constant + across_packed[last] * packed_factor);
    for (std::size_t j = 0; j <= last; ++j) row[j] *= constant + across_packed[j] * complex_factor;
    row[0] = first_value;
    if (columns % 2 == 0) row[last] = last_value;
  }
}

int padded_size(int size, int margin) {
  // Even sizes let the packed spectrum end with the frequency ½.
  return 2 * cv::getOptimalDFTSize((size + 2 * margin + 1) / 2);
}

}  // namespace

cv::Mat filtered(const cv::Mat& picture, const RadialFilter& filter) {
  constexpr double kMarginSigmas = 3.0;  // a Gaussian has 0.3 % of itself beyond that
  const double sigma = filter.cutoff_wavelength / (2.0 * std::numbers::pi);
  const auto margin_for = [&](int size) {
    return static_cast<int>(std::min(std::ceil(kMarginSigmas * sigma), static_cast<double>(size)));
  };
  const int top = margin_for(picture.rows);
  const int left = margin_for(picture.cols);
  const int rows = padded_size(picture.rows, top);
  const int columns = padded_size(picture.cols, left);
  cv::Mat spectrum;
  cv::copyMakeBorder(picture, spectrum, top, rows - picture.rows - top, left,
                     columns - picture.cols - left, cv::BORDER_REFLECT);
  cv::dft(spectrum, spectrum);
  multiply_packed(spectrum, filter);
  cv::dft(spectrum, spectrum, cv::DFT_INVERSE | cv::DFT_SCALE);
  return spectrum(cv::Rect(left, top, picture.cols, picture.rows)).clone();
}

}  // namespace asperity
