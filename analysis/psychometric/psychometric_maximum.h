// The maximum of the likelihood of a psychometric function.

#pragma once

#include <limits>
#include <span>

#include "analysis/psychometric/psychometric_likelihood.h"
#include "analysis/psychometric/psychometric_starts.h"

namespace asperity {

struct CurveMaximum {
  CurveParameters at = CurveParameters::Zero();
  double value = -std::numeric_limits<double>::infinity();
};

/// Newton's method within the bounds over the parameters in `free`, from a point near the maximum. A
/// parameter at a bound stays there while the gradient points outwards; where the log likelihood is not
/// concave, the step is an ascent direction by the absolute curvatures, and it is halved until it ascends.
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
  FreeParameters free{};  ///< without the parameters at a bound
};

/// The greatest likelihood over the best starts of a grid: BOBYQA from each of them, then `climb`. A
/// parameter close to its bound is set to the bound where the likelihood is the same.
CurveSolution greatest_likelihood(const PsychometricLikelihood& data, PsychometricStarts& starts);

/// Whether an increasing function has a greater likelihood than every constant. If not, the likelihood has
/// no maximum: it grows towards that of a constant as β → 0 and α → ±∞.
bool is_increasing(const PsychometricLikelihood& data, const CurveMaximum& maximum);

/// The fit without its precision, as resampling needs it. Defined for at least two levels, whatever the
/// result of `judge`.
struct PsychometricMaximum {
  PsychometricFunction function{};
  double log_likelihood = 0.0;  ///< its supremum where the function is not increasing
  double deviance = 0.0;        ///< relative to the saturated model
  bool increases = true;  ///< `is_increasing`; otherwise `function` is the end point of the search
  bool beta_at_bound = false;
};
PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model);
/// The same result; `starts` is kept for the next data set with the same levels.
PsychometricMaximum maximise_psychometric(std::span<const PsychometricBlock> blocks,
                                          const PsychometricModel& model,
                                          PsychometricStarts& starts);

}  // namespace asperity
