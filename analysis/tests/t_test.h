// Student's t tests of one sample, and Welch's of two.

#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The mean of independent numbers against `null_mean`: t = (mean − null)/(sd/√n), df = n − 1.
/// What needs a spread is absent where there is none: for a single number, and where all are equal
/// but for rounding (`sd` is then 0), because no t exists for them.
struct OneSampleT {
  std::size_t n = 0;
  double mean = 0.0;
  std::optional<double> sd{};  ///< √(Σ(x − mean)²/(n − 1)); absent for a single number
  struct Test {
    double standard_error = 0.0;
    double t = 0.0;
    double df = 0.0;
    double p = 0.0;  ///< two-sided
    ConfidenceInterval interval{};
  };
  std::optional<Test> test{};
};

struct OneSampleQuestion {
  double null_mean = 0.0;
  double confidence = 0.95;
};

/// Throws std::invalid_argument for no numbers and for numbers that are not finite.
OneSampleT one_sample_t(std::span<const double> sample, const OneSampleQuestion& question = {});

/// The difference of two means without the assumption of equal variances [Welch 1947]; absent where
/// a sample has fewer than two numbers or neither has any spread. `difference`: of the means, first
/// minus second, with its interval.
///
/// `d` is the difference over the pooled standard deviation, `g` = d·J with the exact
/// J = Γ(f/2)/(√(f/2)·Γ((f−1)/2)), f = n₁ + n₂ − 2 [Hedges 1981].
///
/// [Welch 1947] Welch: The generalization of Student's problem when several different population
/// variances are involved. [Hedges 1981] Hedges: Distribution theory for Glass's estimator of
/// effect size and related estimators.
struct WelchT {
  double difference = 0.0;
  double standard_error = 0.0;  ///< √(s₁²/n₁ + s₂²/n₂)
  ConfidenceInterval interval{};
  double t = 0.0;
  double df = 0.0;
  double p = 0.0;  ///< two-sided
  double d = 0.0;
  double g = 0.0;
  double bias_correction = 1.0;  ///< J
};
struct TwoSamples {
  std::span<const double> first{};
  std::span<const double> second{};
};
std::optional<WelchT> welch_t(const TwoSamples& samples, double confidence = 0.95);

}  // namespace asperity
