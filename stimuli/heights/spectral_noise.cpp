// Implements the filtering of white noise in the Fourier domain.

#include "stimuli/heights/spectral_noise.h"

#include <cmath>

#include <opencv2/core.hpp>

#include "analysis/words/phrased_error.h"

namespace asperity {

Heights spectral_noise(const SurfaceCanvas& canvas, std::string_view stream,
                       const std::function<double(const Wavenumber&)>& amplitude) {
  const auto n = static_cast<int>(canvas.pixels);
  Random random = Random(canvas.seed).split(stream);
  cv::Mat white(n, n, CV_32FC1);
  for (int i = 0; i < n; ++i) {
    float* row = white.ptr<float>(i);
    for (int j = 0; j < n; ++j) row[j] = static_cast<float>(random.normal());
  }
  cv::Mat spectrum;
  cv::dft(white, spectrum, cv::DFT_COMPLEX_OUTPUT);
  const auto wavenumber = [&](int index) {
    return static_cast<double>(index <= n / 2 ? index : index - n) / canvas.width_m;
  };
  for (int i = 0; i < n; ++i) {
    auto* row = spectrum.ptr<cv::Vec2f>(i);
    for (int j = 0; j < n; ++j) {
      const Wavenumber at{.x_per_m = wavenumber(j), .y_per_m = wavenumber(i)};
      row[j] *= i == 0 && j == 0 ? 0.0F : static_cast<float>(amplitude(at));
    }
  }
  cv::Mat noise;
  cv::dft(spectrum, noise, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
  const double rms = cv::norm(noise, cv::NORM_L2) / n;
  if (!(rms > 1e-20)) {
    throw PhrasedRefusal(
        phrase("Stimuli",
               "No wavelength of this noise fits into the surface; increase width_m or pixels."));
  }
  noise *= 1.0 / rms;
  return {noise.ptr<float>(0), noise.ptr<float>(0) + noise.total()};
}

double amplitude_at(const WavelengthBell& bell, double wavenumber_per_m) noexcept {
  if (wavenumber_per_m == 0.0) return 0.0;
  const double distance = std::log(std::abs(wavenumber_per_m) * bell.centre_m) / bell.spread;
  return std::exp(-0.5 * distance * distance);
}

}  // namespace asperity
