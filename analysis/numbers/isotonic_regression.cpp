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
  struct Block {
    double mean = 0.0;
    double weight = 0.0;
    std::size_t length = 0;
  };
  std::vector<Block> blocks{};
  blocks.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(weights[i] > 0.0))
      throw std::invalid_argument("weights: a weight is not above 0; all must be above 0");
    blocks.push_back({.mean = values[i], .weight = weights[i], .length = 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean > blocks.back().mean) {
      const Block later = blocks.back();
      blocks.pop_back();
      Block& pooled = blocks.back();
      const double weight = pooled.weight + later.weight;
      pooled.mean = (pooled.weight * pooled.mean + later.weight * later.mean) / weight;
      pooled.weight = weight;
      pooled.length += later.length;
    }
  }
  std::vector<double> fitted{};
  fitted.reserve(values.size());
  for (const Block& block : blocks) fitted.insert(fitted.end(), block.length, block.mean);
  return fitted;
}

}  // namespace asperity
