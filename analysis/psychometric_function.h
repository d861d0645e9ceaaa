// Psychometric functions: how performance grows with a stimulus.

#pragma once

namespace asperity {

/// ψ(x) = γ + (1 − γ − λ)·F(x; α, β), with
///
///   logistic  F = 1/(1 + e^{−β(x−α)})
///   normal    F = Φ(β(x − α))
///   gumbel    F = 1 − exp(−10^{β(x−α)})   for a logarithmic x
///   weibull   F = 1 − exp(−(x/α)^β)       for x ≥ 0, α > 0
enum class PsychometricShape { logistic, normal, gumbel, weibull };

struct PsychometricFunction {
  PsychometricShape shape = PsychometricShape::logistic;
  double alpha = 0.0;
  double beta = 1.0;
  double gamma = 0.0;   ///< share of right answers without any stimulus
  double lambda = 0.0;  ///< lapses: share of wrong ones with the strongest

  double value(double x) const;
  double slope(double x) const;  ///< dψ/dx
  /// The x of a performance; not finite unless γ < performance < 1 − λ.
  double inverse(double performance) const;
};

/// F by t = β(x − α), or β·ln(x/α), with its complement and its derivatives.
struct StandardCurve {
  double F = 0.0;
  double Q = 1.0;  ///< 1 − F, with its own digits
  double d1 = 0.0;
  double d2 = 0.0;
};
StandardCurve standard_curve(PsychometricShape shape, double t);
/// t(F), the inverse: infinite at 0 and 1, NaN beyond.
double standard_quantile(PsychometricShape shape, double F);
/// t of a level: −∞ at x = 0 of a weibull.
double standard_argument(const PsychometricFunction& f, double x);

bool is_weibull(PsychometricShape shape);

}  // namespace asperity
