// Holds curves and peaks to participants whose numbers were made from known ones.

#include "analysis/scales/magnitude.h"

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

TEST(CurveType, IsToldByTheSlopesAtBothEnds) {
  const TestedRange range{.lowest_x = -1.0, .highest_x = 1.0};
  const auto hump_at = [](double peak) { return Quadratic{.b = 2.0 * peak, .c = -1.0}; };
  EXPECT_EQ(curve_type(hump_at(0.5), range), CurveType::inverted_u);
  EXPECT_EQ(curve_type(hump_at(-2.0), range), CurveType::descending);
  EXPECT_EQ(curve_type(hump_at(2.0), range), CurveType::other);
  EXPECT_EQ(curve_type({.b = -1.0}, range), CurveType::descending);
  EXPECT_EQ(curve_type({.b = 0.0, .c = 1.0}, range), CurveType::other);
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

// R 4.2: lm(y ~ x + I(x^2)), the delta method with vcov(), and the roots of Fieller's quadratic with
// qt(.975, 2).
TEST(CurveFit, PlacesThePeakOfACurveThatNobodyRepeated) {
  constexpr std::array kX{0.0, 0.25, 0.5, 0.75, 1.0};
  constexpr std::array kY{0.1, 0.42, 0.5, 0.45, 0.12};
  const CurveFit fit = curve_fit({.x = kX, .log10 = kY});
  EXPECT_NEAR(fit.curve.a, 0.0997142857143, 1e-12);
  EXPECT_NEAR(fit.curve.b, 1.66228571429, 1e-11);
  EXPECT_NEAR(fit.curve.c, -1.63428571429, 1e-11);
  EXPECT_NEAR(fit.r2, 0.992377340969, 1e-11);
  ASSERT_TRUE(fit.peak && fit.fieller);
  EXPECT_EQ(fit.status, PeakStatus::inside);
  EXPECT_NEAR(fit.peak->x, 0.508566433566, 1e-11);
  EXPECT_NEAR(fit.peak->height, 0.522405644356, 1e-11);
  EXPECT_NEAR(fit.peak->standard_error.value(), 0.00919662216092, 1e-11);
  EXPECT_NEAR(fit.fieller->low, 0.468157612055, 1e-11);
  EXPECT_NEAR(fit.fieller->high, 0.550291387388, 1e-11);
}

TEST(CurveFit, SaysWhereThereIsNoPeakAndRefusesTooFewPoints) {
  constexpr std::array kX{0.0, 1.0, 2.0};
  constexpr std::array kBowl{1.0, 0.0, 1.0};
  EXPECT_EQ(curve_fit({.x = kX, .log10 = kBowl}).status, PeakStatus::no_maximum);
  constexpr std::array kRising{0.0, 3.0, 5.0};  // its parabola turns at x = 3.5
  const CurveFit rising = curve_fit({.x = kX, .log10 = kRising});
  EXPECT_EQ(rising.status, PeakStatus::outside_range);
  EXPECT_FALSE(rising.peak || rising.fieller);
  EXPECT_THROW(curve_fit({.x = std::span(kX).first(2), .log10 = std::span(kBowl).first(2)}),
               std::invalid_argument);
  EXPECT_THROW(curve_fit({.x = kX, .log10 = std::span(kBowl).first(2)}), std::invalid_argument);
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
