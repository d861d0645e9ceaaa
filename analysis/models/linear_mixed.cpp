// The criterion as a function of λ alone, from sums within participants.

#include "analysis/models/linear_mixed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Cholesky>
#include <boost/math/tools/roots.hpp>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/matrix_place.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

// Numbers that differ by no more than this part of the greatest are equal but for rounding. The mean of many does not take
// part: its own rounding grows with their number.
constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();

bool are_equal_numbers(const Eigen::Ref<const Eigen::VectorXd>& numbers) {
  return numbers.maxCoeff() - numbers.minCoeff() <= kRounding * numbers.cwiseAbs().maxCoeff();
}

// Sums that determine the criterion for every λ. With n_i rows of participant i, M⁻¹ is in the rows of a participant
// I − w·1·1', w = λ/(1 + λ·n_i): products with M⁻¹ need the products of all rows and the sums of each participant.
struct ParticipantSums {
  Eigen::MatrixXd xx{};     // X'X
  Eigen::VectorXd xy{};     // X'y
  double yy = 0.0;          // y'y
  Eigen::MatrixXd x{};      // Z'X: participants × effects
  Eigen::VectorXd y{};      // Z'y
  Eigen::VectorXd count{};  // n_i
  double rows = 0.0;

  double freedom() const { return rows - static_cast<double>(x.cols()); }  // n − p
};

void refuse_unusable(const GroupedMeasurements& data) {
  const Eigen::Index rows = data.y.size();
  if (data.design.rows() != rows || static_cast<Eigen::Index>(data.participant.size()) != rows) {
    throw std::invalid_argument("the numbers of rows of design, y and participant are " +
                                std::to_string(data.design.rows()) + ", " + std::to_string(rows) +
                                " and " + std::to_string(data.participant.size()) +
                                "; they must be equal");
  }
  if (!data.design.allFinite()) {
    throw std::invalid_argument("design: the number in " + place_not_finite(data.design) +
                                " is not finite; all must be finite");
  }
  if (!data.y.allFinite()) {
    throw std::invalid_argument("y: the number in " + place_not_finite(data.y) +
                                " is not finite; all must be finite");
  }
  if (data.design.cols() == 0 || (data.design.col(0).array() != 1.0).any()) {
    throw std::invalid_argument(
        "design: the first column, of the intercept, is not 1 in every row; it must be 1");
  }
}

// About the means of y and of the columns, so that rounding depends on their spread alone.
struct Centred {
  ParticipantSums sums{};
  Eigen::RowVectorXd column_means{};  // 0 of the first
  double mean = 0.0;                  // of y
};

Centred centred_sums(const GroupedMeasurements& data) {
  const Eigen::Index effects = data.design.cols();
  const auto participants = static_cast<Eigen::Index>(
      *std::max_element(data.participant.begin(), data.participant.end()) + 1);
  Centred made{.column_means = data.design.colwise().mean(), .mean = data.y.mean()};
  made.column_means(0) = 0.0;
  ParticipantSums& sums = made.sums;
  sums.xx = Eigen::MatrixXd::Zero(effects, effects);
  sums.xy = Eigen::VectorXd::Zero(effects);
  sums.x = Eigen::MatrixXd::Zero(participants, effects);
  sums.y = Eigen::VectorXd::Zero(participants);
  sums.count = Eigen::VectorXd::Zero(participants);
  for (Eigen::Index row = 0; row < data.y.size(); ++row) {
    const Eigen::RowVectorXd x = data.design.row(row) - made.column_means;
    const double y = data.y(row) - made.mean;
    const auto own = static_cast<Eigen::Index>(data.participant[static_cast<std::size_t>(row)]);
    sums.xx += x.transpose() * x;
    sums.xy += y * x.transpose();
    sums.yy += y * y;
    sums.x.row(own) += x;
    sums.y(own) += y;
    sums.count(own) += 1.0;
  }
  sums.rows = static_cast<double>(data.y.size());
  return made;
}

