// Where the likelihood of a psychometric function is greatest.

#pragma once

#include <limits>
#include <span>

#include "analysis/psychometric_likelihood.h"

namespace asperity {

struct CurveMaximum {
  CurveParameters at = CurveParameters::Zero();
  double value = -std::numeric_limits<double>::infinity();
};

/// Newton's method within the bounds over the parameters in `free`, from a point near the maximum. A
/// parameter that the gradient presses against its bound stands still; where the surface is not
/// concave the step is damped.
CurveMaximum climb(const PsychometricLikelihood& data, CurveParameters at,
                   const FreeParameters& free);

struct AtBound {
  bool beta = false;
  bool gamma = false;
  bool lambda = false;

  int count() const { return int{beta} + int{gamma} + int{lambda}; }
};

struct CurveSolution {
  CurveMaximum maximum{};
  AtBound at_bound{};
  FreeParameters free{};  ///< without what is at a bound
};

/// The greatest likelihood over all starts of a grid: BOBYQA from the best of them, then `climb`; a
/// parameter within reach of its bound is set on it where that is as likely.
CurveSolution greatest_likelihood(const PsychometricLikelihood& data);

/// Whether an increasing function is likelier than every constant one. If not, there is no likeliest
/// function: the likelihood grows towards that of a constant as β → 0 and α → ±∞.
bool is_increasing(const PsychometricLikelihood& data, const CurveMaximum& maximum);

/// As far as resampling needs it: the function alone, whatever `judge` says as long as the slope has
/// a bound (at least two levels).
struct PsychometricMaximum {
  PsychometricFunction function{};
  double log_likelihood = 0.0;  ///< its supremum where the function is not increasing
  double deviance = 0.0;        ///< against a probability of its own for each block
  bool increases = true;  ///< `is_increasing`; otherwise the function is where the search ended
  bool beta_at_bound = false;
};
PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model);

}  // namespace asperity
