// Computes F, 1 − F and two derivatives of every shape without cancellation, and the quantiles.

#include "analysis/psychometric/psychometric_function.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

// F = 1 − exp(−e^s). With e = e^s and Q = exp(−e): dF/ds = e·Q and d²F/ds² = e·Q·(1 − e). For large s,
// where Q is 0 and e may be infinite, both are 0.
StandardCurve gumbel_curve(double scaled) {
  const double e = std::exp(scaled);
  StandardCurve s{.F = -std::expm1(-e), .Q = std::exp(-e)};
  if (s.Q > 0.0) {
    s.d1 = e * s.Q;
    s.d2 = s.d1 * (1.0 - e);
  }
  return s;
}

}  // namespace

StandardCurve standard_curve(PsychometricShape shape, double t) {
  switch (shape) {
    case PsychometricShape::logistic: {
      // F′ = F·Q and F″ = F·Q·(Q − F). By e^{−|t|} neither F nor Q cancels.
      const double e = std::exp(-std::abs(t));
      const double big = 1.0 / (1.0 + e);
      const double small = e / (1.0 + e);
      StandardCurve s{.F = t >= 0.0 ? big : small, .Q = t >= 0.0 ? small : big, .d1 = big * small};
      s.d2 = s.d1 * (s.Q - s.F);
      return s;
    }
    case PsychometricShape::normal: {  // F′ = φ(t) and F″ = −t·φ(t), 0 at infinity
      StandardCurve s{.F = 0.5 * std::erfc(-t / std::numbers::sqrt2),
                      .Q = 0.5 * std::erfc(t / std::numbers::sqrt2),
                      .d1 = std::exp(-0.5 * t * t) / std::sqrt(2.0 * std::numbers::pi)};
      s.d2 = s.d1 > 0.0 ? -t * s.d1 : 0.0;
      return s;
    }
    case PsychometricShape::gumbel: {  // 10^t = e^s with s = t·ln 10
      StandardCurve s = gumbel_curve(std::numbers::ln10 * t);
      s.d1 *= std::numbers::ln10;
      s.d2 *= std::numbers::ln10 * std::numbers::ln10;
      return s;
    }
    case PsychometricShape::weibull:
      return gumbel_curve(t);
  }
  throw std::invalid_argument(
      "shape is not a PsychometricShape; it must be logistic, normal, gumbel or weibull");
}

double standard_quantile(PsychometricShape shape, double F) {
  if (!(F > 0.0 && F < 1.0)) {
    using Limits = std::numeric_limits<double>;
    return F == 0.0 ? -Limits::infinity() : (F == 1.0 ? Limits::infinity() : Limits::quiet_NaN());
  }
  switch (shape) {
    case PsychometricShape::logistic:
      return std::log(F / (1.0 - F));
    case PsychometricShape::normal:
      return normal_quantile(F);
    case PsychometricShape::gumbel:
      return std::log10(-std::log1p(-F));
    case PsychometricShape::weibull:
      return std::log(-std::log1p(-F));
  }
  throw std::invalid_argument(
      "shape is not a PsychometricShape; it must be logistic, normal, gumbel or weibull");
}

bool is_weibull(PsychometricShape shape) { return shape == PsychometricShape::weibull; }

double standard_argument(const PsychometricFunction& f, double x) {
  return is_weibull(f.shape) ? f.beta * std::log(x / f.alpha) : f.beta * (x - f.alpha);
}

double PsychometricFunction::value(double x) const {
  return gamma + (1.0 - gamma - lambda) * standard_curve(shape, standard_argument(*this, x)).F;
}

double PsychometricFunction::slope(double x) const {
  const double dt_dx = is_weibull(shape) ? beta / x : beta;
  return (1.0 - gamma - lambda) * standard_curve(shape, standard_argument(*this, x)).d1 * dt_dx;
}

double PsychometricFunction::inverse(double performance) const {
  const double t = standard_quantile(shape, (performance - gamma) / (1.0 - gamma - lambda));
  return is_weibull(shape) ? alpha * std::exp(t / beta) : alpha + t / beta;
}

}  // namespace asperity