// Everything at one λ; ' is the derivative over λ. M' = Z·Z' gives P' = −P·Z·Z'·P, from which with r = Z'Py and K = Z'PZ
//
//   (y'Py)' = −r'r,  (y'Py)'' = 2·r'K·r,  (ln|M| + ln|X'M⁻¹X|)' = tr K,  '' = −tr K².
//
// K = D − B·A⁻¹·B' with D = diag(n_i/(1 + λ·n_i)), A = X'M⁻¹X and B = Z'M⁻¹X.
struct AtLambda {
  CholeskyFactors A{};
  Eigen::MatrixXd B{};
  Eigen::VectorXd beta{};
  Eigen::VectorXd r{};
  Eigen::VectorXd D{};
  Eigen::MatrixXd solved{};  // A⁻¹·B'·B
  double squares = 0.0;      // y'Py
  double log_determinants = 0.0;

  double squares_slope() const { return -r.squaredNorm(); }
  double squares_curvature() const {
    const Eigen::VectorXd Br = B.transpose() * r;
    return 2.0 * ((D.array() * r.array().square()).sum() - Br.dot(A.solved(Br)));
  }
  double determinants_slope() const { return D.sum() - solved.trace(); }
  double determinants_curvature() const {
    const Eigen::MatrixXd BDB = B.transpose() * D.asDiagonal() * B;
    return -(D.squaredNorm() - 2.0 * A.solved_columns(BDB).trace() + (solved * solved).trace());
  }
};

AtLambda at_lambda(const ParticipantSums& sums, double lambda) {
  AtLambda at{};
  const Eigen::ArrayXd shrunk = 1.0 / (1.0 + lambda * sums.count.array());
  const Eigen::VectorXd weights = lambda * shrunk;
  const Eigen::MatrixXd A = sums.xx - sums.x.transpose() * weights.asDiagonal() * sums.x;
  const Eigen::VectorXd a = sums.xy - sums.x.transpose() * weights.asDiagonal() * sums.y;
  at.A = CholeskyFactors(A);
  at.beta = at.A.solved(a);
  at.B = shrunk.matrix().asDiagonal() * sums.x;
  at.D = shrunk * sums.count.array();
  at.r = (sums.y - sums.x * at.beta).array() * shrunk;
  at.solved = at.A.solved_columns(at.B.transpose() * at.B);
  at.squares = sums.yy - (weights.array() * sums.y.array().square()).sum() - a.dot(at.beta);
  at.log_determinants = (1.0 + lambda * sums.count.array()).log().sum() + at.A.log_determinant();
  return at;
}

// The criterion with its best σ² = y'Py/(n − p), and its slope, without constants.
double profile(const ParticipantSums& sums, double lambda) {
  const AtLambda at = at_lambda(sums, lambda);
  return sums.freedom() * std::log(at.squares) + at.log_determinants;
}
double profile_slope(const ParticipantSums& sums, double lambda) {
  const AtLambda at = at_lambda(sums, lambda);
  return sums.freedom() * at.squares_slope() / at.squares + at.determinants_slope();
}

constexpr double kGreatestLambda = 1e8;

// λ from 0 to kGreatestLambda: the least of a grid, because with unequal n_i there can be several minima, and then the root of the
// slope next to it.
std::variant<double, NoLinearMixed> best_lambda(const ParticipantSums& sums) {
  std::vector<double> grid{0.0};
  for (int step = -32; step <= 32; ++step) grid.push_back(std::pow(10.0, 0.25 * step));
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const double value = profile(sums, grid[i]);
    if (std::isnan(value)) return NoLinearMixed::no_residual_variance;  // y'Py is rounding
    if (value < least) {
      least = value;
      best = i;
    }
  }
  if (best + 1 == grid.size()) return NoLinearMixed::no_residual_variance;
  double low = grid[best == 0 ? 0 : best - 1];
  const double high = grid[best + 1];
  const auto slope = [&sums](double lambda) { return profile_slope(sums, lambda); };
  if (slope(low) >= 0.0) {
    if (low == 0.0) return NoLinearMixed::no_participant_variance;
    low = grid[best];
  }
  if (!(slope(low) < 0.0 && slope(high) > 0.0)) return grid[best];
  std::uintmax_t most_steps = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(
      slope, low, high, boost::math::tools::eps_tolerance<double>(50), most_steps);
  return 0.5 * (below + above);
}

}  // namespace

