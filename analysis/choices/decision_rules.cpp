// Forward functions in closed form or by Gauss–Kronrod, their inverses by TOMS 748.

#include "analysis/choices/decision_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kSqrt2 = std::numbers::sqrt2;
constexpr double kGreatestSensitivity = 25.0;  // beyond it every proportion is 1 to all digits

bool has_extreme_rate(const DetectionRates& rates) {
  const auto is_inside = [](double p) { return p > 0.0 && p < 1.0; };
  return !is_inside(rates.hit) || !is_inside(rates.false_alarm);
}

/// The root of an increasing function of d′ that is at most 0 at 0; ∞ where it is never above 0.
template <class Function>
double sensitivity_where(const Function& error) {
  const double at_zero = error(0.0);
  if (at_zero >= 0.0) return 0.0;
  const double at_end = error(kGreatestSensitivity);
  if (at_end <= 0.0) return std::numeric_limits<double>::infinity();
  std::uintmax_t iterations = 200;
  const auto [below, above] =
      boost::math::tools::toms748_solve(error, 0.0, kGreatestSensitivity, at_zero, at_end,
                                        boost::math::tools::eps_tolerance<double>(50), iterations);
  return below + 0.5 * (above - below);
}

/// A proportion correct without bias as a function of d′.
struct UnbiasedRule {
  double (*proportion)(double dprime, double scale) = nullptr;
  double scale = 2.0;
};

double proportion_same_different(double dprime, double scale) {
  const double above = normal_below(dprime / scale);
  return above * above + (1.0 - above) * (1.0 - above);
}

double proportion_abx(double dprime, double scale) {
  return normal_below(dprime / kSqrt2) * normal_below(dprime / scale) +
         normal_below(-dprime / kSqrt2) * normal_below(-dprime / scale);
}

/// p = Φ(½·(z(H) − z(F))), d′ from p. Var p = (φ(½·(z(H) − z(F)))/2)²·Var(z(H) − z(F)).
std::optional<RuleSensitivity> without_bias(const DetectionRates& rates, const UnbiasedRule& rule) {
  const std::optional<Sensitivity> difference = yes_no_sensitivity(rates);
  if (!difference) return std::nullopt;
  const double p = normal_below(0.5 * difference->dprime);
  if (p <= 0.5) return RuleSensitivity{};
  const auto of = [&rule](double dprime) { return rule.proportion(dprime, rule.scale); };
  const double dprime = sensitivity_where([&](double d) { return of(d) - p; });
  constexpr double kStep = 1e-5;
  const double slope = (of(dprime + kStep) - of(dprime - kStep)) / (2.0 * kStep);
  RuleSensitivity found{.dprime = dprime};
  if (slope > 0.0) {
    found.standard_error =
        0.5 * normal_density(0.5 * difference->dprime) * difference->standard_error / slope;
  }
  return found;
}

double hit_rate_by_difference(double dprime, double k) {
  return normal_below((dprime - k) / kSqrt2) + normal_below((-dprime - k) / kSqrt2);
}

/// The implicit derivatives of d′: with A = ∂H/∂d′ and F ↦ k, ∂d′/∂H = 1/A and ∂d′/∂F = −(∂H/∂k)·(dk/dF)/A.
std::optional<RuleSensitivity> by_difference(const DetectionRates& rates) {
  if (has_extreme_rate(rates)) return std::nullopt;
  if (rates.hit <= rates.false_alarm) return RuleSensitivity{};
  const double k = same_different_criterion(rates.false_alarm);
  const double dprime =
      sensitivity_where([&](double d) { return hit_rate_by_difference(d, k) - rates.hit; });
  const double near = normal_density((dprime - k) / kSqrt2) / kSqrt2;
  const double far = normal_density((-dprime - k) / kSqrt2) / kSqrt2;
  const double by_hit = 1.0 / (near - far);
  const double k_by_false =
      -kSqrt2 / (2.0 * normal_density(normal_quantile(0.5 * rates.false_alarm)));
  const double by_false = (near + far) * k_by_false * by_hit;
  const auto variance = [](double p, double n) { return p * (1.0 - p) / n; };
  RuleSensitivity found{.dprime = dprime};
  if (near > far) {
    found.standard_error =
        std::sqrt(by_hit * by_hit * variance(rates.hit, rates.signal_trials) +
                  by_false * by_false * variance(rates.false_alarm, rates.noise_trials));
  }
  return found;
}

