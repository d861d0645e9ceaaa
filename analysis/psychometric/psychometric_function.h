// Psychometric functions: the proportion of correct responses as a function of the level of a stimulus.

#pragma once

namespace asperity {

/// ψ(x) = γ + (1 − γ − λ)·F(x; α, β), with
///
///   logistic  F = 1/(1 + e^{−β(x−α)})
///   normal    F = Φ(β(x − α))
///   gumbel    F = 1 − exp(−10^{β(x−α)})   for a logarithmic x
///   weibull   F = 1 − exp(−(x/α)^β)       for x ≥ 0, α > 0
///
/// α has the unit of the level x; β has its inverse, and no unit for a weibull.
enum class PsychometricShape { logistic, normal, gumbel, weibull };

struct PsychometricFunction {
  PsychometricShape shape = PsychometricShape::logistic;
  double alpha = 0.0;
  double beta = 1.0;
  double gamma = 0.0;   ///< guess rate: the proportion of correct responses without a stimulus
  double lambda = 0.0;  ///< lapse rate: the proportion of incorrect ones at the strongest

  double value(double x) const;
  double slope(double x) const;  ///< dψ/dx
  /// The x of a performance; not finite unless γ < performance < 1 − λ.
  double inverse(double performance) const;
};

/// F as a function of t = β(x − α), or β·ln(x/α) for a weibull.
struct StandardCurve {
  double F = 0.0;
  double Q = 1.0;   ///< 1 − F, computed without cancellation
  double d1 = 0.0;  ///< dF/dt
  double d2 = 0.0;  ///< d²F/dt²
};
StandardCurve standard_curve(PsychometricShape shape, double t);
/// t(F), the inverse: infinite at 0 and 1, NaN outside of [0, 1].
double standard_quantile(PsychometricShape shape, double F);
/// t of a level: −∞ at x = 0 of a weibull.
double standard_argument(const PsychometricFunction& f, double x);

bool is_weibull(PsychometricShape shape);

}  // namespace asperity
