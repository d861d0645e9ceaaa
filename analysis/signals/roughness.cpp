// Roughness of records and heights.

#include "analysis/signals/roughness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/filters.h"
#include "analysis/signals/spectrum.h"

namespace asperity {
namespace {

constexpr double kPacinianFrom_Hz = 40.0;

void refuse_unusable_record(std::span<const double> record, double rate_Hz) {
  if (record.empty()) {
    throw std::invalid_argument("the record is empty; roughness needs at least one sample");
  }
  if (!(rate_Hz > 0.0)) {
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
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

double root_mean(std::span<const double> squares) {
  double sum = 0.0;
  for (const double square : squares) {
    sum += square;
  }
  return std::sqrt(sum / static_cast<double>(squares.size()));
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

void add_bands(double frequency_Hz, double power, double& fa1, double& fa2) {
  if (frequency_Hz >= 5.0 && frequency_Hz < 50.0) {
    fa1 += power;
  } else if (frequency_Hz >= 50.0 && frequency_Hz <= 500.0) {
    fa2 += power;
  }
}

// A line's part of P_w.
double pacinian_part(double frequency_Hz, double power, const VibrationThreshold& threshold) {
  if (frequency_Hz < kPacinianFrom_Hz) return 0.0;
  const double over = std::max(1.0, frequency_Hz / threshold.best_Hz);
  const double at_m_per_s2 = threshold.acceleration_m_per_s2() * over * over * over * over;
  return 2.0 * power / (at_m_per_s2 * at_m_per_s2);
}

}  // namespace

RecordRoughness record_roughness(std::span<const double> record, double rate_Hz) {
  refuse_unusable_record(record, rate_Hz);
  const std::vector<double> centred = about_mean(record);
  RecordRoughness roughness;
  roughness.rms = rms_of(centred);
  for (const double value : centred) {
    roughness.maximum = std::max(roughness.maximum, std::abs(value));
  }
  for_each_line(centred, rate_Hz, [&](double frequency_Hz, double power) {
    add_bands(frequency_Hz, power, roughness.fa1_power, roughness.fa2_power);
  });
  return roughness;
}

std::optional<double> acceleration_roughness_dB(std::span<const double> acceleration_m_per_s2,
                                                double rate_Hz) {
  refuse_unusable_record(acceleration_m_per_s2, rate_Hz);
  const auto waking = static_cast<std::size_t>(0.010 * rate_Hz);
  if (acceleration_m_per_s2.size() <= waking) {
    throw std::invalid_argument(
        "the record is not longer than the 10 ms in which the filter settles; use a longer one");
  }
  const std::vector<double> passed =
      filtered(ButterworthFilter(LowPass{.order = 4, .cutoff_Hz = 300.0}, rate_Hz),
               about_mean(acceleration_m_per_s2));
  const double rms = rms_of(std::span<const double>(passed).subspan(waking));
  if (!(rms > 0.0)) {
    return std::nullopt;
  }
  return 20.0 * std::log10(rms / kLargeContactor.acceleration_m_per_s2());
}

double pacinian_power(std::span<const double> acceleration_m_per_s2, double rate_Hz,
                      const VibrationThreshold& threshold) {
  refuse_unusable_record(acceleration_m_per_s2, rate_Hz);
  double sum = 0.0;
  for_each_line(about_mean(acceleration_m_per_s2), rate_Hz, [&](double frequency_Hz, double power) {
    sum += pacinian_part(frequency_Hz, power, threshold);
  });
  return sum;
}

HeldToolRecord::HeldToolRecord(double rate_Hz) : rate_Hz_(rate_Hz) {
  if (!(rate_Hz > 0.0))
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
}

void HeldToolRecord::reserve(std::size_t samples) {
  for (std::vector<double>& one : accelerations_m_per_s2_) one.reserve(samples);
}

void HeldToolRecord::add(double along_m_per_s2, double across_m_per_s2, double beside_m_per_s2) {
  accelerations_m_per_s2_[0].push_back(along_m_per_s2);
  accelerations_m_per_s2_[1].push_back(across_m_per_s2);
  accelerations_m_per_s2_[2].push_back(beside_m_per_s2);
}

void HeldToolRecord::clear() noexcept {
  for (std::vector<double>& one : accelerations_m_per_s2_) one.clear();
}

// Squares of the length of each vector; calls moves(record less its mean) for each direction in which the tool moves.
template <class Visit>
std::vector<double> HeldToolRecord::squares_about_mean(Visit moves) const {
  refuse_unusable_record(accelerations_m_per_s2_[0], rate_Hz_);
  std::vector<double> squares(size(), 0.0);
  for (const std::vector<double>& one : accelerations_m_per_s2_) {
    const std::vector<double> centred = about_mean(one);
    const auto [low, high] = std::minmax_element(centred.begin(), centred.end());
    if (*low == *high) continue;  // held still in this direction
    for (std::size_t i = 0; i < centred.size(); ++i) squares[i] += centred[i] * centred[i];
    moves(centred);
  }
  return squares;
}

double HeldToolRecord::rms_accel_m_per_s2() const {
  return root_mean(squares_about_mean([](const std::vector<double>&) {}));
}

HeldToolRoughness HeldToolRecord::roughness() const {
  HeldToolRoughness roughness{};
  double weighted = 0.0;
  const std::vector<double> squares = squares_about_mean([&](const std::vector<double>& centred) {
    for_each_line(centred, rate_Hz_, [&](double frequency_Hz, double power) {
      add_bands(frequency_Hz, power, roughness.fa1_m2_per_s4, roughness.fa2_m2_per_s4);
      weighted += pacinian_part(frequency_Hz, power, kHeldTool);
    });
  });
  roughness.rms_accel_m_per_s2 = root_mean(squares);
  roughness.max_accel_m_per_s2 = std::sqrt(*std::max_element(squares.begin(), squares.end()));
  if (weighted > 0.0) roughness.pacinian_dB = 10.0 * std::log10(weighted);
  return roughness;
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
