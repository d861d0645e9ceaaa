// Implements a search for a bracket in growing steps, followed by a root search.

#include "renderers/offline/constant_height.h"

#include <cmath>

#include "renderers/offline/bracketed_root.h"

namespace asperity {
namespace {

constexpr double kFarthest_m = 0.1;  // more than any texture or hand

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
    const double root_m = root_of(excess, height_m, value, search.height_bits);
    reached = excess(root_m);
    if (std::abs(reached) <= search.tolerance) {
      return {.height_m = root_m, .reached_N = (1.0 + reached) * search.force_N};
    }
  }
  return {.height_m = {}, .reached_N = (1.0 + reached) * search.force_N};
}

}  // namespace asperity
