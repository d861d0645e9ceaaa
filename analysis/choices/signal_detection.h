// Sensitivity and bias in detection and in the choice between two, from hits and false alarms.

#pragma once

#include <optional>

#include "analysis/numbers/proportion.h"

namespace asperity {

/// The trials of a task with two responses, "yes" and "no": `hits` are the responses "yes". In a choice between two, one of
/// the two orders takes the place of the signal, and one response that of "yes".
struct DetectionCounts {
  HitCount signal{};  ///< trials with a signal: hits
  HitCount noise{};   ///< trials without: false alarms
};

/// The proportions of "yes", with the numbers of trials from which their variances follow.
struct DetectionRates {
  double hit = 0.0;
  double false_alarm = 0.0;
  double signal_trials = 0.0;
  double noise_trials = 0.0;
};

/// Errors, as of `loglinear_rates`: std::invalid_argument for no trials and for more hits than trials.
DetectionRates observed_rates(const DetectionCounts& counts);

/// (hits + ½)/(trials + 1), in all conditions and not only where a proportion is 0 or 1 [Hautus 1995]. Sensitivities are
/// then finite, and their bias is small and towards 0.
///
/// [Hautus 1995] Hautus: Corrections for extreme proportions and their biasing effects on estimated values of d′.
DetectionRates loglinear_rates(const DetectionCounts& counts);

/// The observer responds "yes" where an impression x exceeds a criterion. x is normal with standard deviation 1, and its
/// mean is d′/2 with a signal and −d′/2 without. H = Φ(d′/2 − c) and F = Φ(−d′/2 − c), so that with z = Φ⁻¹
///
///   d′ = z(H) − z(F),  c = −½·(z(H) + z(F)),  ln β = c·d′
///
/// [Macmillan 2005]. c = 0 is no bias; a positive c is a reluctance to say "yes". β is the likelihood ratio at the
/// criterion.
///
/// Var d′ = H(1 − H)/(n_s·φ(z(H))²) + F(1 − F)/(n_n·φ(z(F))²), by the delta method [Gourevitch 1967].
///
/// [Macmillan 2005] Macmillan, Creelman: Detection theory: a user's guide, 2nd edition.
/// [Gourevitch 1967] Gourevitch, Galanter: A significance test for one parameter isosensitivity functions.
struct Sensitivity {
  double dprime = 0.0;
  double criterion = 0.0;
  double standard_error = 0.0;  ///< of d′

  double log_beta() const { return criterion * dprime; }
};

/// Nothing where a rate is 0 or 1: d′ or c is then infinite.
std::optional<Sensitivity> yes_no_sensitivity(const DetectionRates& rates);

/// Two surfaces, one of which has the signal; H and F are the proportions of the response "first" where the signal is first
/// and where it is second. The observer responds "first" where the difference of the two impressions exceeds a criterion.
/// The difference has the standard deviation √2 and the means ±d′, so that
///
///   d′ = (z(H) − z(F))/√2,  c = −½·(z(H) + z(F))
///
/// with c in units of the difference's standard deviation; a positive c is a bias towards the second [Macmillan 2005].
/// Identity: without bias, F = 1 − H and H = Φ(d′/√2).
std::optional<Sensitivity> two_alternative_sensitivity(const DetectionRates& rates);

}  // namespace asperity
