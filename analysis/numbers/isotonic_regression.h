// Isotonic regression: the nondecreasing numbers that are nearest to given ones.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// The x̂_1 ≤ x̂_2 ≤ … that minimise Σ w_i·(x_i − x̂_i)², by pooling adjacent violators [Barlow 1972]: blocks of
/// neighbours in the wrong order are replaced by their weighted mean, until no two are. Every block keeps its mean, so
/// that Σ w·x̂ = Σ w·x.
///
/// Throws std::invalid_argument where the lengths differ and for a weight that is not above 0.
///
/// [Barlow 1972] Barlow, Bartholomew, Bremner, Brunk: Statistical Inference under Order Restrictions.
std::vector<double> isotonic_regression(std::span<const double> values,
                                        std::span<const double> weights);

/// The same regression of up to `most` values without allocations, for methods that repeat it thousands of times.
class IsotonicRegression {
 public:
  explicit IsotonicRegression(std::size_t most);

  /// All three have the same length, at most `most`, and all weights are above 0: nothing is checked. `fitted` may be `values`.
  void fit(std::span<const double> values, std::span<const double> weights,
           std::span<double> fitted);

 private:
  struct Block {
    double mean = 0.0;
    double weight = 0.0;
    std::size_t end = 0;  ///< of its values
  };
  std::vector<Block> blocks_{};
};

}  // namespace asperity
