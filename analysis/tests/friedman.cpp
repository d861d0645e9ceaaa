// Midranks within rows, corrected for ties; signed ranks are doubled so that sign flips can be counted in integers.

#include "analysis/tests/friedman.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "analysis/numbers/exact_null.h"
#include "analysis/numbers/matrix_place.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> midranks(std::span<const double> numbers) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [numbers](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
  std::vector<double> ranks(numbers.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && numbers[order[end]] == numbers[order[begin]]) ++end;
    const double shared = 0.5 * static_cast<double>(begin + 1 + end);
    for (; begin < end; ++begin) ranks[order[begin]] = shared;
  }
  return ranks;
}

FriedmanTest friedman_test(const Eigen::MatrixXd& judgements) {
  if (judgements.cols() < 2)
    throw std::invalid_argument(
        "judgements has fewer than two columns; it must have one per item, and at least two");
  if (!judgements.allFinite())
    throw std::invalid_argument("judgements: the number in " + place_not_finite(judgements) +
                                " is not finite; all must be finite");
  const auto n = static_cast<double>(judgements.rows());
  const auto k = static_cast<double>(judgements.cols());
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(judgements.cols());
  double squares = 0.0;  // of all ranks; those of a row without ties have k(k + 1)(2k + 1)/6
  for (Eigen::Index row = 0; row < judgements.rows(); ++row) {
    const Eigen::RowVectorXd own = judgements.row(row);
    const std::vector<double> ranks =
        midranks(std::span(own.data(), static_cast<std::size_t>(own.size())));
    for (Eigen::Index j = 0; j < own.size(); ++j) {
      const double rank = ranks[static_cast<std::size_t>(j)];
      sums(j) += rank;
      squares += rank * rank;
    }
  }
  FriedmanTest test{.df = k - 1.0};
  for (const double sum : sums) test.mean_rank.push_back(sum / n);
  // Ties take Σ(t³ − t)/12 from the squares.
  const double ties = 12.0 * (n * k * (k + 1.0) * (2.0 * k + 1.0) / 6.0 - squares);
  const double below = n * k * (k + 1.0) - ties / (k - 1.0);
  const double above = 12.0 * (sums.array() - n * (k + 1.0) / 2.0).square().sum();
  if (n < 2.0 || !(below > 1e-9)) {
    test.chi_squared = test.p = test.concordance = test.f = test.f_p = kNoValue;
    return test;
  }
  test.chi_squared = above / below;
  test.p = *upper_tail(ChiSquaredStatistic{.value = test.chi_squared, .df = test.df});
  test.concordance = test.chi_squared / (n * (k - 1.0));
  const double rest = n * (k - 1.0) - test.chi_squared;
  const bool agreed = rest <= 1e-12 * n * k;
  test.f = agreed ? std::numeric_limits<double>::infinity() : (n - 1.0) * test.chi_squared / rest;
  test.f_p = *upper_tail(FStatistic{.value = test.f, .df1 = k - 1.0, .df2 = (k - 1.0) * (n - 1.0)});
  return test;
}

SignedRankTest signed_rank_test(std::span<const double> differences) {
  std::vector<double> sizes{};
  std::vector<double> signs{};
  for (const double difference : differences) {
    if (difference == 0.0) continue;
    sizes.push_back(std::abs(difference));
    signs.push_back(difference > 0.0 ? 1.0 : -1.0);
  }
  const std::vector<double> ranks = midranks(sizes);
  SignedRankTest test{.n = sizes.size()};
  double all = 0.0;
  std::vector<std::int64_t> twice{};  // midranks are halves
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    all += ranks[i];
    if (signs[i] > 0.0) test.positive += ranks[i];
    twice.push_back(static_cast<std::int64_t>(2.0 * ranks[i] * signs[i]));
  }
  const SignFlipTest flips = sign_flip_test(twice);
  test.p = flips.two_sided;
  test.exact = flips.exact;
  test.drawn = flips.drawn;
  test.rank_biserial = test.n > 0 ? (2.0 * test.positive - all) / all : kNoValue;
  return test;
}

}  // namespace asperity
