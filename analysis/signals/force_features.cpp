// Features of a force record: resampled over distance, cut into windows, summed in bands.

#include "analysis/signals/force_features.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/signals/spectrum.h"

namespace asperity {
namespace {

constexpr double kSettle_s = 0.1;
constexpr double kCell_m = 0.1e-3;
constexpr std::size_t kWindow = 256;
constexpr std::size_t kLeastWindows = 3;

constexpr double kRoot2 = std::numbers::sqrt2;
constexpr std::array<double, kFeatureBands + 1> kBorders_m{
    10e-3,   10e-3 / kRoot2,   5e-3,     5e-3 / kRoot2,     2.5e-3,   2.5e-3 / kRoot2,
    1.25e-3, 1.25e-3 / kRoot2, 0.625e-3, 0.625e-3 / kRoot2, 0.3125e-3};

void refuse_unusable_force(const FeltForce& felt) {
  const std::size_t count = felt.time_s.size();
  if (felt.travel_m.size() != count || felt.normal_N.size() != count ||
      felt.lateral_N.size() != count) {
    throw std::invalid_argument(
        "FeltForce: the numbers of samples of time_s, travel_m, normal_N and lateral_N are " +
        std::to_string(count) + ", " + std::to_string(felt.travel_m.size()) + ", " +
        std::to_string(felt.normal_N.size()) + " and " + std::to_string(felt.lateral_N.size()) +
        "; they must be equal");
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(felt.time_s[i]) || !std::isfinite(felt.travel_m[i]) ||
        !std::isfinite(felt.normal_N[i]) || !std::isfinite(felt.lateral_N[i])) {
      throw std::invalid_argument("FeltForce: sample " + std::to_string(i) +
                                  " is not finite; all must be finite");
    }
    if (i > 0 && (felt.time_s[i] < felt.time_s[i - 1] || felt.travel_m[i] < felt.travel_m[i - 1])) {
      throw std::invalid_argument("FeltForce: time_s or travel_m decreases at sample " +
                                  std::to_string(i) + "; neither may decrease");
    }
  }
}

// Samples [begin, end) of one unbroken contact, without its landing and lifting.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;
};

std::vector<Stretch> steady_contacts(std::span<const double> time_s) {
  std::vector<Stretch> found;
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= time_s.size(); ++i) {
    if (i < time_s.size() && time_s[i] - time_s[i - 1] <= kLift_s) {
      continue;
    }
    std::size_t first = begin;
    std::size_t last = i;
    while (first < last && time_s[first] < time_s[begin] + kSettle_s) {
      ++first;
    }
    while (last > first && time_s[last - 1] > time_s[i - 1] - kSettle_s) {
      --last;
    }
    if (last > first) {
      found.push_back({first, last});
    }
    begin = i;
  }
  return found;
}

// The mean of the force over each cell of distance; what is left after the last whole cell is
// dropped. The force is a straight line between samples, so each piece adds its middle value.
std::vector<double> over_distance(std::span<const double> force_N, std::span<const double> travel_m,
                                  const Stretch& stretch) {
  std::vector<double> cells;
  const double start_m = travel_m[stretch.begin];
  double sum_Nm = 0.0;
  for (std::size_t i = stretch.begin + 1; i < stretch.end; ++i) {
    const double from_m = travel_m[i - 1] - start_m;
    const double to_m = travel_m[i] - start_m;
    if (!(to_m > from_m)) {
      continue;
    }
    const double slope = (force_N[i] - force_N[i - 1]) / (to_m - from_m);
    double at_m = from_m;
    while (at_m < to_m) {
      const double cell_end_m = kCell_m * static_cast<double>(cells.size() + 1);
      const double piece_end_m = std::min(to_m, cell_end_m);
      const double middle_m = 0.5 * (at_m + piece_end_m);
      sum_Nm += (piece_end_m - at_m) * (force_N[i - 1] + slope * (middle_m - from_m));
      if (piece_end_m == cell_end_m) {
        cells.push_back(sum_Nm / kCell_m);
        sum_Nm = 0.0;
      }
      at_m = piece_end_m;
    }
  }
  return cells;
}

