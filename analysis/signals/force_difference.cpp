// Energies of the three components by Parseval's theorem; bands have fixed borders from 8 to 500 Hz.

#include "analysis/signals/force_difference.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/spectrum.h"

namespace asperity {

namespace {

constexpr std::array<double, kCriticalBands + 1> kBorders_Hz{8.0,  12.5,  20.0,  31.5,  50.0,
                                                             80.0, 125.0, 200.0, 315.0, 500.0};

void add_energy(std::span<const double> signal_N, double rate_Hz, ForceEnergy& energy) {
  const auto count = static_cast<double>(signal_N.size());
  for (const double force_N : signal_N) energy.total_N2_s += force_N * force_N / rate_Hz;
  const std::vector<std::complex<double>> lines = real_spectrum(signal_N);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const double frequency_Hz = static_cast<double>(k) * rate_Hz / count;
    if (frequency_Hz < kBorders_Hz.front() || frequency_Hz > kBorders_Hz.back()) continue;
    const auto above =
        std::upper_bound(kBorders_Hz.begin() + 1, kBorders_Hz.end() - 1, frequency_Hz);
    const bool at_half_the_rate = 2 * k == signal_N.size();
    energy.bands_N2_s[static_cast<std::size_t>(above - kBorders_Hz.begin()) - 1] +=
        (at_half_the_rate ? 1.0 : 2.0) * std::norm(lines[k]) / (count * rate_Hz);
  }
}

void add_energy(const ForceEnergy& other, ForceEnergy& energy) noexcept {
  energy.total_N2_s += other.total_N2_s;
  for (std::size_t band = 0; band < kCriticalBands; ++band) {
    energy.bands_N2_s[band] += other.bands_N2_s[band];
  }
}

}  // namespace

std::span<const double> critical_band_borders_Hz() noexcept { return kBorders_Hz; }

double ForceDifference::rms_N(const ForceEnergy& energy) const noexcept {
  return duration_s > 0.0 ? std::sqrt(energy.total_N2_s / duration_s) : 0.0;
}

void ForceDifference::add(const ForceDifference& other) noexcept {
  samples += other.samples;
  duration_s += other.duration_s;
  add_energy(other.recorded, recorded);
  add_energy(other.compared, compared);
  add_energy(other.difference, difference);
  largest_N = std::max(largest_N, other.largest_N);
}

ForceDifference force_difference(const ForceSamples& recorded, const ForceSamples& compared,
                                 double rate_Hz) {
  if (!(rate_Hz > 0.0)) {
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
  }
  const std::size_t count = recorded.x_N.size();
  for (const auto& other_N :
       {recorded.y_N, recorded.z_N, compared.x_N, compared.y_N, compared.z_N}) {
    if (other_N.size() == count) continue;
    throw std::invalid_argument("the components of the forces have " + std::to_string(count) +
                                " and " + std::to_string(other_N.size()) +
                                " samples; they must have the same number");
  }
  ForceDifference result{.samples = count, .duration_s = static_cast<double>(count) / rate_Hz};
  if (count == 0) return result;
  std::vector<double> squares_N2(count);
  std::vector<double> difference_N(count);
  for (const auto& [recorded_N, compared_N] :
       {std::pair{recorded.x_N, compared.x_N}, std::pair{recorded.y_N, compared.y_N},
        std::pair{recorded.z_N, compared.z_N}}) {
    for (std::size_t i = 0; i < count; ++i) {
      difference_N[i] = compared_N[i] - recorded_N[i];
      squares_N2[i] += difference_N[i] * difference_N[i];
    }
    add_energy(recorded_N, rate_Hz, result.recorded);
    add_energy(compared_N, rate_Hz, result.compared);
    add_energy(difference_N, rate_Hz, result.difference);
  }
  result.largest_N = std::sqrt(*std::max_element(squares_N2.begin(), squares_N2.end()));
  return result;
}

}  // namespace asperity
