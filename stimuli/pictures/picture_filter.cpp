// Implements filters by multiplication of the half spectrum of a real picture, with its columns contiguous in memory.

#include "stimuli/pictures/picture_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <opencv2/core.hpp>

#include "stimuli/pictures/bands.h"

namespace asperity {

namespace {

// The number of rows or columns that are transformed together: enough to share the tables of a transform, few enough to
// stay in a core's cache.
constexpr std::size_t kTogether = 32;

/// (ν/ν₀)² for ν = 0, 1/n, 2/n … ½.
std::vector<double> squared_ratios(std::size_t n, double cutoff_wavelength) {
  std::vector<double> ratios(n / 2 + 1);
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const double ratio = static_cast<double>(k) / static_cast<double>(n) * cutoff_wavelength;
    ratios[k] = ratio * ratio;
  }
  return ratios;
}

/// exp(−ν²/(2 ν₀²)). A Gaussian in two dimensions is the product of two.
std::vector<float> gaussian_factors(const std::vector<double>& squared_ratios) {
  std::vector<float> factors(squared_ratios.size());
  for (std::size_t k = 0; k < factors.size(); ++k) {
    factors[k] = static_cast<float>(std::exp(-0.5 * squared_ratios[k]));
  }
  return factors;
}

/// max(1, ν/ν₀)⁻ᵖ, from (ν/ν₀)².
float tilted(double squared_ratio, double tilt) {
  return squared_ratio > 1.0 ? static_cast<float>(std::pow(squared_ratio, -0.5 * tilt)) : 1.0F;
}

cv::Mat rows_at(float* values, std::size_t rows, std::size_t length, int type) {
  return cv::Mat(static_cast<int>(rows), static_cast<int>(length), type, values);
}

/// A column of frequency 0 or ½ is the transform of real numbers: the second half mirrors the first, and only the first
/// half is used.
void make_symmetric(float* column, std::size_t n) noexcept {
  column[1] = 0.0F;
  for (std::size_t i = 1; i < n / 2; ++i) {
    column[2 * (n - i)] = column[2 * i];
    column[2 * (n - i) + 1] = -column[2 * i + 1];
  }
  column[n + 1] = 0.0F;
}

}  // namespace

PictureSpectrum::Side PictureSpectrum::continued(std::size_t picture, double cutoff_wavelength) {
  constexpr double kMarginSigmas = 3.0;  // a Gaussian has 0.3 % of its area outside
  const double sigma = cutoff_wavelength / (2.0 * std::numbers::pi);
  const auto before = static_cast<std::size_t>(
      std::min(std::ceil(kMarginSigmas * sigma), static_cast<double>(picture)));
  // With even sizes the half spectrum ends at the frequency ½.
  const auto half = static_cast<int>((picture + 2 * before + 1) / 2);
  return {.picture = picture,
          .before = before,
          .size = 2 * static_cast<std::size_t>(cv::getOptimalDFTSize(half))};
}

/// The index in the picture for each index of the continued picture: … 1 0 | 0 1 … n−1 | n−1 n−2 …
std::vector<std::size_t> PictureSpectrum::reflected_places(const Side& side) {
  std::vector<std::size_t> places(side.size);
  const std::size_t period = 2 * side.picture;
  for (std::size_t i = 0; i < side.size; ++i) {
    const std::size_t within = (i + period - side.before) % period;
    places[i] = within < side.picture ? within : period - 1 - within;
  }
  return places;
}

PictureSpectrum::PictureSpectrum(const GreyImage& picture, double cutoff_wavelength, int threads)
    : cutoff_wavelength_(cutoff_wavelength),
      threads_(threads),
      down_(continued(picture.rows, cutoff_wavelength)),
      across_(continued(picture.columns, cutoff_wavelength)),
      columns_(std::make_unique_for_overwrite<float[]>((across_.size / 2 + 1) * 2 * down_.size)) {
  transform_rows(picture);
  transform_columns();
}

void PictureSpectrum::transform_rows(const GreyImage& picture) {
  const std::size_t length = across_.size;
  const std::vector<std::size_t> source = reflected_places(across_);
  in_bands(picture.rows, threads_, [&](std::size_t first, std::size_t last) {
    std::vector<float> together(kTogether * length);
    for (std::size_t row = first; row < last; row += kTogether) {
      const std::size_t count = std::min(kTogether, last - row);
      for (std::size_t i = 0; i < count; ++i) {
        const float* from = picture.values.data() + (row + i) * picture.columns;
        float* to = together.data() + i * length;
        for (std::size_t j = 0; j < length; ++j) to[j] = from[source[j]];
      }
      const cv::Mat band = rows_at(together.data(), count, length, CV_32FC1);
      cv::dft(band, band, cv::DFT_ROWS);
      // A transformed row is packed as Re₀ Re₁ Im₁ Re₂ Im₂ … Re_½.
      for (std::size_t k = 0; k <= length / 2; ++k) {
        const bool is_real = k == 0 || k == length / 2;
        const float* re = together.data() + (k == 0 ? 0 : 2 * k - 1);
        float* to = columns_.get() + 2 * (k * down_.size + down_.before + row);
        for (std::size_t i = 0; i < count; ++i, re += length, to += 2) {
          to[0] = re[0];
          to[1] = is_real ? 0.0F : re[1];
        }
      }
    }
  });
}