// The window less its straight line of least squares, times a Hann window.
void detrend_and_taper(std::span<double> window) {
  static const std::vector<double> hann = hann_window(kWindow);
  const auto count = static_cast<double>(window.size());
  const double middle = 0.5 * (count - 1.0);
  double sum = 0.0;
  double moment = 0.0;
  for (std::size_t i = 0; i < window.size(); ++i) {
    sum += window[i];
    moment += window[i] * (static_cast<double>(i) - middle);
  }
  const double mean = sum / count;
  const double slope = moment / (count * (count * count - 1.0) / 12.0);
  for (std::size_t i = 0; i < window.size(); ++i) {
    window[i] = (window[i] - mean - slope * (static_cast<double>(i) - middle)) * hann[i];
  }
}

// Mean square of the force in each line of the spectrum, averaged over windows.
class LineSpectrum final {
 public:
  void add(std::span<const double> cells) {
    for (std::size_t begin = 0; begin + kWindow <= cells.size(); begin += kWindow / 2) {
      std::copy_n(cells.begin() + static_cast<std::ptrdiff_t>(begin), kWindow, window_.begin());
      detrend_and_taper(window_);
      const std::vector<std::complex<double>> lines = real_spectrum(window_);
      for (std::size_t k = 0; k < power_.size(); ++k) {
        power_[k] += std::norm(lines[k]);
      }
      ++windows_;
    }
  }

  std::size_t windows() const { return windows_; }

  double power_between(double longest_m, double shortest_m) const {
    constexpr double kSpacing_per_m = 1.0 / (kCell_m * kWindow);
    // One side of the spectrum counts twice; the squares of a Hann window add up to 3/8 of it.
    constexpr double kScale = 2.0 / (kWindow * kWindow * 0.375);
    const double low = 1.0 / (longest_m * kSpacing_per_m);
    const double high = 1.0 / (shortest_m * kSpacing_per_m);
    double sum = 0.0;
    for (std::size_t k = 1; k < kWindow / 2; ++k) {
      const auto line = static_cast<double>(k);
      const double shared = std::min(high, line + 0.5) - std::max(low, line - 0.5);
      sum += std::max(0.0, shared) * power_[k];
    }
    return kScale * sum / static_cast<double>(windows_);
  }

 private:
  std::vector<double> window_ = std::vector<double>(kWindow);
  std::array<double, kWindow / 2 + 1> power_{};
  std::size_t windows_ = 0;
};

// What nobody feels adds to every feature as noise does, in squares, so that it bends away
// smoothly.
double ln_felt(double ratio) { return 0.5 * std::log(ratio * ratio + kFeltRatio * kFeltRatio); }

}  // namespace

std::span<const double> feature_band_borders_m() noexcept { return kBorders_m; }

ForceFeatures force_features(const FeltForce& felt) {
  refuse_unusable_force(felt);
  const double floor = ln_felt(0.0);
  ForceFeatures features;
  features.spectrum.fill(floor);
  features.size = floor;
  features.roughness = floor;

  LineSpectrum normal;
  LineSpectrum lateral;
  double normal_sum_N = 0.0;
  std::size_t count = 0;
  for (const Stretch& stretch : steady_contacts(felt.time_s)) {
    normal.add(over_distance(felt.normal_N, felt.travel_m, stretch));
    lateral.add(over_distance(felt.lateral_N, felt.travel_m, stretch));
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) normal_sum_N += felt.normal_N[i];
    count += stretch.end - stretch.begin;
  }
  if (normal.windows() < kLeastWindows) {
    return features;
  }
  const double normal_N = normal_sum_N / static_cast<double>(count);
  if (!(normal_N > 0.0)) {
    return features;  // a surface that does not push back is not felt
  }

  for (std::size_t band = 0; band < kFeatureBands; ++band) {
    const double power_N2 = normal.power_between(kBorders_m[band], kBorders_m[band + 1]);
    features.spectrum[band] = ln_felt(std::sqrt(power_N2) / normal_N);
  }
  const auto in_all_bands_N = [](const LineSpectrum& lines) {
    return std::sqrt(lines.power_between(kBorders_m.front(), kBorders_m.back()));
  };
  features.size = ln_felt(in_all_bands_N(normal) / normal_N);
  features.roughness = ln_felt(in_all_bands_N(lateral) / normal_N);
  return features;
}

double squared_distance(const ForceFeatures& a, const ForceFeatures& b) noexcept {
  double spectral = 0.0;
  for (std::size_t band = 0; band < kFeatureBands; ++band) {
    const double apart = a.spectrum[band] - b.spectrum[band];
    spectral += apart * apart;
  }
  const double size = a.size - b.size;
  const double roughness = a.roughness - b.roughness;
  return spectral / static_cast<double>(kFeatureBands) + size * size + roughness * roughness;
}

}  // namespace asperity
