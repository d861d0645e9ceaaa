// Mean squares of a two-way table.

#include "analysis/scales/intraclass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/numbers/matrix_place.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

struct MeanSquares {
  double targets = 0.0;
  double within = 0.0;
  double raters = 0.0;
  double rest = 0.0;
};

MeanSquares mean_squares(const Eigen::MatrixXd& ratings) {
  const auto n = static_cast<double>(ratings.rows());
  const auto k = static_cast<double>(ratings.cols());
  // About a common number first: rounding then depends on the spread alone.
  const Eigen::MatrixXd y = ratings.array() - ratings(0, 0);
  const double mean = y.mean();
  const Eigen::VectorXd of_target = y.rowwise().mean();
  const Eigen::RowVectorXd of_rater = y.colwise().mean();
  const Eigen::MatrixXd about_target = y.colwise() - of_target;
  const Eigen::MatrixXd rest = about_target.rowwise() - (of_rater.array() - mean).matrix();
  return {.targets = k * (of_target.array() - mean).square().sum() / (n - 1.0),
          .within = about_target.squaredNorm() / (n * (k - 1.0)),
          .raters = n * (of_rater.array() - mean).square().sum() / (k - 1.0),
          .rest = rest.squaredNorm() / ((n - 1.0) * (k - 1.0))};
}

// What F of these degrees of freedom exceeds with half of 1 − confidence.
double f_limit(double df1, double df2, double confidence) {
  return exceeded_by(FTail{.tail = 0.5 * (1.0 - confidence), .df1 = df1, .df2 = df2});
}

struct Forms {
  IntraclassCorrelation single{};
  IntraclassCorrelation mean{};
};

// The two forms whose limits are those of one F: ICC1 and ICC3, and of the mean.
Forms exact_forms(const IntraclassCorrelation& test, double k, double confidence) {
  Forms forms{.single = test, .mean = test};
  const auto correlation = [k](double F) { return (F - 1.0) / (F + k - 1.0); };
  if (std::isinf(test.F)) {
    forms.single.value = forms.mean.value = 1.0;
    return forms;
  }
  forms.single.value = correlation(test.F);
  forms.mean.value = 1.0 - 1.0 / test.F;
  if (test.F == 0.0)
    return forms;  // all targets have the same mean: no limit of the mean's form is finite
  const double low = test.F / f_limit(test.df1, test.df2, confidence);
  const double high = test.F * f_limit(test.df2, test.df1, confidence);
  forms.single.interval = {.low = correlation(low), .high = correlation(high)};
  forms.mean.interval = {.low = 1.0 - 1.0 / low, .high = 1.0 - 1.0 / high};
  return forms;
}

Forms agreement_forms(const MeanSquares& ms, const IntraclassCorrelation& test, double n, double k,
                      double confidence) {
  Forms forms{.single = test, .mean = test};
  const double raters = (ms.raters - ms.rest) / n;
  const double icc = (ms.targets - ms.rest) / (ms.targets + (k - 1.0) * ms.rest + k * raters);
  // Spearman and Brown. It falls to −∞ at −1/(k − 1), and ICC2 and its limits can lie below that.
  const auto of_mean = [k](double one) {
    const double variance = 1.0 + (k - 1.0) * one;
    return variance > 0.0 ? k * one / variance : -std::numeric_limits<double>::infinity();
  };
  forms.single.value = icc;
  forms.mean.value = of_mean(icc);
  if (std::isinf(test.F) || test.F == 0.0) return forms;
  const double ratio = ms.raters / ms.rest;
  const double sum = n * (1.0 + (k - 1.0) * icc) - k * icc;
  const double top = k * icc * ratio + sum;
  const double df = (k - 1.0) * (n - 1.0) * top * top /
                    ((n - 1.0) * k * k * icc * icc * ratio * ratio + sum * sum);
  const double errors = k * ms.raters + (k * n - k - n) * ms.rest;
  const double above = f_limit(n - 1.0, df, confidence);
  const double below = f_limit(df, n - 1.0, confidence);
  const ConfidenceInterval limits{
      .low = n * (ms.targets - above * ms.rest) / (above * errors + n * ms.targets),
      .high = n * (below * ms.targets - ms.rest) / (errors + n * below * ms.targets)};
  forms.single.interval = limits;
  const double high = of_mean(limits.high);
  if (std::isfinite(high)) forms.mean.interval = {.low = of_mean(limits.low), .high = high};
  return forms;
}

IntraclassCorrelation test_of(double targets, double error, double df1, double df2) {
  IntraclassCorrelation test{
      .F = error > 0.0 ? targets / error : std::numeric_limits<double>::infinity(),
      .df1 = df1,
      .df2 = df2};
  test.p = *upper_tail(FStatistic{.value = test.F, .df1 = df1, .df2 = df2});
  return test;
}

}  // namespace

std::optional<Reliability> reliability_of(const Eigen::MatrixXd& ratings, double confidence) {
  if (ratings.rows() < 2 || ratings.cols() < 2) {
    throw std::invalid_argument("ratings: the number of targets is " +
                                std::to_string(ratings.rows()) + " and that of raters is " +
                                std::to_string(ratings.cols()) + "; at least 2 of each are needed");
  }
  if (!ratings.allFinite())
    throw std::invalid_argument("ratings: the rating in " + place_not_finite(ratings) +
                                " is not finite; all must be finite");
  static_cast<void>(normal_limit(confidence));  // refuses what is no confidence
  MeanSquares ms = mean_squares(ratings);
  // What rounding leaves of a sum of squares that is 0.
  const double none = 1e-28 * ratings.squaredNorm();
  for (double* one : {&ms.targets, &ms.within, &ms.raters, &ms.rest}) {
    if (*one <= none) *one = 0.0;
  }
  if (ms.targets == 0.0 && ms.rest == 0.0) return std::nullopt;
  const auto n = static_cast<double>(ratings.rows());
  const auto k = static_cast<double>(ratings.cols());
  const IntraclassCorrelation one_way = test_of(ms.targets, ms.within, n - 1.0, n * (k - 1.0));
  const IntraclassCorrelation two_way =
      test_of(ms.targets, ms.rest, n - 1.0, (n - 1.0) * (k - 1.0));
  const Forms first = exact_forms(one_way, k, confidence);
  const Forms second = agreement_forms(ms, two_way, n, k, confidence);
  const Forms third = exact_forms(two_way, k, confidence);
  Reliability answer{.correlations = {first.single, second.single, third.single, first.mean,
                                      second.mean, third.mean},
                     .standard_error_of_measurement = std::sqrt(ms.rest)};
  constexpr std::array<std::string_view, 6> kNames{"ICC1",  "ICC2",  "ICC3",
                                                   "ICC1k", "ICC2k", "ICC3k"};
  for (std::size_t i = 0; i < kNames.size(); ++i) answer.correlations[i].name = kNames[i];
  return answer;
}

}  // namespace asperity
