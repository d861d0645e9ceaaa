// Line spectral frequencies: there and back, and the stability of their means.

#include "analysis/signals/line_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "analysis/signals/autoregression.h"

namespace asperity {
namespace {

/// A stationary model: covariances of a spectrum that is positive, by reflection coefficients drawn within ±`largest`.
std::vector<double> drawn_model(std::size_t order, double largest, Random& random) {
  std::vector<double> a{};
  for (std::size_t k = 0; k < order; ++k) {
    const double reflection = largest * (2.0 * random.uniform() - 1.0);
    std::vector<double> next(k + 1, reflection);
    for (std::size_t j = 0; j < k; ++j) next[j] = a[j] - reflection * a[k - 1 - j];
    a = next;
  }
  return a;
}

std::vector<double> coefficients_from(const std::vector<double>& frequencies_rad) {
  std::vector<double> coefficients(frequencies_rad.size());
  coefficients_of_lines(frequencies_rad, coefficients);
  return coefficients;
}

// White noise: A = 1, P = 1 + z⁻⁽ᵖ⁺¹⁾, Q = 1 − z⁻⁽ᵖ⁺¹⁾, zeros at i·π/(p + 1). One pole a: P = (1 − a·z⁻¹) + z⁻²·(1 − a·z),
// cos w = a.
TEST(LineSpectrum, AreThoseOfWhiteNoiseAndOfOnePole) {
  for (const std::size_t order : {1U, 2U, 7U, 20U}) {
    const auto frequencies_rad = line_spectral_frequencies(std::vector<double>(order, 0.0));
    for (std::size_t i = 0; i < order; ++i) {
      EXPECT_NEAR(frequencies_rad[i],
                  std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(order + 1),
                  1e-13);
    }
  }
  EXPECT_NEAR(line_spectral_frequencies(std::vector<double>{0.6}).front(), std::acos(0.6), 1e-13);
}

TEST(LineSpectrum, GiveTheCoefficientsBack) {
  Random random(3);
  double coefficients_error = 0.0;
  double frequencies_error = 0.0;
  for (int draw = 0; draw < 400; ++draw) {
    const std::vector<double> a = drawn_model(1 + draw % 20, 0.9, random);
    const std::vector<double> w = line_spectral_frequencies(a);
    const std::vector<double> again = coefficients_from(w);
    const std::vector<double> w_again = line_spectral_frequencies(again);
    for (std::size_t i = 0; i < a.size(); ++i) {
      coefficients_error = std::max(coefficients_error, std::abs(a[i] - again[i]));
      frequencies_error = std::max(frequencies_error, std::abs(w[i] - w_again[i]));
    }
  }
  EXPECT_LT(coefficients_error, 1e-10);
  EXPECT_LT(frequencies_error, 1e-10);
}

// Two poles of radius r at ±θ, closer to the circle than a coarse grid resolves: cos w_1 − cos w_2 = 1 − r², with the mean
// r·cos θ.
TEST(LineSpectrum, SeparatesTheLinesOfASharpPeak) {
  const double radius = 0.9999;
  const std::vector<double> a{2.0 * radius * std::cos(0.7), -radius * radius};
  const std::vector<double> w = line_spectral_frequencies(a);
  EXPECT_NEAR(std::cos(w[0]) - std::cos(w[1]), 1.0 - radius * radius, 1e-12);
  EXPECT_NEAR(0.5 * (std::cos(w[0]) + std::cos(w[1])), radius * std::cos(0.7), 1e-12);
  EXPECT_NEAR(coefficients_from(w)[0], a[0], 1e-12);
  EXPECT_NEAR(coefficients_from(w)[1], a[1], 1e-12);
}

// 10⁵ mixtures with weights that sum to 1, of models near instability. Mixtures of the coefficients fail.
TEST(LineSpectrum, OfEveryMixtureBelongToAStationaryModel) {
  constexpr std::size_t kOrder = 12;
  Random random(11);
  std::vector<std::vector<double>> models{};
  std::vector<std::vector<double>> lines{};
  for (int i = 0; i < 40; ++i) {
    models.push_back(drawn_model(kOrder, 0.98, random));
    lines.push_back(line_spectral_frequencies(models.back()));
  }
  int unstable = 0;
  int unstable_of_coefficients = 0;
  for (int draw = 0; draw < 100'000; ++draw) {
    std::size_t which[3]{};
    for (std::size_t& one : which) one = static_cast<std::size_t>(random.below(models.size()));
    double first = random.uniform();
    double second = random.uniform();
    if (first > second) std::swap(first, second);
    const double weights[3]{first, second - first, 1.0 - second};
    std::vector<double> mixed(kOrder, 0.0);
    std::vector<double> coefficients(kOrder, 0.0);
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < kOrder; ++i) {
        mixed[i] += weights[k] * lines[which[k]][i];
        coefficients[i] += weights[k] * models[which[k]][i];
      }
    }
    if (!stationary_predictors(coefficients_from(mixed))) ++unstable;
    if (!stationary_predictors(coefficients)) ++unstable_of_coefficients;
  }
  EXPECT_EQ(unstable, 0);
  EXPECT_GT(unstable_of_coefficients, 100);
}

TEST(LineSpectrum, RefusesAModelThatIsNotStationary) {
  EXPECT_THROW(line_spectral_frequencies(std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW(line_spectral_frequencies(std::vector<double>{}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
