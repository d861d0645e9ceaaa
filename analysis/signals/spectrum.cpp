// Spectra by Eigen's transform, which is quick only where a length has small prime factors.

#include "analysis/signals/spectrum.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/Core>
#include <unsupported/Eigen/FFT>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

std::size_t greatest_prime_factor(std::size_t n) {
  std::size_t greatest = 1;
  for (std::size_t factor = 2; factor * factor <= n; ++factor) {
    while (n % factor == 0) {
      n /= factor;
      greatest = factor;
    }
  }
  return std::max(greatest, n);
}

Eigen::FFT<double> transform_without_plans() {
  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);  // of real signals
  return fft;
}

// The transform with the plans of the latest lengths, which take longer to make than to use: the windows of a record and the
// axes of a force have the same length. Bounded, because records have many lengths.
Eigen::FFT<double>& transform_of(std::size_t length) {
  constexpr std::size_t kMostLengths = 8;
  thread_local std::vector<std::size_t> lengths;
  thread_local Eigen::FFT<double> fft = transform_without_plans();
  if (std::find(lengths.begin(), lengths.end(), length) == lengths.end()) {
    if (lengths.size() == kMostLengths) {
      fft = transform_without_plans();
      lengths.clear();
    }
    lengths.push_back(length);
  }
  return fft;
}

// What [Bluestein 1970] needs of a length besides the signal.
struct Chirp {
  std::vector<Complex> factors{};  // exp(−πi·n²/N)
  std::vector<Complex> kernel_lines{};
};

Chirp chirp_of(std::size_t count) {
  Chirp chirp{.factors = std::vector<Complex>(count)};
  for (std::uint64_t n = 0; n < count; ++n) {  // n² modulo 2N keeps the angle exact
    const auto turns = static_cast<double>((n * n) % (2 * count));
    chirp.factors[n] = std::polar(1.0, -kPi * turns / static_cast<double>(count));
  }
  const std::size_t padded = std::bit_ceil(2 * count);
  std::vector<Complex> kernel(padded);
  for (std::size_t n = 0; n < count; ++n) {
    kernel[n] = std::conj(chirp.factors[n]);
    kernel[(padded - n) % padded] = std::conj(chirp.factors[n]);
  }
  transform_of(padded).fwd(chirp.kernel_lines, kernel);
  return chirp;
}

const Chirp& latest_chirp(std::size_t count) {
  thread_local Chirp latest;
  if (latest.factors.size() != count) latest = chirp_of(count);
  return latest;
}

// [Bluestein 1970]: with k·n = (k² + n² − (k − n)²)/2 the transform is a convolution with a chirp,
// which transforms of a length with small factors can do.
std::vector<Complex> spectrum_by_chirp(std::span<const double> signal) {
  const std::size_t count = signal.size();
  const Chirp& chirp = latest_chirp(count);
  std::vector<Complex> modulated(chirp.kernel_lines.size());
  for (std::size_t n = 0; n < count; ++n) {
    modulated[n] = signal[n] * chirp.factors[n];
  }
  Eigen::FFT<double>& fft = transform_of(modulated.size());
  std::vector<Complex> lines;
  fft.fwd(lines, modulated);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    lines[k] *= chirp.kernel_lines[k];
  }
  fft.inv(modulated, lines);
  modulated.resize(count / 2 + 1);
  for (std::size_t k = 0; k < modulated.size(); ++k) {
    modulated[k] *= chirp.factors[k];
  }
  return modulated;
}

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

// A line of a one-sided spectrum stands for two, but the first and, of an even length, the last.
double sides(std::size_t k, std::size_t count) { return k == 0 || 2 * k == count ? 1.0 : 2.0; }

std::size_t smooth_length_up_to(std::size_t most) {
  while (greatest_prime_factor(most) > 5) {
    --most;
  }
  return most;
}

// The central part of a height field, less its plane, under a window.
struct Patch {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> heights_m{};
  bool flat = false;
};

