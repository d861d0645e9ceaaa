// Means of logarithms, least squares on them, and what follows from the coefficients.

#include "analysis/scales/magnitude.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/normal.hpp>

#include "analysis/numbers/dense.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

void refuse_unknown_place(std::size_t place, std::size_t size, const char* what) {
  if (place >= size) {
    throw std::invalid_argument(std::string("estimates: ") + what + " is " + std::to_string(place) +
                                "; it must be below " + std::to_string(size));
  }
}

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

// Columns 1, x, x², … of the levels.
Eigen::MatrixXd powers_of(const Eigen::VectorXd& x, Eigen::Index coefficients) {
  Eigen::MatrixXd powers(x.size(), coefficients);
  powers.col(0).setOnes();
  for (Eigen::Index k = 1; k < coefficients; ++k) {
    powers.col(k) = powers.col(k - 1).cwiseProduct(x);
  }
  return powers;
}

struct LeastSquares {
  Eigen::MatrixXd powers{};
  LeastSquaresFactors factors;
};

LeastSquares least_squares_of_any(const MagnitudeCurves& curves, Eigen::Index coefficients) {
  if (curves.x.size() != curves.log10.cols() || !curves.x.allFinite() ||
      !curves.log10.allFinite()) {
    throw std::invalid_argument("x: the number of levels is " + std::to_string(curves.x.size()) +
                                "; it must be the number of columns of log10, " +
                                std::to_string(curves.log10.cols()) +
                                ", and all values of x and log10 must be finite");
  }
  const Eigen::MatrixXd powers = powers_of(curves.x, coefficients);
  LeastSquares fit{.powers = powers, .factors = LeastSquaresFactors(powers)};
  if (fit.factors.rank() < coefficients) {
    throw std::invalid_argument("x has too few different levels; a curve with " +
                                std::to_string(coefficients) +
                                " coefficients needs at least that many");
  }
  return fit;
}

LeastSquares least_squares(const MagnitudeCurves& curves, Eigen::Index coefficients) {
  if (curves.log10.rows() < 2) {
    throw std::invalid_argument("log10: the number of participants is " +
                                std::to_string(curves.log10.rows()) + "; at least 2 are needed");
  }
  return least_squares_of_any(curves, coefficients);
}

// The curve through the means of all participants.
struct MeanFit {
  Eigen::VectorXd coefficients{};
  double residual_squares = 0.0;
  double r2 = 0.0;
  double df = 0.0;
  Eigen::MatrixXd covariance{};  // of the coefficients, from the residuals
};

/// The coefficients of each row, counted from its first level: of a row that is level they are 0 but for the
/// first, without a rounding that looks like a slope.
Eigen::MatrixXd coefficients_by_row(const LeastSquares& fit, const Eigen::MatrixXd& rows) {
  const Eigen::MatrixXd from_first = rows.colwise() - rows.col(0);
  Eigen::MatrixXd coefficients = fit.factors.solved_columns(from_first.transpose()).transpose();
  coefficients.col(0) += rows.col(0);
  return coefficients;
}

MeanFit mean_fit(const MagnitudeCurves& curves, const LeastSquares& fit) {
  const Eigen::VectorXd means = curves.log10.colwise().mean();
  MeanFit answer{.coefficients = coefficients_by_row(fit, means.transpose()).transpose()};
  const Eigen::VectorXd from_first = means.array() - means(0);
  Eigen::VectorXd of_first = answer.coefficients;
  of_first(0) -= means(0);
  answer.residual_squares = (from_first - fit.powers * of_first).squaredNorm();
  const double squares = (from_first.array() - from_first.mean()).square().sum();
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  answer.r2 = squares > 0.0 ? 1.0 - answer.residual_squares / squares : kNaN;
  answer.df = static_cast<double>(fit.powers.rows() - fit.powers.cols());
  answer.covariance =
      answer.residual_squares / answer.df * inverse(fit.powers.transpose() * fit.powers);
  return answer;
}

std::vector<double> column(const Eigen::MatrixXd& matrix, Eigen::Index k) {
  return {matrix.col(k).begin(), matrix.col(k).end()};
}

Eigen::MatrixXd covariance_of_mean(const Eigen::MatrixXd& rows) {
  const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
  const auto n = static_cast<double>(rows.rows());
  return centred.transpose() * centred / ((n - 1.0) * n);
}

