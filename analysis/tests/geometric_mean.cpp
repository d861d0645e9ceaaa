// Applies the one-sample t interval to logarithms.

#include "analysis/tests/geometric_mean.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/t_test.h"

namespace asperity {

GeometricMean geometric_mean(std::span<const double> numbers, double confidence) {
  std::vector<double> logarithms{};
  logarithms.reserve(numbers.size());
  for (const double number : numbers) {
    if (!std::isfinite(number) || number <= 0.0) {
      throw std::invalid_argument("numbers contains " + number_text(number) +
                                  "; a geometric mean requires finite numbers above 0");
    }
    logarithms.push_back(std::log(number));
  }
  const OneSampleT t = one_sample_t(logarithms, {.confidence = confidence});
  GeometricMean made{.n = t.n, .mean = std::exp(t.mean)};
  if (t.test) {
    made.interval = ConfidenceInterval{.low = std::exp(t.test->interval.low),
                                       .high = std::exp(t.test->interval.high)};
  }
  return made;
}

}  // namespace asperity