void PictureSpectrum::transform_columns() {
  const std::vector<std::size_t> source = reflected_places(down_);
  in_bands(across_.size / 2 + 1, threads_, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; k += kTogether) {
      const std::size_t count = std::min(kTogether, last - k);
      float* columns = columns_.get() + k * 2 * down_.size;
      for (std::size_t c = 0; c < count; ++c) {
        float* column = columns + c * 2 * down_.size;
        const float* of_picture = column + 2 * down_.before;
        const auto mirror = [&](std::size_t i) {
          column[2 * i] = of_picture[2 * source[i]];
          column[2 * i + 1] = of_picture[2 * source[i] + 1];
        };
        for (std::size_t i = 0; i < down_.before; ++i) mirror(i);
        for (std::size_t i = down_.before + down_.picture; i < down_.size; ++i) mirror(i);
      }
      const cv::Mat band = rows_at(columns, count, down_.size, CV_32FC2);
      cv::dft(band, band, cv::DFT_ROWS);
    }
  });
}

GreyImage PictureSpectrum::filtered(const RadialFilter& filter) const {
  const std::size_t rows = down_.size;
  const std::size_t length = across_.size;
  const std::vector<double> squares_across = squared_ratios(length, cutoff_wavelength_);
  const std::vector<double> squares_down = squared_ratios(rows, cutoff_wavelength_);
  const std::vector<float> across = gaussian_factors(squares_across);
  const std::vector<float> down = gaussian_factors(squares_down);
  const auto constant = static_cast<float>(filter.constant);
  const auto gaussian = static_cast<float>(filter.gaussian);

  // The rows of the picture, each packed as the transform of a real row.
  const auto packed = std::make_unique_for_overwrite<float[]>(down_.picture * length);
  in_bands(length / 2 + 1, threads_, [&](std::size_t first, std::size_t last) {
    std::vector<float> together(kTogether * 2 * rows);
    for (std::size_t k = first; k < last; k += kTogether) {
      const std::size_t count = std::min(kTogether, last - k);
      for (std::size_t c = 0; c < count; ++c) {
        const float* from = columns_.get() + (k + c) * 2 * rows;
        float* to = together.data() + c * 2 * rows;
        const float here = gaussian * across[k + c];
        for (std::size_t i = 0; i < rows; ++i) {
          const std::size_t at = std::min(i, rows - i);
          float factor = constant + here * down[at];
          if (filter.tilt != 0.0) {
            factor *= tilted(squares_across[k + c] + squares_down[at], filter.tilt);
          }
          to[2 * i] = from[2 * i] * factor;
          to[2 * i + 1] = from[2 * i + 1] * factor;
        }
        if (k + c == 0 || k + c == length / 2) make_symmetric(to, rows);
      }
      const cv::Mat band = rows_at(together.data(), count, rows, CV_32FC2);
      cv::dft(band, band, cv::DFT_INVERSE | cv::DFT_ROWS);
      for (std::size_t i = 0; i < down_.picture; ++i) {
        const float* from = together.data() + 2 * (i + down_.before);
        float* row = packed.get() + i * length;
        for (std::size_t c = 0; c < count; ++c, from += 2 * rows) {
          const std::size_t slot = k + c == 0 ? 0 : 2 * (k + c) - 1;
          row[slot] = from[0];
          if (slot != 0 && slot + 1 < length) row[slot + 1] = from[1];
        }
      }
    }
  });

  GreyImage result{down_.picture, across_.picture,
                   std::vector<float>(down_.picture * across_.picture)};
  // cv::dft divides by the size of the transform at the end, in single precision.
  const auto scale = static_cast<float>(1.0 / static_cast<double>(length * rows));
  in_bands(down_.picture, threads_, [&](std::size_t first, std::size_t last) {
    const cv::Mat band = rows_at(packed.get() + first * length, last - first, length, CV_32FC1);
    cv::dft(band, band, cv::DFT_INVERSE | cv::DFT_ROWS);
    for (std::size_t i = first; i < last; ++i) {
      const float* from = packed.get() + i * length + across_.before;
      float* to = result.values.data() + i * across_.picture;
      for (std::size_t j = 0; j < across_.picture; ++j) to[j] = from[j] * scale;
    }
  });
  return result;
}

}  // namespace asperity
