// Isotonic regression of proportions and of their limits; linear interpolation between sizes.

#include "analysis/power/smallest_sample.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "analysis/numbers/isotonic_regression.h"
#include "analysis/numbers/number_text.h"

namespace asperity {

std::vector<PowerOfSize> monotone_power(std::span<const StudiesOfSize> studies, double confidence) {
  if (studies.empty()) throw std::invalid_argument("there is no size; give at least one");
  std::vector<PowerOfSize> curve{};
  std::vector<double> power{};
  std::vector<double> low{};
  std::vector<double> high{};
  std::vector<double> weights{};
  for (const StudiesOfSize& one : studies) {
    if (!curve.empty() && curve.back().participants >= one.participants) {
      throw std::invalid_argument("the size " + std::to_string(one.participants) + " follows " +
                                  std::to_string(curve.back().participants) +
                                  "; sizes must ascend");
    }
    curve.push_back({.participants = one.participants,
                     .power = proportion(one.significant),
                     .interval = clopper_pearson_interval(one.significant, confidence)});
    power.push_back(curve.back().power);
    low.push_back(curve.back().interval.low);
    high.push_back(curve.back().interval.high);
    weights.push_back(static_cast<double>(one.significant.trials));
  }
  power = isotonic_regression(power, weights);
  low = isotonic_regression(low, weights);
  high = isotonic_regression(high, weights);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i].fitted = power[i];
    curve[i].fitted_interval = {.low = low[i], .high = high[i]};
  }
  return curve;
}

SmallestSample smallest_sample(std::span<const PowerOfSize> curve, double power) {
  if (curve.empty()) throw std::invalid_argument("the curve has no size; give at least one");
  if (!(power > 0.0 && power < 1.0)) {
    throw std::invalid_argument("power is " + number_text(power) + "; it must lie between 0 and 1");
  }
  // The number of participants at which a nondecreasing number of each size reaches the power; the smallest size where it has it
  // already.
  const auto reached_at = [&](const auto& of_size) -> std::optional<double> {
    const auto next = std::find_if(curve.begin(), curve.end(),
                                   [&](const PowerOfSize& one) { return of_size(one) >= power; });
    if (next == curve.end()) return std::nullopt;
    if (next == curve.begin()) return next->participants;
    const PowerOfSize& before = *std::prev(next);
    const double part = (power - of_size(before)) / (of_size(*next) - of_size(before));
    return before.participants + part * (next->participants - before.participants);
  };
  const auto fitted = [](const PowerOfSize& one) { return one.fitted; };
  const auto lower = [](const PowerOfSize& one) { return one.fitted_interval.low; };
  const auto upper = [](const PowerOfSize& one) { return one.fitted_interval.high; };
  SmallestSample sample{.participants = reached_at(fitted), .high = reached_at(lower)};
  if (upper(curve.front()) < power) sample.low = reached_at(upper);
  if (sample.participants) {
    sample.reached = fitted(curve.front()) >= power ? PowerReached::at_first : PowerReached::within;
  }
  return sample;
}

}  // namespace asperity