Eigen::MatrixXd coefficients_of(const QuadraticFit& fit) {
  Eigen::MatrixXd rows(index(fit.participants.size()), 3);
  for (std::size_t i = 0; i < fit.participants.size(); ++i) {
    const Quadratic& one = fit.participants[i];
    rows.row(index(i)) << one.a, one.b, one.c;
  }
  return rows;
}

Quadratic quadratic_of(const Eigen::RowVector3d& coefficients) {
  return {.a = coefficients(0), .b = coefficients(1), .c = coefficients(2)};
}

// dx*/d(b, c).
Eigen::Vector2d peak_gradient(const Quadratic& curve) {
  return {-1.0 / (2.0 * curve.c), curve.b / (2.0 * curve.c * curve.c)};
}

// 4(c² − t²V_cc)·x² + 4(bc − t²V_bc)·x + (b² − t²V_bb) ≤ 0.
std::optional<ConfidenceInterval> fieller_set(const Quadratic& mean, const Eigen::Matrix3d& v,
                                              double t) {
  const double square = 4.0 * (mean.c * mean.c - t * t * v(2, 2));
  const double linear = 4.0 * (mean.b * mean.c - t * t * v(1, 2));
  const double constant = mean.b * mean.b - t * t * v(1, 1);
  const double discriminant = linear * linear - 4.0 * square * constant;
  if (square <= 0.0 || discriminant < 0.0) {
    return std::nullopt;
  }
  const double half = std::sqrt(discriminant);
  return ConfidenceInterval{.low = (-linear - half) / (2.0 * square),
                            .high = (-linear + half) / (2.0 * square)};
}

EndSlope end_slope(const QuadraticFit& fit, double x, bool rising) {
  EndSlope end{.slope = fit.mean.slope(x)};
  const Eigen::Matrix3d& v = fit.covariance;
  const double variance = v(1, 1) + 4.0 * x * v(1, 2) + 4.0 * x * x * v(2, 2);
  if (variance > 0.0) {
    end.t = end.slope / std::sqrt(variance);
    const double df = static_cast<double>(fit.participants.size()) - 1.0;
    end.p = upper_tail(TStatistic{.value = rising ? *end.t : -*end.t, .df = df});
  }
  return end;
}

std::optional<double> resampled_peak(const Eigen::MatrixXd& coefficients,
                                     std::span<const std::size_t> places) {
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const std::size_t place : places) {
    if (place >= static_cast<std::size_t>(coefficients.rows())) {
      throw std::invalid_argument("resamples: participant is " + std::to_string(place) +
                                  "; it must be below " + std::to_string(coefficients.rows()));
    }
    sum += coefficients.row(index(place));
  }
  return quadratic_of(sum / static_cast<double>(places.size())).peak();
}

// The acceleration from leaving out each participant once; nothing where a rest has no maximum.
std::optional<double> acceleration(const Eigen::MatrixXd& coefficients) {
  const auto n = static_cast<std::size_t>(coefficients.rows());
  std::vector<double> rests;
  for (std::size_t left_out = 0; left_out < n; ++left_out) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < n; ++i) {
      if (i != left_out) {
        places.push_back(i);
      }
    }
    const std::optional<double> peak = resampled_peak(coefficients, places);
    if (!peak) {
      return std::nullopt;
    }
    rests.push_back(*peak);
  }
  const double mean = summary_of(rests)->mean;
  double squares = 0.0;
  double cubes = 0.0;
  for (const double rest : rests) {
    const double u = mean - rest;
    squares += u * u;
    cubes += u * u * u;
  }
  return squares > 0.0 ? std::optional<double>(cubes / (6.0 * std::pow(squares, 1.5)))
                       : std::nullopt;
}

std::optional<PeakBootstrap::BiasCorrected> bias_corrected(const Eigen::MatrixXd& coefficients,
                                                           std::span<const double> sorted,
                                                           double peak, double confidence) {
  // A resample of everybody once has the same peak but for the order of its sum.
  constexpr double kRounding = 1e-12;
  const double near = kRounding * (1.0 + std::abs(peak));
  double below = 0.0;
  double equal = 0.0;
  for (const double one : sorted) {
    below += one < peak - near ? 1.0 : 0.0;
    equal += std::abs(one - peak) <= near ? 1.0 : 0.0;
  }
  const double share = (below + 0.5 * equal) / static_cast<double>(sorted.size());
  const std::optional<double> a = acceleration(coefficients);
  if (!a || share <= 0.0 || share >= 1.0) {
    return std::nullopt;
  }
  const boost::math::normal normal;
  PeakBootstrap::BiasCorrected answer{.z0 = boost::math::quantile(normal, share),
                                      .acceleration = *a};
  const double z = normal_limit(confidence);
  const auto limit = [&](double end) {
    const double shifted = answer.z0 + end;
    return quantile(sorted, boost::math::cdf(normal, answer.z0 + shifted / (1.0 - *a * shifted)));
  };
  answer.interval = {.low = limit(-z), .high = limit(z)};
  return answer;
}

}  // namespace

