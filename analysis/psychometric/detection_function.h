// The psychometric function of a task with the responses "yes" and "no", by a model of signal detection.

#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"

namespace asperity {

/// How "yes" follows from the impressions: of one surface, or of a pair of surfaces by the differencing rule.
enum class DetectionTask { yes_no, same_different };

/// The probability of "yes" (in same–different "different") of an observer without lapses, given d′ and the criterion:
///
///   yes_no          Φ(d′ − k)                          F = Φ(−k)
///   same_different  Φ((d′ − k)/√2) + Φ((−d′ − k)/√2)   F = 2·Φ(−k/√2)
///
/// with F at d′ = 0. k is in units of the standard deviation of one impression (decision_rules.h).
double probability_of_yes(DetectionTask task, double dprime, double criterion);

/// d′ of a difference x from the standard is (x/α)^β [Macmillan 2005]: α is the difference with d′ = 1, the just-noticeable
/// difference by the task's decision rule, and no proportion correct, which would depend on the criterion. With lapses of a
/// known rate λ in both directions
///
///   P(yes | x) = λ + (1 − 2·λ)·probability_of_yes((x/α)^β, k)
///
/// [Macmillan 2005] Macmillan, Creelman: Detection theory: a user's guide, 2nd edition.
struct DetectionFunction {
  DetectionTask task = DetectionTask::yes_no;
  double alpha = 1.0;
  double beta = 1.0;
  double criterion = 0.0;
  double lambda = 0.0;

  double dprime(double x) const;
  double value(double x) const;
};

enum class DetectionStatus {
  ok,
  no_data,         ///< no trials with x = 0, or none with x > 0
  one_difference,  ///< one x > 0: an exponent is not identified
  all_yes,         ///< every response is "yes"
  all_no,          ///< every response is "no"
  separated,       ///< only "no" up to some difference, only "yes" beyond it: d′ is infinite
  not_increasing,  ///< "yes" is not more frequent with a difference than without
};

struct DetectionFit {
  DetectionStatus status = DetectionStatus::ok;
  /// Of `separated`: the difference of α is between these.
  std::optional<ConfidenceInterval> bracket{};
  DetectionFunction function{};  ///< where the status is ok, like all below
  bool beta_at_bound = false;
  /// Wald's interval of ln α from the observed information of all parameters, transformed to α; nothing where β is at its
  /// bound or the information is singular.
  std::optional<ConfidenceInterval> alpha{};
  double log_likelihood = 0.0;  ///< with binomial coefficients
  double deviance = 0.0;        ///< against one proportion per difference
  double deviance_df = 0.0;
};

struct DetectionModel {
  DetectionTask task = DetectionTask::yes_no;
  double lambda = 0.0;  ///< at least 0 and below ½
  double confidence = 0.95;
};

/// The limits of β: d′ grows in proportion to x for β = 1; steeper or flatter functions than these are not distinguished.
inline constexpr double kLeastTransducerSlope = 0.25;
inline constexpr double kGreatestTransducerSlope = 8.0;

/// Maximum likelihood of α, β and k. Blocks of x = 0 are the trials without a signal. Errors: std::invalid_argument for more
/// hits than trials, a negative or infinite x, and λ outside [0, ½).
DetectionFit fit_detection(std::span<const PsychometricBlock> blocks, const DetectionModel& model);

}  // namespace asperity
