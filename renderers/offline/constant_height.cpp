// A bracket in growing steps, then a root.

#include "renderers/offline/constant_height.h"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

namespace asperity {
namespace {

constexpr std::uintmax_t kIterations = 200;
constexpr double kFarthest_m = 0.1;  // more than any texture or hand

struct Bracket {
  double low = 0.0;
  double high = 0.0;
};

}  // namespace

ConstantHeight constant_height(const std::function<double(double height_m)>& mean_normal_N,
                               const HeightSearch& search) {
  const auto excess = [&](double height_m) {
    return mean_normal_N(height_m) / search.force_N - 1.0;
  };
  double step_m = search.force_N / search.stiffness_N_per_m;
  Bracket height_m{-step_m, -step_m};
  Bracket value{excess(height_m.low), 0.0};
  value.high = value.low;
  while (value.high > 0.0 && height_m.high < kFarthest_m) {
    height_m.low = height_m.high;
    value.low = value.high;
    height_m.high += step_m;
    value.high = excess(height_m.high);
    step_m *= 2.0;
  }
  while (value.low < 0.0 && height_m.low > -kFarthest_m) {
    height_m.high = height_m.low;
    value.high = value.low;
    height_m.low -= step_m;
    value.low = excess(height_m.low);
    step_m *= 2.0;
  }
  double reached = value.low < 0.0 ? value.low : value.high;
  if (value.low >= 0.0 && value.high <= 0.0) {
    double root_m = value.low == 0.0 ? height_m.low : height_m.high;
    if (value.low > 0.0 && value.high < 0.0) {
      std::uintmax_t iterations = kIterations;
      const auto [low_m, high_m] = boost::math::tools::toms748_solve(
          excess, height_m.low, height_m.high, value.low, value.high,
          boost::math::tools::eps_tolerance<double>(search.height_bits), iterations);
      root_m = std::abs(excess(low_m)) < std::abs(excess(high_m)) ? low_m : high_m;
    }
    reached = excess(root_m);
    if (std::abs(reached) <= search.tolerance) {
      return {.height_m = root_m, .reached_N = (1.0 + reached) * search.force_N};
    }
  }
  return {.height_m = {}, .reached_N = (1.0 + reached) * search.force_N};
}

}  // namespace asperity