std::vector<MagnitudeEstimate> without_zeros(std::span<const MagnitudeEstimate> estimates,
                                             ZeroRule rule) {
  std::map<std::size_t, double> least;
  for (const MagnitudeEstimate& one : estimates) {
    if (!std::isfinite(one.estimate) || one.estimate < 0.0) {
      throw std::invalid_argument("estimate is " + number_text(one.estimate) +
                                  "; it must be finite and at least 0");
    }
    if (one.estimate > 0.0) {
      const auto [place, is_first] = least.emplace(one.participant, one.estimate);
      place->second = std::min(place->second, one.estimate);
    }
  }
  std::vector<MagnitudeEstimate> kept;
  for (MagnitudeEstimate one : estimates) {
    if (one.estimate == 0.0) {
      if (rule == ZeroRule::exclude) {
        continue;
      }
      const auto found = least.find(one.participant);
      if (found == least.end()) {
        throw std::invalid_argument("estimates: all those of participant " +
                                    std::to_string(one.participant + 1) +
                                    " are 0; at least one must be positive");
      }
      one.estimate = 0.5 * found->second;
    }
    kept.push_back(one);
  }
  return kept;
}

MagnitudeCells magnitude_cells(std::span<const MagnitudeEstimate> estimates,
                               const MagnitudeDesign& design) {
  const Eigen::MatrixXd empty =
      Eigen::MatrixXd::Zero(index(design.participants), index(design.levels));
  std::vector<Eigen::MatrixXd> sums(design.conditions, empty);
  std::vector<Eigen::MatrixXd> counts(design.conditions, empty);
  for (const MagnitudeEstimate& one : estimates) {
    refuse_unknown_place(one.participant, design.participants, "participant");
    refuse_unknown_place(one.condition, design.conditions, "condition");
    refuse_unknown_place(one.level, design.levels, "level");
    if (!(one.estimate > 0.0) || !std::isfinite(one.estimate)) {
      throw std::invalid_argument(
          "estimate is " + number_text(one.estimate) +
          "; it must be finite and positive, because its logarithm is analysed");
    }
    sums[one.condition](index(one.participant), index(one.level)) += std::log10(one.estimate);
    counts[one.condition](index(one.participant), index(one.level)) += 1.0;
  }
  MagnitudeCells cells;
  for (std::size_t participant = 0; participant < design.participants; ++participant) {
    const bool has_all = std::all_of(counts.begin(), counts.end(), [&](const auto& count) {
      return count.row(index(participant)).minCoeff() > 0.0;
    });
    (has_all ? cells.complete : cells.incomplete).push_back(participant);
  }
  for (std::size_t condition = 0; condition < design.conditions; ++condition) {
    Eigen::MatrixXd means(index(cells.complete.size()), index(design.levels));
    for (std::size_t row = 0; row < cells.complete.size(); ++row) {
      const Eigen::Index participant = index(cells.complete[row]);
      means.row(index(row)) =
          sums[condition].row(participant).cwiseQuotient(counts[condition].row(participant));
    }
    cells.log10.push_back(std::move(means));
  }
  return cells;
}

Eigen::VectorXd participant_means(const MagnitudeCells& cells) {
  Eigen::VectorXd means = Eigen::VectorXd::Zero(index(cells.complete.size()));
  for (const Eigen::MatrixXd& condition : cells.log10) {
    means += condition.rowwise().mean();
  }
  return means / static_cast<double>(cells.log10.size());
}

std::vector<Eigen::MatrixXd> normalised_to_grand_mean(const MagnitudeCells& cells) {
  const Eigen::VectorXd means = participant_means(cells);
  std::vector<Eigen::MatrixXd> normalised = cells.log10;
  for (Eigen::MatrixXd& condition : normalised) {
    condition.colwise() += (means.mean() - means.array()).matrix();
  }
  return normalised;
}