Patch tapered_centre(const HeightSamples& samples) {
  constexpr std::size_t kMost = 1024;
  Patch patch;
  patch.rows = smooth_length_up_to(std::min(samples.rows, kMost));
  patch.columns = smooth_length_up_to(std::min(samples.columns, kMost));
  const std::size_t first_row = (samples.rows - patch.rows) / 2;
  const std::size_t first_column = (samples.columns - patch.columns) / 2;
  patch.heights_m.resize(patch.rows * patch.columns);

  // On a full grid about its middle the three terms of a plane do not mix.
  const double row_middle = 0.5 * static_cast<double>(patch.rows - 1);
  const double column_middle = 0.5 * static_cast<double>(patch.columns - 1);
  double greatest_m = 0.0;
  double sum = 0.0;
  double row_moment = 0.0;
  double column_moment = 0.0;
  for (std::size_t r = 0; r < patch.rows; ++r) {
    for (std::size_t c = 0; c < patch.columns; ++c) {
      const double height_m =
          samples.heights_m[(first_row + r) * samples.columns + first_column + c];
      if (!std::isfinite(height_m)) {
        throw std::invalid_argument(
            "heights_m: the height in row " + std::to_string(first_row + r) + ", column " +
            std::to_string(first_column + c) + " is not finite; all must be finite");
      }
      patch.heights_m[r * patch.columns + c] = height_m;
      greatest_m = std::max(greatest_m, std::abs(height_m));
      sum += height_m;
      row_moment += height_m * (static_cast<double>(r) - row_middle);
      column_moment += height_m * (static_cast<double>(c) - column_middle);
    }
  }
  const auto rows = static_cast<double>(patch.rows);
  const auto columns = static_cast<double>(patch.columns);
  const double count = rows * columns;
  const double mean_m = sum / count;
  const double row_slope_m = row_moment / (count * (rows * rows - 1.0) / 12.0);
  const double column_slope_m = column_moment / (count * (columns * columns - 1.0) / 12.0);
  double squares_m2 = 0.0;
  const std::vector<double> down = hann_window(patch.rows);
  const std::vector<double> across = hann_window(patch.columns);
  for (std::size_t r = 0; r < patch.rows; ++r) {
    for (std::size_t c = 0; c < patch.columns; ++c) {
      double& height_m = patch.heights_m[r * patch.columns + c];
      height_m -= mean_m + row_slope_m * (static_cast<double>(r) - row_middle) +
                  column_slope_m * (static_cast<double>(c) - column_middle);
      squares_m2 += height_m * height_m;
      height_m *= down[r] * across[c];
    }
  }
  // A plane in single precision is rough by 6·10⁻⁸ of its heights.
  patch.flat = !(std::sqrt(squares_m2 / count) > 1e-6 * greatest_m);
  return patch;
}

}  // namespace

std::vector<Complex> real_spectrum(std::span<const double> signal) {
  if (signal.empty()) {
    throw std::invalid_argument("signal is empty; a spectrum needs at least one sample");
  }
  if (signal.size() == 1) {
    return {signal[0]};  // Eigen's transform reads out of bounds for a single sample
  }
  if (greatest_prime_factor(signal.size()) > 100) {
    return spectrum_by_chirp(signal);
  }
  const std::vector<double> input(signal.begin(), signal.end());
  std::vector<Complex> lines;
  transform_of(signal.size()).fwd(lines, input);
  lines.resize(signal.size() / 2 + 1);
  return lines;
}

std::vector<double> hann_window(std::size_t count) {
  std::vector<double> window(count);
  for (std::size_t i = 0; i < count; ++i) {
    window[i] =
        0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(i) / static_cast<double>(count));
  }
  return window;
}

PowerSpectrum welch_spectrum(std::span<const double> signal, const WelchWindows& windows) {
  const std::size_t length = windows.length;
  if (length < 2 || signal.size() < length) {
    throw std::invalid_argument("windows.length is " + std::to_string(length) +
                                "; it must be at least 2 and at most the number of samples, " +
                                std::to_string(signal.size()));
  }
  if (!(windows.rate_Hz > 0.0)) {
    throw std::invalid_argument("rate_Hz is " + number_text(windows.rate_Hz) +
                                "; it must be above 0");
  }
  std::vector<double> density(length / 2 + 1);
  std::vector<double> tapered(length);
  const std::vector<double> taper = hann_window(length);
  double taper_power = 0.0;
  for (const double weight : taper) {
    taper_power += weight * weight;
  }
  std::size_t count = 0;
  const std::size_t step = std::max<std::size_t>(1, length / 2);
  for (std::size_t begin = 0; begin + length <= signal.size(); begin += step) {
    const auto window = signal.subspan(begin, length);
    const double mean = mean_of(window);
    for (std::size_t i = 0; i < length; ++i) {
      tapered[i] = (window[i] - mean) * taper[i];
    }
    const std::vector<Complex> lines = real_spectrum(tapered);
    for (std::size_t k = 0; k < density.size(); ++k) {
      density[k] += sides(k, length) * std::norm(lines[k]);
    }
    ++count;
  }
  for (double& value : density) {
    value /= static_cast<double>(count) * taper_power * windows.rate_Hz;
  }
  return {windows.rate_Hz / static_cast<double>(length), std::move(density)};
}

double band_power(const PowerSpectrum& spectrum, const FrequencyBand& band) noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    const double frequency_Hz = static_cast<double>(k) * spectrum.spacing_Hz;
    if (frequency_Hz >= band.low_Hz && frequency_Hz <= band.high_Hz) {
      sum += spectrum.density[k];
    }
  }
  return sum * spectrum.spacing_Hz;
}

