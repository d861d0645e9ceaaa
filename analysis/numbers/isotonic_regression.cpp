// Pools adjacent violators.

#include "analysis/numbers/isotonic_regression.h"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace asperity {

std::vector<double> isotonic_regression(std::span<const double> values,
                                        std::span<const double> weights) {
  if (values.size() != weights.size()) {
    throw std::invalid_argument("weights has " + std::to_string(weights.size()) +
                                " numbers; there must be one for each of the " +
                                std::to_string(values.size()) + " values");
  }
  for (const double weight : weights) {
    if (!(weight > 0.0))
      throw std::invalid_argument("weights: a weight is not above 0; all must be above 0");
  }
  std::vector<double> fitted(values.size());
  IsotonicRegression(values.size()).fit(values, weights, fitted);
  return fitted;
}

IsotonicRegression::IsotonicRegression(std::size_t most) : blocks_(most) {}

void IsotonicRegression::fit(std::span<const double> values, std::span<const double> weights,
                             std::span<double> fitted) {
  const double* const x = values.data();
  const double* const w = weights.data();
  Block* const blocks = blocks_.data();
  const std::size_t length = values.size();
  std::size_t number = 0;
  for (std::size_t i = 0; i < length; ++i) {
    // The last block is in registers until no earlier one has a greater mean.
    double mean = x[i];
    double weight = w[i];
    while (number > 0 && blocks[number - 1].mean > mean) {
      const Block& earlier = blocks[--number];
      const double sum = earlier.weight + weight;
      mean = (earlier.weight * earlier.mean + weight * mean) / sum;
      weight = sum;
    }
    blocks[number++] = {.mean = mean, .weight = weight, .end = i + 1};
  }
  double* const made = fitted.data();
  std::size_t i = 0;
  for (std::size_t block = 0; block < number; ++block) {
    const Block of = blocks[block];
    for (; i < of.end; ++i) made[i] = of.mean;
  }
}

}  // namespace asperity