std::vector<Eigen::MatrixXd> normalised_to_standard(const MagnitudeCells& cells,
                                                    const MagnitudeStandard& standard) {
  if (!(standard.modulus > 0.0) || !std::isfinite(standard.modulus)) {
    throw std::invalid_argument("modulus is " + number_text(standard.modulus) +
                                "; it must be positive");
  }
  Eigen::VectorXd at_standard = Eigen::VectorXd::Zero(index(cells.complete.size()));
  for (const Eigen::MatrixXd& condition : cells.log10) {
    refuse_unknown_place(standard.level, static_cast<std::size_t>(condition.cols()),
                         "standard level");
    at_standard += condition.col(index(standard.level));
  }
  at_standard /= static_cast<double>(cells.log10.size());
  std::vector<Eigen::MatrixXd> normalised = cells.log10;
  for (Eigen::MatrixXd& condition : normalised) {
    condition.colwise() += (std::log10(standard.modulus) - at_standard.array()).matrix();
  }
  return normalised;
}

PowerLaw power_law(const MagnitudeCurves& curves) {
  const LeastSquares fit = least_squares(curves, 2);
  const Eigen::MatrixXd lines = coefficients_by_row(fit, curves.log10);
  PowerLaw law{.exponents = column(lines, 1)};
  law.exponent = one_sample_t(law.exponents, {.confidence = curves.confidence});
  law.intercept = lines.col(0).mean();
  const MeanFit pooled = mean_fit(curves, fit);
  law.pooled_slope = pooled.coefficients(1);
  law.pooled_slope_se = std::sqrt(pooled.covariance(1, 1));
  law.pooled_r2 = pooled.r2;
  return law;
}

CurveType curve_type(const Quadratic& curve, const TestedRange& tested) noexcept {
  const double first = curve.slope(tested.lowest_x);
  const double last = curve.slope(tested.highest_x);
  if (last >= 0.0) return CurveType::other;
  return first < 0.0 ? CurveType::descending : CurveType::inverted_u;
}

std::optional<double> Quadratic::peak() const noexcept {
  return c < 0.0 ? std::optional<double>(-b / (2.0 * c)) : std::nullopt;
}

std::optional<double> QuadraticFit::interior_maximum_p() const {
  if (!ends[0].p || !ends[1].p) return std::nullopt;
  return std::max(*ends[0].p, *ends[1].p);
}

QuadraticFit quadratic_fit(const MagnitudeCurves& curves) {
  const LeastSquares fit = least_squares(curves, 3);
  const Eigen::MatrixXd rows = coefficients_by_row(fit, curves.log10);
  QuadraticFit answer;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    answer.participants.push_back(quadratic_of(rows.row(i)));
  }
  answer.mean = quadratic_of(rows.colwise().mean());
  answer.covariance = covariance_of_mean(rows);
  answer.curvature = one_sample_t(column(rows, 2), {.confidence = curves.confidence});

  const MeanFit line = mean_fit(curves, least_squares(curves, 2));
  const MeanFit curve = mean_fit(curves, fit);
  answer.pooled_r2 = curve.r2;
  if (curve.df > 0.0 && curve.residual_squares > 0.0) {
    answer.F =
        (line.residual_squares - curve.residual_squares) / (curve.residual_squares / curve.df);
    answer.p = upper_tail(FStatistic{.value = *answer.F, .df1 = 1.0, .df2 = curve.df});
  }

  const double lowest = curves.x.minCoeff();
  const double highest = curves.x.maxCoeff();
  answer.ends = {end_slope(answer, lowest, true), end_slope(answer, highest, false)};
  const auto is_inside = [&](double x) { return x >= lowest && x <= highest; };
  for (const Quadratic& one : answer.participants) {
    if (const std::optional<double> peak = one.peak()) {
      ++answer.concave_participants;
      if (is_inside(*peak)) {
        answer.participant_peaks.push_back(*peak);
      }
    }
  }

  const std::optional<double> peak = answer.mean.peak();
  if (!peak) {
    return answer;
  }
  const double t =
      *t_limit({.confidence = curves.confidence, .df = static_cast<double>(rows.rows()) - 1.0});
  answer.fieller = fieller_set(answer.mean, answer.covariance, t);
  answer.status = is_inside(*peak) ? PeakStatus::inside : PeakStatus::outside_range;
  if (answer.status == PeakStatus::inside) {
    const Eigen::Vector2d gradient = peak_gradient(answer.mean);
    const auto error = [&](const Eigen::MatrixXd& covariance) {
      return std::sqrt(gradient.dot(covariance.bottomRightCorner<2, 2>() * gradient));
    };
    QuadraticFit::Peak found{.x = *peak, .standard_error = error(answer.covariance)};
    found.height = answer.mean.a - answer.mean.b * answer.mean.b / (4.0 * answer.mean.c);
    found.interval = {.low = *peak - t * found.standard_error,
                      .high = *peak + t * found.standard_error};
    if (curve.df > 0.0) {
      found.pooled_standard_error = error(curve.covariance);
    }
    answer.peak = found;
  }
  return answer;
}

