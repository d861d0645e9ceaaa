// Implements the conversion between coefficients and line spectral frequencies.

#include "analysis/signals/line_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "analysis/signals/autoregression.h"

namespace asperity {
namespace {

double phase_at(double angle_rad, std::span<const double> reflections) {
  double phase = -angle_rad;
  for (const double k : reflections) {
    phase += 2.0 * std::atan(k * std::sin(phase) / (1.0 - k * std::cos(phase))) - angle_rad;
  }
  return phase;
}

/// cos w for 0 ≤ w ≤ π as −sin(w − π/2), by its series up to the 21st power: the next term is below 10⁻¹⁷.
double cosine(double angle_rad) noexcept {
  const double x = angle_rad - 0.5 * std::numbers::pi;
  const double square = x * x;
  double sum = -1.0 / (20.0 * 21.0);
  sum = (1.0 + square * sum) * (-1.0 / (18.0 * 19.0));
  sum = (1.0 + square * sum) * (-1.0 / (16.0 * 17.0));
  sum = (1.0 + square * sum) * (-1.0 / (14.0 * 15.0));
  sum = (1.0 + square * sum) * (-1.0 / (12.0 * 13.0));
  sum = (1.0 + square * sum) * (-1.0 / (10.0 * 11.0));
  sum = (1.0 + square * sum) * (-1.0 / (8.0 * 9.0));
  sum = (1.0 + square * sum) * (-1.0 / (6.0 * 7.0));
  sum = (1.0 + square * sum) * (-1.0 / (4.0 * 5.0));
  sum = (1.0 + square * sum) * (-1.0 / (2.0 * 3.0));
  return -x * (1.0 + square * sum);
}

/// A polynomial in z⁻¹, one place more than a model of the greatest order needs.
using Polynomial = std::array<double, kMostSpectralLines + 2>;

}  // namespace

std::vector<double> line_spectral_frequencies(std::span<const double> coefficients) {
  if (coefficients.empty()) {
    throw std::invalid_argument(
        "coefficients is empty; line spectral frequencies need at least one coefficient");
  }
  const std::optional<Predictors> predictors = stationary_predictors(coefficients);
  if (!predictors) {
    throw std::invalid_argument(
        "coefficients: a root of the model is on or outside the unit circle; line spectral "
        "frequencies need a stationary model");
  }
  std::vector<double> reflections{};
  for (std::size_t k = 1; k <= coefficients.size(); ++k) {
    reflections.push_back(predictors->coefficients[k].back());
  }
  std::vector<double> frequencies_rad{};
  for (std::size_t i = 1; i <= coefficients.size(); ++i) {
    const double wanted = -std::numbers::pi * static_cast<double>(i);
    double low = frequencies_rad.empty() ? 0.0 : frequencies_rad.back();
    double high = std::numbers::pi;
    constexpr int kHalvings = 60;  // of an interval below 4, to less than the spacing of numbers
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = 0.5 * (low + high);
      (phase_at(middle, reflections) > wanted ? low : high) = middle;
    }
    frequencies_rad.push_back(0.5 * (low + high));
  }
  return frequencies_rad;
}

void coefficients_of_lines(std::span<const double> frequencies_rad,
                           std::span<double> coefficients) noexcept {
  const std::size_t order = std::min(frequencies_rad.size(), kMostSpectralLines);
  std::array<double, kMostSpectralLines> cosines;
  for (std::size_t i = 0; i < order; ++i) cosines[i] = cosine(frequencies_rad[i]);
  // P and Q side by side: their chains of additions do not wait for each other.
  Polynomial p{1.0};
  Polynomial q{1.0};
  std::size_t degree = 0;
  for (std::size_t i = 0; i + 1 < order; i += 2) {
    const double twice_p = 2.0 * cosines[i];
    const double twice_q = 2.0 * cosines[i + 1];
    degree += 2;
    for (std::size_t j = degree; j >= 2; --j) {
      p[j] += p[j - 2] - twice_p * p[j - 1];
      q[j] += q[j - 2] - twice_q * q[j - 1];
    }
    p[1] -= twice_p;
    q[1] -= twice_q;
  }
  if (order % 2 == 0) {
    for (std::size_t j = degree + 1; j >= 1; --j) {
      p[j] += p[j - 1];
      q[j] -= q[j - 1];
    }
  } else {
    const double twice_p = 2.0 * cosines[order - 1];
    for (std::size_t j = degree + 2; j >= 2; --j) {
      p[j] += p[j - 2] - twice_p * p[j - 1];
      q[j] -= q[j - 2];
    }
    p[1] -= twice_p;
  }
  for (std::size_t j = 1; j <= order; ++j) coefficients[j - 1] = -0.5 * (p[j] + q[j]);
}

}  // namespace asperity
