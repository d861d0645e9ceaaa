// Implements band-limited interpolation by a windowed sinc.

#include "analysis/signals/band_limited.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace asperity {
namespace {

// The modified Bessel function of order 0 by its series, all of whose terms are positive.
double bessel_i0(double x) {
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= x * x / (4.0 * k * k);
    sum += term;
  }
  return sum;
}

}  // namespace

BandLimitedInterpolation::BandLimitedInterpolation() {
  constexpr double kBeta = 5.0;
  for (int i = 0; i <= kReach * kPlaces; ++i) {
    const double u = static_cast<double>(i) / kPlaces;
    const double part = u / kReach;
    const double window =
        bessel_i0(kBeta * std::sqrt(std::max(0.0, 1.0 - part * part))) / bessel_i0(kBeta);
    const bool is_zero = i > 0 && i % kPlaces == 0;  // exactly, where the sine is 10⁻¹⁶
    kernel_.push_back(i == 0    ? 1.0
                      : is_zero ? 0.0
                                : window * std::sin(std::numbers::pi * u) / (std::numbers::pi * u));
  }
  kernel_.push_back(0.0);
}

double BandLimitedInterpolation::value(std::span<const double> samples, double place,
                                       double rate) const noexcept {
  const double reach = kReach / rate;
  const double last = static_cast<double>(samples.size()) - 1.0;
  const double from = std::max(0.0, std::ceil(place - reach));
  const double to = std::min(last, std::floor(place + reach));
  double sum = 0.0;
  if (!(from <= to)) return sum;
  for (auto j = static_cast<std::size_t>(from); j <= static_cast<std::size_t>(to); ++j) {
    const double u = std::min(static_cast<double>(kReach * kPlaces),
                              rate * kPlaces * std::abs(place - static_cast<double>(j)));
    const auto whole = static_cast<std::size_t>(u);
    const double part = u - static_cast<double>(whole);
    sum += samples[j] * (kernel_[whole] + part * (kernel_[whole + 1] - kernel_[whole]));
  }
  return rate * sum;
}

}  // namespace asperity
