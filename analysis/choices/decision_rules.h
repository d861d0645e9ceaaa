// Sensitivity in tasks in which surfaces are compared with each other: same–different, ABX and oddity, by the rule with which
// an observer decides.

#pragma once

#include <optional>

#include "analysis/choices/signal_detection.h"

namespace asperity {

/// How an observer combines the impressions of a trial, which are independent and normal with standard deviation 1, 0 on
/// average of one kind of surface and d′ of the other.
enum class DecisionRule {
  independent,  ///< each impression is classified, and the response follows from the classes: the ideal observer
  differencing,  ///< only differences of impressions are used, as where the levels change from trial to trial
};

/// d′ of a task with the responses "yes" and "no", with its standard error by the delta method from the variances of both
/// rates; nothing for a d′ of 0, at which the derivative of the rate is 0.
struct RuleSensitivity {
  double dprime = 0.0;
  std::optional<double> standard_error{};
};

/// Same–different: "yes" is "different", H its proportion where the two surfaces differ and F where they are the same.
///
///   differencing: "different" where the difference, of standard deviation √2, exceeds k on either side:
///     F = 2·Φ(−k/√2),  H = Φ((d′ − k)/√2) + Φ((−d′ − k)/√2)
///   independent, without bias p = Φ(½·(z(H) − z(F))):
///     p = Φ(d′/2)² + (1 − Φ(d′/2))²
///
/// [Macmillan 2005]. 0 where H ≤ F, nothing where a rate is 0 or 1. Identity: with d′ = 0, H = F and p = ½.
///
/// [Macmillan 2005] Macmillan, Creelman: Detection theory: a user's guide, 2nd edition.
std::optional<RuleSensitivity> same_different_sensitivity(const DetectionRates& rates,
                                                          DecisionRule rule);
/// The criterion k of the rule `differencing` for a proportion of false alarms between 0 and 1.
double same_different_criterion(double false_alarm);
/// H of an observer of the rule with this d′ and this proportion of false alarms. By the independent rule the bias is
/// that of z(H) − z(F) at a constant p, as `same_different_sensitivity` assumes.
double same_different_hit_rate(double dprime, double false_alarm, DecisionRule rule);

/// ABX: which of A and B is X. H and F are the proportions of one response where it is correct and where it is not;
/// without bias p = Φ(½·(z(H) − z(F))) and [Macmillan 2005]
///
///   p = Φ(d′/√2)·Φ(d′/s) + Φ(−d′/√2)·Φ(−d′/s),  s = √6 (differencing) or 2 (independent).
///
/// 0 where p ≤ ½, nothing where a rate is 0 or 1.
std::optional<RuleSensitivity> abx_sensitivity(const DetectionRates& rates, DecisionRule rule);

/// Oddity: three surfaces, of which two are the same; the third is to be found.
///
///   differencing [Frijters 1979]: the surface whose impression is farthest from the mean of all three,
///     P(d′) = 2·∫₀^∞ (Φ(−z√3 + d′√⅔) + Φ(−z√3 − d′√⅔))·φ(z) dz
///   independent [Versfeld 1996]: the odd surface may be of either kind. With impressions y about the midpoint of both
///     kinds, surface i has the greatest likelihood where |y_i − y_j − y_k| is greatest. As (y_i − y_j − y_k)² −
///     (y_j − y_i − y_k)² = −4·(y_i − y_j)·y_k, this is the case where the other two are both below min(y_i, 0) or both
///     above max(y_i, 0):
///     P(d′) = ∫ φ(y − d′/2)·(Φ(min(y, 0) + d′/2)² + (1 − Φ(max(y, 0) + d′/2))²) dy
///
/// Both are ⅓ for d′ = 0, the smallest value; P does not depend on the sign of d′.
///
/// [Frijters 1979] Frijters: Variations of the triangular method and the relationship of its unidimensional probabilistic
/// models to three-alternative forced-choice signal detection theory models.
/// [Versfeld 1996] Versfeld, Dai, Green: The optimum decision rules for the oddity task.
struct Oddity {
  DecisionRule rule = DecisionRule::differencing;

  double proportion(double dprime) const;
  /// dP/dd′, by a central difference of the integral.
  double slope(double dprime) const;
  /// 0 for proportions up to ⅓, ∞ for 1. Errors: std::invalid_argument outside [0, 1].
  double dprime(double proportion) const;
};

}  // namespace asperity
