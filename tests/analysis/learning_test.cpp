// Holds the slope over trials to the line of least squares.

#include "analysis/tests/learning.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(SlopeOverTrials, IsThatOfTheLeastSquaresLine) {
  // Trials 1, 2, 4 about their mean 7/3: −4/3, −1/3, 5/3, whose squares add up to 42/9.
  const auto slope = slope_over_trials(std::vector<TrialResult>{
      {.trial = 1.0, .result = 3.0}, {.trial = 2.0, .result = 1.0}, {.trial = 4.0, .result = 1.0}});
  // Σ(t − 7/3)(r − 5/3) = −4/3·4/3 − 1/3·(−2/3) + 5/3·(−2/3) = −24/9.
  EXPECT_NEAR(slope.value(), -24.0 / 42.0, 1e-14);
}

TEST(SlopeOverTrials, NeedsTwoDifferentTrials) {
  EXPECT_FALSE(slope_over_trials(std::vector<TrialResult>{}));
  EXPECT_FALSE(slope_over_trials(std::vector<TrialResult>{{.trial = 7.0, .result = 3.0}}));
  EXPECT_FALSE(slope_over_trials(std::vector<TrialResult>(3, {.trial = 0.7, .result = 3.0})));
  EXPECT_THROW(slope_over_trials(std::vector<TrialResult>{{.trial = 1.0, .result = std::nan("")}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