double band_rms(std::span<const double> signal, double rate_Hz, double low_Hz, double high_Hz) {
  if (!(rate_Hz > 0.0)) {
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
  }
  if (!(low_Hz >= 0.0 && low_Hz <= high_Hz)) {
    throw std::invalid_argument("low_Hz is " + number_text(low_Hz) + " and high_Hz " +
                                number_text(high_Hz) +
                                "; the band must satisfy 0 <= low_Hz <= high_Hz");
  }
  if (signal.empty()) {
    throw std::invalid_argument("signal is empty; an RMS needs at least one sample");
  }
  std::vector<double> about_mean(signal.begin(), signal.end());
  const double mean = mean_of(signal);
  for (double& value : about_mean) {
    value -= mean;
  }
  if (std::all_of(about_mean.begin(), about_mean.end(),
                  [](double value) { return value == 0.0; })) {
    return 0.0;  // such as an axis on which a texture exerts no force
  }
  const std::vector<Complex> lines = real_spectrum(about_mean);
  const auto count = static_cast<double>(signal.size());
  double sum = 0.0;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double frequency_Hz = static_cast<double>(k) * rate_Hz / count;
    if (frequency_Hz >= low_Hz && frequency_Hz <= high_Hz) {
      sum += sides(k, signal.size()) * std::norm(lines[k]);
    }
  }
  return std::sqrt(sum) / count;
}

std::optional<double> dominant_wavelength_m(const HeightSamples& samples) {
  if (samples.rows < 16 || samples.columns < 16) {
    throw std::invalid_argument("heights_m has the size " + std::to_string(samples.rows) + " × " +
                                std::to_string(samples.columns) +
                                "; a dominant wavelength requires at least 16 rows and columns");
  }
  if (samples.heights_m.size() != samples.rows * samples.columns) {
    throw std::invalid_argument(
        "heights_m has " + counted(samples.heights_m.size(), "height", "heights") +
        "; the number must be rows times columns, " + std::to_string(samples.rows) + " times " +
        std::to_string(samples.columns));
  }
  if (!(samples.pitch_m > 0.0)) {
    throw std::invalid_argument("pitch_m is " + number_text(samples.pitch_m) +
                                "; it must be above 0");
  }
  const Patch patch = tapered_centre(samples);
  if (patch.flat) {
    return std::nullopt;
  }
  const std::size_t half = patch.columns / 2 + 1;
  std::vector<Complex> lines(patch.rows * half);
  for (std::size_t r = 0; r < patch.rows; ++r) {
    const auto row = real_spectrum(
        std::span<const double>(patch.heights_m).subspan(r * patch.columns, patch.columns));
    std::copy(row.begin(), row.end(), lines.begin() + static_cast<std::ptrdiff_t>(r * half));
  }

  const double longest_m =
      static_cast<double>(std::min(patch.rows, patch.columns)) * samples.pitch_m / 3.0;
  const double lowest_per_m = 1.0 / longest_m;
  const double highest_per_m = 0.5 / samples.pitch_m;
  struct Band {
    double power = 0.0;
    double power_times_frequency = 0.0;
  };
  std::array<Band, 32> bands{};  // third octaves of 1024/3 : 2 are 23
  Eigen::FFT<double> fft;
  std::vector<Complex> column(patch.rows);
  std::vector<Complex> column_lines;
  for (std::size_t c = 0; c < half; ++c) {
    for (std::size_t r = 0; r < patch.rows; ++r) {
      column[r] = lines[r * half + c];
    }
    fft.fwd(column_lines, column);
    const double across_per_m =
        static_cast<double>(c) / (static_cast<double>(patch.columns) * samples.pitch_m);
    for (std::size_t r = 0; r < patch.rows; ++r) {
      const double down_per_m = static_cast<double>(std::min(r, patch.rows - r)) /
                                (static_cast<double>(patch.rows) * samples.pitch_m);
      const double frequency_per_m = std::hypot(across_per_m, down_per_m);
      if (frequency_per_m < lowest_per_m || frequency_per_m > highest_per_m) {
        continue;
      }
      const double power = sides(c, patch.columns) * std::norm(column_lines[r]);
      // The border of the lowest band is a line of the spectrum; rounding must not move it below.
      const double octaves = std::log2(frequency_per_m / lowest_per_m);
      Band& band = bands[static_cast<std::size_t>(3.0 * octaves + 1e-9)];
      band.power += power;
      band.power_times_frequency += power * frequency_per_m;
    }
  }
  const Band& greatest = *std::max_element(
      bands.begin(), bands.end(), [](const Band& a, const Band& b) { return a.power < b.power; });
  if (!(greatest.power > 0.0)) {
    return std::nullopt;
  }
  return greatest.power / greatest.power_times_frequency;
}

}  // namespace asperity
