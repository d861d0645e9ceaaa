// Implements filters by multiplication of the complex spectrum of the reflected picture.

#include "stimuli/pictures/reflected_filter.h"

#include <stdexcept>

#include <opencv2/core.hpp>

namespace asperity {

namespace {

/// One dimension of the continued picture: for each index, the index in the picture and whether it is a mirror image.
struct Places {
  std::vector<std::size_t> index{};
  std::vector<bool> is_mirrored{};
};

Places continued(std::size_t length) {
  const std::size_t period = 2 * length;
  const auto size = static_cast<std::size_t>(cv::getOptimalDFTSize(static_cast<int>(period)));
  Places places{std::vector<std::size_t>(size), std::vector<bool>(size)};
  // The copies are divided on both sides of the picture, so that the seam of an enlarged size is far from it.
  const std::size_t before_end = size - (size - length) / 2;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t within =
        i < before_end ? i % period : (period - (size - i) % period) % period;
    places.is_mirrored[i] = within >= length;
    places.index[i] = within < length ? within : period - 1 - within;
  }
  return places;
}

float sign_of(const Continuation& continuation, bool is_across, bool is_down) {
  float sign = 1.0F;
  if (is_across && continuation.across == Reflection::odd) sign = -sign;
  if (is_down && continuation.down == Reflection::odd) sign = -sign;
  return sign;
}

/// The frequency of an index of the transform, in cycles per pixel.
double frequency(std::size_t index, std::size_t size) {
  const double nu = static_cast<double>(index) / static_cast<double>(size);
  return nu > 0.5 ? nu - 1.0 : nu;
}

}  // namespace

ComplexPicture reflected_filter(const ComplexPicture& picture, const Continuation& real,
                                const Continuation& imaginary, const TransferFunction& transfer) {
  if (picture.rows == 0 || picture.columns == 0 ||
      picture.values.size() != picture.rows * picture.columns) {
    throw std::invalid_argument("A picture has " + std::to_string(picture.values.size()) +
                                " values; it needs rows times columns, at least one.");
  }
  const Places down = continued(picture.rows);
  const Places across = continued(picture.columns);
  cv::Mat spectrum(static_cast<int>(down.index.size()), static_cast<int>(across.index.size()),
                   CV_32FC2);
  for (std::size_t i = 0; i < down.index.size(); ++i) {
    auto* row = spectrum.ptr<std::complex<float>>(static_cast<int>(i));
    const std::complex<float>* from = picture.values.data() + down.index[i] * picture.columns;
    for (std::size_t j = 0; j < across.index.size(); ++j) {
      const std::complex<float> value = from[across.index[j]];
      row[j] = {value.real() * sign_of(real, across.is_mirrored[j], down.is_mirrored[i]),
                value.imag() * sign_of(imaginary, across.is_mirrored[j], down.is_mirrored[i])};
    }
  }
  cv::dft(spectrum, spectrum);
  for (std::size_t i = 0; i < down.index.size(); ++i) {
    auto* row = spectrum.ptr<std::complex<float>>(static_cast<int>(i));
    // Rows count downwards, ν_y upwards.
    const double nu_y = -frequency(i, down.index.size());
    for (std::size_t j = 0; j < across.index.size(); ++j) {
      row[j] *= std::complex<float>(transfer(frequency(j, across.index.size()), nu_y));
    }
  }
  cv::dft(spectrum, spectrum, cv::DFT_INVERSE | cv::DFT_SCALE);
  ComplexPicture result{picture.rows, picture.columns, {}};
  result.values.reserve(picture.values.size());
  for (std::size_t i = 0; i < picture.rows; ++i) {
    const auto* row = spectrum.ptr<std::complex<float>>(static_cast<int>(i));
    result.values.insert(result.values.end(), row, row + picture.columns);
  }
  return result;
}

}  // namespace asperity