std::vector<Eigen::Index> dependent_columns(const Eigen::MatrixXd& design) {
  // Cholesky's decomposition of the columns' correlations, without the columns that turn out to be dependent. What is left
  // of a column's variance is 1 − R² of its regression on the columns before it.
  constexpr double kNothingLeft = 1e-10;
  const Eigen::RowVectorXd means = design.colwise().mean();
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(design.cols(), design.cols());
  for (Eigen::Index row = 0; row < design.rows(); ++row) {
    const Eigen::RowVectorXd x = design.row(row) - means;
    products += x.transpose() * x;
  }
  std::vector<Eigen::Index> dependent{};
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(design.cols(), design.cols());
  for (Eigen::Index column = 1; column < design.cols(); ++column) {
    const double variance = products(column, column);
    for (Eigen::Index other = 1; other < column; ++other) {
      if (L(other, other) == 0.0) continue;
      const double rest = products(column, other) - L.row(column).dot(L.row(other));
      L(column, other) = rest / L(other, other);
    }
    const double left = variance - L.row(column).squaredNorm();
    if (are_equal_numbers(design.col(column)) || left <= kNothingLeft * variance) {
      L.row(column).setZero();
      dependent.push_back(column);
    } else {
      L(column, column) = std::sqrt(left);
    }
  }
  return dependent;
}

Eigen::VectorXd LinearMixedFit::standard_error() const {
  return at_.covariance.diagonal().cwiseSqrt();
}

double LinearMixedFit::degrees_of(const Eigen::VectorXd& weights) const {
  const double f = weights.dot(at_.covariance * weights);
  const Eigen::Vector2d gradient{weights.dot(at_.over_lambda * weights), f / at_.residual_variance};
  return f * f / gradient.dot(at_.hessian.ldlt().solve(gradient));
}

LinearMixedFit::Combination LinearMixedFit::combination(const Eigen::VectorXd& weights,
                                                        double confidence) const {
  if (weights.size() != at_.beta.size() || weights.isZero(0.0)) {
    throw std::invalid_argument(
        "weights: the number of weights is " + std::to_string(weights.size()) +
        "; it must be the number of fixed effects, " + std::to_string(at_.beta.size()) +
        ", and at least one weight must differ from 0");
  }
  Combination made{.estimate = weights.dot(at_.beta),
                   .standard_error = std::sqrt(weights.dot(at_.covariance * weights)),
                   .df = degrees_of(weights)};
  made.t = made.estimate / made.standard_error;
  made.p = two_sided_tail({.value = made.t, .df = made.df}).value_or(1.0);
  const double half =
      t_limit({.confidence = confidence, .df = made.df}).value_or(0.0) * made.standard_error;
  made.interval = {.low = made.estimate - half, .high = made.estimate + half};
  return made;
}

LinearMixedFit::Combination LinearMixedFit::effect(Eigen::Index column, double confidence) const {
  return combination(Eigen::VectorXd::Unit(at_.beta.size(), column), confidence);
}

LinearMixedFit::JointTest LinearMixedFit::joint_test(const Columns& columns) const {
  if (columns.first < 0 || columns.count < 1 || columns.first + columns.count > at_.beta.size()) {
    throw std::invalid_argument("columns: first is " + std::to_string(columns.first) +
                                " and count is " + std::to_string(columns.count) +
                                "; they must be a range of at least one column within those of the "
                                "design, numbered from 0 to " +
                                std::to_string(at_.beta.size() - 1));
  }
  const Eigen::MatrixXd own =
      at_.covariance.block(columns.first, columns.first, columns.count, columns.count);
  const EigenAxes axes = eigen_axes(own);
  JointTest test{.df1 = static_cast<double>(columns.count)};
  double expected = 0.0;
  double least_df = std::numeric_limits<double>::infinity();
  double most_df = 0.0;
  for (Eigen::Index axis = 0; axis < columns.count; ++axis) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(at_.beta.size());
    weights.segment(columns.first, columns.count) = axes.vectors.col(axis);
    const Combination one = combination(weights);
    test.F += one.t * one.t / test.df1;
    least_df = std::min(least_df, one.df);
    most_df = std::max(most_df, one.df);
    expected += one.df / (one.df - 2.0);
  }
  constexpr double kEqualDegrees = 1e-8;
  if (most_df - least_df < kEqualDegrees) {
    test.df2 = least_df;
  } else {
    test.df2 = least_df <= 2.0 ? 2.0 : 2.0 * expected / (expected - test.df1);
  }
  test.p = upper_tail(FStatistic{.value = test.F, .df1 = test.df1, .df2 = test.df2}).value_or(1.0);
  return test;
}

