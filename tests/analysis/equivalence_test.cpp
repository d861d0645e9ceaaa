// Holds equivalence and Bayes factors to numbers of a second program (mpmath, 30 digits, integrals by
// adaptive quadrature) and to what they must be.

#include "analysis/tests/equivalence.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/tests/t_test.h"

namespace asperity {
namespace {

constexpr std::array kFive{5.0, 7.0, 8.0, 6.0, 9.0};
constexpr std::array kSeven{6.0, 9.0, 7.0, 11.0, 8.0, 10.0, 7.0};

EstimatedDifference welch_difference() {
  const std::optional<WelchT> welch = welch_t({.first = kFive, .second = kSeven});
  return {.value = welch->difference, .standard_error = welch->standard_error, .df = welch->df};
}

TEST(EquivalenceTest, MakesTwoOneSidedTestsOfWelchsDifference) {
  const EquivalenceTest test =
      equivalence_test(welch_difference(), {.lower = -3.0, .upper = 3.0, .alpha = 0.05});
  EXPECT_NEAR(test.t_lower, 1.74728461721864, 1e-12);
  EXPECT_NEAR(test.t_upper, -4.36821154304661, 1e-12);
  EXPECT_NEAR(test.p_lower, 0.0564843604938138, 1e-13);
  EXPECT_NEAR(test.p_upper, 0.000804413914891888, 1e-15);
  EXPECT_EQ(test.p, test.p_lower);
  EXPECT_NEAR(test.interval.low, -3.07473095602759, 1e-12);
  EXPECT_NEAR(test.interval.high, 0.503302384599016, 1e-12);
  EXPECT_FALSE(test.equivalent);
}

TEST(EquivalenceTest, HoldsExactlyWhereTheIntervalLiesWithinTheBounds) {
  const EstimatedDifference difference = welch_difference();
  const double margin = smallest_equivalence_margin(difference);
  EXPECT_NEAR(margin, 3.07473095602759, 1e-12);
  const auto within = [&](double bound) {
    return equivalence_test(difference, {.lower = -bound, .upper = bound}).equivalent;
  };
  EXPECT_TRUE(within(margin + 1e-9));
  EXPECT_FALSE(within(margin - 1e-9));
}

TEST(EquivalenceTest, RefusesWhatIsNoQuestion) {
  const EstimatedDifference difference{.value = 0.0, .standard_error = 1.0, .df = 5.0};
  EXPECT_THROW(equivalence_test(difference, {.lower = 1.0, .upper = 1.0}), std::invalid_argument);
  EXPECT_THROW(equivalence_test(difference, {.alpha = 0.5}), std::invalid_argument);
  EXPECT_THROW(equivalence_test({.standard_error = 0.0}, {}), std::invalid_argument);
  EXPECT_THROW(smallest_equivalence_margin({.df = 0.0}), std::invalid_argument);
}

TEST(JzsBayesFactor, IsTheIntegralOverTheVarianceOfThePrior) {
  const BayesFactorQuestion question{
      .t = -1.27998027897429, .df = 10.0, .n = 35.0 / 12.0, .scale = std::numbers::sqrt2 / 2.0};
  EXPECT_NEAR(jzs_bayes_factor(question), 0.773757847439147, 1e-12);
  BayesFactorQuestion wider = question;
  wider.scale = 1.0;
  EXPECT_NEAR(jzs_bayes_factor(wider), 0.676780959674354, 1e-12);
}

TEST(JzsBayesFactor, WeighsForNoDifferenceAsWell) {
  constexpr double kScale = std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR(jzs_bayes_factor({.t = 0.0, .df = 19.0, .n = 20.0, .scale = kScale}),
              0.232326294376465, 1e-12);
  EXPECT_NEAR(jzs_bayes_factor({.t = 30.0, .df = 399.0, .n = 400.0, .scale = kScale}) / 1e100,
              3.46560685927136, 1e-10);
  EXPECT_THROW(jzs_bayes_factor({.t = std::numeric_limits<double>::infinity()}),
               std::invalid_argument);
  EXPECT_THROW(jzs_bayes_factor({.scale = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