template <class Integrand>
double integral_from(double low, double high, const Integrand& integrand) {
  constexpr unsigned kDepthOfRule = 8;
  constexpr double kPrecisionOfRule = 1e-13;
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      integrand, low, high, kDepthOfRule, kPrecisionOfRule);
}

constexpr double kReachOfDensity = 12.0;  // φ(12) is 2·10⁻³²

double oddity_by_difference(double dprime) {
  const double shift = dprime * std::sqrt(2.0 / 3.0);
  return 2.0 * integral_from(0.0, kReachOfDensity, [shift](double z) {
           const double spread = z * std::numbers::sqrt3;
           return (normal_below(shift - spread) + normal_below(-shift - spread)) *
                  normal_density(z);
         });
}

double oddity_by_likelihood(double dprime) {
  const double half = 0.5 * dprime;
  const auto below = [half](double y) {
    const double others = normal_below(y + half);
    const double same_side = normal_below(half);
    const double past = 1.0 - same_side;
    // The others are both below min(y, 0), or both above max(y, 0).
    const double squares = y < 0.0 ? others * others + past * past
                                   : same_side * same_side + (1.0 - others) * (1.0 - others);
    return squares * normal_density(y - half);
  };
  return integral_from(std::min(half - kReachOfDensity, -1.0), 0.0, below) +
         integral_from(0.0, half + kReachOfDensity, below);
}

}  // namespace

double same_different_criterion(double false_alarm) {
  return -kSqrt2 * normal_quantile(0.5 * false_alarm);
}

double same_different_hit_rate(double dprime, double false_alarm, DecisionRule rule) {
  if (rule == DecisionRule::differencing) {
    return hit_rate_by_difference(dprime, same_different_criterion(false_alarm));
  }
  const double p = proportion_same_different(dprime, 2.0);
  return normal_below(2.0 * normal_quantile(p) + normal_quantile(false_alarm));
}

std::optional<RuleSensitivity> same_different_sensitivity(const DetectionRates& rates,
                                                          DecisionRule rule) {
  if (rule == DecisionRule::differencing) return by_difference(rates);
  return without_bias(rates, {.proportion = proportion_same_different, .scale = 2.0});
}

std::optional<RuleSensitivity> abx_sensitivity(const DetectionRates& rates, DecisionRule rule) {
  return without_bias(rates, {.proportion = proportion_abx,
                              .scale = rule == DecisionRule::differencing ? std::sqrt(6.0) : 2.0});
}

double Oddity::proportion(double dprime) const {
  const double distance = std::abs(dprime);
  return rule == DecisionRule::differencing ? oddity_by_difference(distance)
                                            : oddity_by_likelihood(distance);
}

double Oddity::slope(double dprime) const {
  constexpr double kStep = 1e-5;
  return (proportion(dprime + kStep) - proportion(dprime - kStep)) / (2.0 * kStep);
}

double Oddity::dprime(double asked) const {
  if (!(asked >= 0.0 && asked <= 1.0)) {
    throw std::invalid_argument("proportion is " + number_text(asked) +
                                "; it must lie between 0 and 1");
  }
  if (asked <= 1.0 / 3.0) return 0.0;
  if (asked == 1.0) return std::numeric_limits<double>::infinity();
  return sensitivity_where([&](double d) { return proportion(d) - asked; });
}

}  // namespace asperity