std::variant<LinearMixedFit, NoLinearMixed> linear_mixed(const GroupedMeasurements& data) {
  refuse_unusable(data);
  if (data.y.size() == 0) return NoLinearMixed::too_few_participants;
  const auto [sums, column_means, mean] = centred_sums(data);
  const auto participants = (sums.count.array() > 0.0).count();
  if (participants < 2) return NoLinearMixed::too_few_participants;
  if (data.y.size() <= participants || sums.freedom() < 1.0) return NoLinearMixed::too_few_rows;
  if (!dependent_columns(data.design).empty()) return NoLinearMixed::dependent_effects;
  // tr Z'PZ without a random intercept: 0 where the fixed effects determine every participant's mean.
  constexpr double kNoFreedom = 1e-10;
  if (at_lambda(sums, 0.0).determinants_slope() <= kNoFreedom * sums.rows) {
    return NoLinearMixed::too_few_participants;
  }
  if (are_equal_numbers(data.y)) return NoLinearMixed::no_residual_variance;
  // Of a fit without residuals rounding is left: that of y itself, and that of the difference that y'Py is. y'Py falls with
  // λ; at the greatest one it is what participants and fixed effects together leave.
  constexpr double kRoundingOfDifference = 1e-14;
  const double of_y = kRounding * data.y.cwiseAbs().maxCoeff();
  const double none = std::max(sums.rows * of_y * of_y, kRoundingOfDifference * sums.yy);
  if (at_lambda(sums, kGreatestLambda).squares <= none) return NoLinearMixed::no_residual_variance;
  const std::variant<double, NoLinearMixed> found = best_lambda(sums);
  if (const auto* const why = std::get_if<NoLinearMixed>(&found)) return *why;
  const double lambda = std::get<double>(found);
  const AtLambda at = at_lambda(sums, lambda);
  const double freedom = sums.freedom();
  const double variance = at.squares / freedom;
  LinearMixedFit::Estimates made{.lambda = lambda,
                                 .residual_variance = variance,
                                 .participants = static_cast<std::size_t>(participants),
                                 .rows = static_cast<std::size_t>(data.y.size())};
  // Back from the means: β₀ = ȳ + b₀ − Σ x̄_j·b_j.
  const Eigen::Index effects = data.design.cols();
  Eigen::MatrixXd uncentred = Eigen::MatrixXd::Identity(effects, effects);
  uncentred.row(0) -= column_means;
  made.beta = uncentred * at.beta;
  made.beta(0) += mean;
  const Eigen::MatrixXd inverse = at.A.inverse();
  made.covariance = variance * uncentred * inverse * uncentred.transpose();
  // (A⁻¹)' = A⁻¹·B'·B·A⁻¹.
  made.over_lambda = variance * uncentred * at.solved * inverse * uncentred.transpose();
  const double over_both = -at.squares_slope() / (variance * variance);
  made.hessian << at.squares_curvature() / variance + at.determinants_curvature(), over_both,
      over_both, freedom / (variance * variance);
  made.log_likelihood =
      -0.5 * (freedom * (std::log(2.0 * std::numbers::pi * variance) + 1.0) + at.log_determinants);
  return LinearMixedFit(std::move(made));
}

}  // namespace asperity
