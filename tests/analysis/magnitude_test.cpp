// Holds curves and peaks to participants whose numbers were made from known ones.

#include "analysis/magnitude.h"

#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

const Eigen::VectorXd kLevels = Eigen::VectorXd::LinSpaced(5, -1.0, 1.0);

// −(x − peak)², one row per peak.
MagnitudeCurves humps(const std::vector<double>& peaks) {
  MagnitudeCurves curves{.x = kLevels};
  curves.log10.resize(static_cast<Eigen::Index>(peaks.size()), kLevels.size());
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    curves.log10.row(static_cast<Eigen::Index>(i)) = -(kLevels.array() - peaks[i]).square();
  }
  return curves;
}

TEST(QuadraticFit, FindsThePeakThatIsThere) {
  const QuadraticFit fit = quadratic_fit(humps({0.1, 0.2, 0.3}));
  ASSERT_EQ(fit.status, PeakStatus::inside);
  EXPECT_NEAR(fit.peak->x, 0.2, 1e-12);
  // c is −1 for everybody, so the peak is b/2 and its error that of a mean: 0.1/√3.
  EXPECT_NEAR(fit.peak->standard_error, 0.1 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(fit.fieller->low, fit.peak->interval.low, 1e-9);
  EXPECT_EQ(fit.concave_participants, 3U);
}

TEST(QuadraticFit, SaysWhereThereIsNoPeak) {
  EXPECT_EQ(quadratic_fit(humps({2.0, 2.5, 3.0})).status, PeakStatus::outside_range);
  MagnitudeCurves bowls = humps({0.1, 0.2, 0.3});
  bowls.log10 *= -1.0;
  const QuadraticFit fit = quadratic_fit(bowls);
  EXPECT_EQ(fit.status, PeakStatus::no_maximum);
  EXPECT_FALSE(fit.fieller);
}

// Humps for two and a bowl for the third: on the mean a hump, but not clearly.
TEST(QuadraticFit, HasNoFiellerIntervalWhereTheBendIsUncertain) {
  MagnitudeCurves curves = humps({0.1, 0.2, 0.3});
  curves.log10.row(2) *= -1.0;
  const QuadraticFit fit = quadratic_fit(curves);
  EXPECT_EQ(fit.status, PeakStatus::inside);
  EXPECT_FALSE(fit.fieller);
}

TEST(QuadraticFit, RefusesTooFewLevelsAndOneParticipant) {
  MagnitudeCurves curves{.log10 = Eigen::MatrixXd::Ones(3, 2), .x = Eigen::Vector2d(0, 1)};
  EXPECT_THROW(quadratic_fit(curves), std::invalid_argument);
  EXPECT_THROW(quadratic_fit(humps({0.1})), std::invalid_argument);
}

TEST(PeakShift, ComparesWithinParticipants) {
  const QuadraticFit near = quadratic_fit(humps({0.1, 0.4, 0.3}));
  const QuadraticFit far = quadratic_fit(humps({0.3, 0.6, 0.51}));
  const std::optional<PeakShift> shift = peak_shift({.first = far, .second = near});
  EXPECT_NEAR(shift->difference, 0.61 / 3.0, 1e-12);
  // Everybody's own peak cancels: the differences 0.2, 0.2 and 0.21 are left.
  EXPECT_NEAR(shift->standard_error, 0.01 / 3.0, 1e-9);
}

// Everybody once is the estimate itself, half of a tie: no bias.
TEST(PeakBootstrap, OfTheSameParticipantsHasNoBias) {
  const QuadraticFit fit = quadratic_fit(humps({0.1, 0.25, 0.3}));
  const std::vector<std::vector<std::size_t>> resamples{{0, 1, 2}, {2, 0, 1}, {0, 0, 0}, {2, 2, 2}};
  const std::optional<PeakBootstrap> boot = bootstrap_peak(fit, resamples);
  ASSERT_TRUE(boot && boot->bias_corrected);
  EXPECT_NEAR(boot->bias_corrected->z0, 0.0, 1e-12);
  EXPECT_EQ(boot->valid, 4U);
  EXPECT_THROW(bootstrap_peak(fit, std::vector<std::vector<std::size_t>>{{0, 1, 3}}),
               std::invalid_argument);
}

TEST(ZeroRule, LeavesZerosOutOrHalvesTheLeast) {
  const std::array kEstimates{MagnitudeEstimate{.estimate = 0.0},
                              MagnitudeEstimate{.estimate = 4.0},
                              MagnitudeEstimate{.participant = 1, .estimate = 1.0}};
  EXPECT_EQ(without_zeros(kEstimates, ZeroRule::exclude).size(), 2U);
  EXPECT_EQ(without_zeros(kEstimates, ZeroRule::half_of_least).front().estimate, 2.0);
  const std::array kNone{MagnitudeEstimate{.estimate = 0.0}};
  EXPECT_THROW(without_zeros(kNone, ZeroRule::half_of_least), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
