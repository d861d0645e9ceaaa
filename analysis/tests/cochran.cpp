// Cochran's Q in integers, with χ² and exact p; McNemar's test as a binomial test, bounded over all joint counts.

#include "analysis/tests/cochran.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/numbers/matrix_place.h"
#include "analysis/numbers/tail_probabilities.h"

namespace asperity {

CochranTest cochran_test(const CountMatrix& answers) {
  if (answers.cols() < 1)
    throw std::invalid_argument("answers has no column; at least one condition is needed");
  if (answers.size() > 0 && (answers.minCoeff() < 0 || answers.maxCoeff() > 1)) {
    throw std::invalid_argument(
        "answers: the value in " +
        place_of_first(answers, [](auto value) { return value < 0 || value > 1; }) +
        " is not 0 or 1; all must be 0 or 1");
  }
  CochranTest test{.df = static_cast<double>(answers.cols() - 1)};
  const std::int64_t conditions = answers.cols();
  const std::int64_t total = answers.sum();
  const std::int64_t of_columns = answers.colwise().sum().array().square().sum();
  const std::int64_t of_rows = answers.rowwise().sum().array().square().sum();
  const std::int64_t denominator = conditions * total - of_rows;
  if (denominator == 0) {
    test.q = test.p = test.exact_p = std::numeric_limits<double>::quiet_NaN();
    return test;
  }
  test.q = test.df * static_cast<double>(conditions * of_columns - total * total) /
           static_cast<double>(denominator);
  test.p = upper_tail(ChiSquaredStatistic{.value = test.q, .df = test.df})
               .value_or(std::numeric_limits<double>::quiet_NaN());
  const RelabellingTest exact = relabelling_test(answers);
  test.exact_p = exact.p;
  test.counted = exact.exact;
  test.drawn = exact.drawn;
  return test;
}

double mcnemar_test(const Discordance& discordance) {
  const std::uint64_t both = discordance.only_first + discordance.only_second;
  return both == 0 ? 1.0 : binomial_test({.hits = discordance.only_first, .trials = both}, 0.5);
}

ConfidenceInterval mcnemar_bounds(const McNemarMargins& margins) {
  if (std::max(margins.first, margins.second) > margins.participants) {
    throw std::invalid_argument("margins: first is " + std::to_string(margins.first) +
                                ", second is " + std::to_string(margins.second) +
                                " and participants is " + std::to_string(margins.participants) +
                                "; first and second must not exceed participants");
  }
  // Of those who say yes first, all but `both` say so only then.
  const std::uint64_t most = std::min(margins.first, margins.second);
  const std::uint64_t sum = margins.first + margins.second;
  const std::uint64_t least = sum > margins.participants ? sum - margins.participants : 0;
  ConfidenceInterval bounds{.low = 1.0, .high = 0.0};
  for (std::uint64_t both = least; both <= most; ++both) {
    const double p =
        mcnemar_test({.only_first = margins.first - both, .only_second = margins.second - both});
    bounds.low = std::min(bounds.low, p);
    bounds.high = std::max(bounds.high, p);
  }
  return bounds;
}

}  // namespace asperity
