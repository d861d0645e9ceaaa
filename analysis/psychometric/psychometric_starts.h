// The points from which the maximum of the likelihood of a psychometric function is searched.

#pragma once

#include <vector>

#include "analysis/psychometric/psychometric_likelihood.h"

namespace asperity {

/// The best points of a grid over α, β, γ and λ that lie apart: with guessing the likelihood has several maxima.
///
/// The probabilities at the points of the grid depend on the model and on the levels, but not on the counts. They are kept
/// until data with another model or other levels come: a bootstrap with 400 resamples computes them once.
///
/// Threads: one at a time.
class PsychometricStarts final {
 public:
  std::vector<CurveParameters> best(const PsychometricLikelihood& data);

 private:
  struct Point {
    CurveParameters at = CurveParameters::Zero();
    double place = 0.0;  ///< of α among the levels
  };

  void make_grid(const PsychometricLikelihood& data);

  std::vector<double> key_{};  ///< all that the grid and its probabilities depend on
  std::vector<Point> points_{};
  std::vector<LogProbabilities> of_blocks_{};  ///< by point, then by block
};

}  // namespace asperity
