// Roughness of records and heights.

#include "analysis/roughness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "analysis/filters.h"
#include "analysis/spectrum.h"

namespace asperity {
namespace {

constexpr double kBest_Hz = 250.0;
constexpr double kOmega_rad_per_s = 2.0 * std::numbers::pi * kBest_Hz;
constexpr double kThreshold_m_per_s2 = kOmega_rad_per_s * kOmega_rad_per_s * 0.1e-6;

void refuse_unusable(std::span<const double> record, double rate_Hz) {
  if (record.empty()) {
    throw std::invalid_argument("the record is empty; roughness needs at least one sample");
  }
  if (!(rate_Hz > 0.0)) {
    throw std::invalid_argument("rate_Hz must be positive");
  }
}

std::vector<double> about_mean(std::span<const double> record) {
  double sum = 0.0;
  for (const double value : record) {
    sum += value;
  }
  const double mean = sum / static_cast<double>(record.size());
  std::vector<double> centred(record.begin(), record.end());
  for (double& value : centred) {
    value -= mean;
  }
  return centred;
}

double rms_of(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value * value;
  }
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Calls visit(frequency_Hz, mean_square) for every line but the first.
template <class Visit>
void for_each_line(std::span<const double> centred, double rate_Hz, Visit visit) {
  const auto lines = real_spectrum(centred);
  const auto count = static_cast<double>(centred.size());
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double sides = 2 * k == centred.size() ? 1.0 : 2.0;
    visit(static_cast<double>(k) * rate_Hz / count, sides * std::norm(lines[k]) / (count * count));
  }
}

}  // namespace

RecordRoughness record_roughness(std::span<const double> record, double rate_Hz) {
  refuse_unusable(record, rate_Hz);
  const std::vector<double> centred = about_mean(record);
  RecordRoughness roughness;
  roughness.rms = rms_of(centred);
  for (const double value : centred) {
    roughness.maximum = std::max(roughness.maximum, std::abs(value));
  }
  for_each_line(centred, rate_Hz, [&](double frequency_Hz, double power) {
    if (frequency_Hz >= 5.0 && frequency_Hz < 50.0) {
      roughness.fa1_power += power;
    } else if (frequency_Hz >= 50.0 && frequency_Hz <= 500.0) {
      roughness.fa2_power += power;
    }
  });
  return roughness;
}

std::optional<double> acceleration_roughness_dB(std::span<const double> acceleration_m_per_s2,
                                                double rate_Hz) {
  refuse_unusable(acceleration_m_per_s2, rate_Hz);
  const auto waking = static_cast<std::size_t>(0.010 * rate_Hz);
  if (acceleration_m_per_s2.size() <= waking) {
    throw std::invalid_argument("the record is no longer than the 10 ms in which the filter wakes");
  }
  const std::vector<double> passed =
      filtered(ButterworthFilter(LowPass{.order = 4, .cutoff_Hz = 300.0}, rate_Hz),
               about_mean(acceleration_m_per_s2));
  const double rms = rms_of(std::span<const double>(passed).subspan(waking));
  if (!(rms > 0.0)) {
    return std::nullopt;
  }
  return 20.0 * std::log10(rms / kThreshold_m_per_s2);
}

double pacinian_power(std::span<const double> acceleration_m_per_s2, double rate_Hz) {
  refuse_unusable(acceleration_m_per_s2, rate_Hz);
  double sum = 0.0;
  for_each_line(about_mean(acceleration_m_per_s2), rate_Hz,
                [&sum](double frequency_Hz, double power) {
                  if (frequency_Hz < 40.0) {
                    return;
                  }
                  const double over = std::max(1.0, frequency_Hz / kBest_Hz);
                  const double threshold_m_per_s2 = kThreshold_m_per_s2 * over * over * over * over;
                  sum += 2.0 * power / (threshold_m_per_s2 * threshold_m_per_s2);
                });
  return sum;
}

std::optional<HeightRoughness> height_roughness(std::span<const float> heights_m) {
  if (heights_m.empty()) {
    throw std::invalid_argument("heights_m is empty; roughness needs at least one height");
  }
  const auto [lowest, highest] = std::minmax_element(heights_m.begin(), heights_m.end());
  if (*lowest == *highest) {
    return std::nullopt;
  }
  double sum_m = 0.0;
  for (const float height_m : heights_m) {
    sum_m += height_m;
  }
  const auto count = static_cast<double>(heights_m.size());
  const double mean_m = sum_m / count;
  double absolute = 0.0;
  double squares = 0.0;
  double cubes = 0.0;
  double fourths = 0.0;
  for (const float height_m : heights_m) {
    const double z = height_m - mean_m;
    absolute += std::abs(z);
    squares += z * z;
    cubes += z * z * z;
    fourths += z * z * z * z;
  }
  const double variance = squares / count;
  const double sq = std::sqrt(variance);
  return HeightRoughness{.Sa_m = absolute / count,
                         .Sq_m = sq,
                         .Ssk = cubes / count / (variance * sq),
                         .Sku = fourths / count / (variance * variance)};
}

}  // namespace asperity