CurveFit curve_fit(const CurvePoints& points) {
  const MagnitudeCurves curves{
      .log10 =
          Eigen::Map<const Eigen::RowVectorXd>(points.log10.data(), index(points.log10.size())),
      .x = Eigen::Map<const Eigen::VectorXd>(points.x.data(), index(points.x.size()))};
  const MeanFit fit = mean_fit(curves, least_squares_of_any(curves, 3));
  CurveFit answer{.curve = quadratic_of(fit.coefficients), .r2 = fit.r2};
  const std::optional<double> peak = answer.curve.peak();
  if (!peak) return answer;
  const bool is_inside = *peak >= curves.x.minCoeff() && *peak <= curves.x.maxCoeff();
  answer.status = is_inside ? PeakStatus::inside : PeakStatus::outside_range;
  if (is_inside) {
    answer.peak = CurveFit::Peak{
        .x = *peak,
        .height = answer.curve.a + answer.curve.b * *peak + answer.curve.c * *peak * *peak};
  }
  if (fit.df > 0.0) {
    const double t = *t_limit({.confidence = points.confidence, .df = fit.df});
    answer.fieller = fieller_set(answer.curve, fit.covariance, t);
    if (is_inside) {
      const Eigen::Vector2d gradient = peak_gradient(answer.curve);
      answer.peak->standard_error =
          std::sqrt(gradient.dot(fit.covariance.bottomRightCorner<2, 2>() * gradient));
    }
  }
  return answer;
}

std::optional<PeakBootstrap> bootstrap_peak(const QuadraticFit& fit,
                                            std::span<const std::vector<std::size_t>> resamples,
                                            double confidence) {
  const std::optional<double> peak = fit.mean.peak();
  const Eigen::MatrixXd coefficients = coefficients_of(fit);
  std::vector<double> peaks;
  for (const std::vector<std::size_t>& places : resamples) {
    if (const std::optional<double> found = resampled_peak(coefficients, places)) {
      peaks.push_back(*found);
    }
  }
  if (!peak || peaks.size() < 2) {
    return std::nullopt;
  }
  PeakBootstrap answer{.valid = peaks.size()};
  answer.standard_error = summary_of(peaks)->sd;
  std::sort(peaks.begin(), peaks.end());
  const double outside = 0.5 * (1.0 - confidence);
  answer.percentile = {.low = quantile(peaks, outside), .high = quantile(peaks, 1.0 - outside)};
  answer.bias_corrected = bias_corrected(coefficients, peaks, *peak, confidence);
  return answer;
}

std::optional<PeakShift> peak_shift(const TwoConditions& conditions) {
  const QuadraticFit& first = conditions.first;
  const QuadraticFit& second = conditions.second;
  if (first.participants.size() != second.participants.size()) {
    throw std::invalid_argument(
        "first and second have different participants; they must have the same ones");
  }
  const std::optional<double> peak_1 = first.mean.peak();
  const std::optional<double> peak_2 = second.mean.peak();
  if (!peak_1 || !peak_2) {
    return std::nullopt;
  }
  Eigen::MatrixXd joint(index(first.participants.size()), 4);
  joint << coefficients_of(first).rightCols<2>(), coefficients_of(second).rightCols<2>();
  Eigen::Vector4d gradient;
  gradient << peak_gradient(first.mean), -peak_gradient(second.mean);
  const double df = static_cast<double>(first.participants.size()) - 1.0;
  PeakShift shift{.difference = *peak_1 - *peak_2};
  shift.standard_error = std::sqrt(gradient.dot(covariance_of_mean(joint) * gradient));
  if (shift.standard_error > 0.0) {
    shift.t = shift.difference / shift.standard_error;
    shift.p = two_sided_tail(TStatistic{.value = *shift.t, .df = df});
  }
  const double half =
      *t_limit({.confidence = conditions.confidence, .df = df}) * shift.standard_error;
  shift.interval = {.low = shift.difference - half, .high = shift.difference + half};
  return shift;
}

}  // namespace asperity
