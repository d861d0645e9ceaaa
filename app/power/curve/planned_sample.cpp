// Interpolates the fitted power between simulated numbers, and rounds the sample up to whole multiples.

#include "app/power/curve/planned_sample.h"

#include <algorithm>
#include <iterator>

namespace asperity {

namespace {

/// Of people.
std::optional<std::size_t> whole(const std::optional<double>& participants) {
  if (!participants) return std::nullopt;
  return rounded_up_to_multiple(*participants, 1);
}

double between(double low, double high, double fraction) { return low + fraction * (high - low); }

}  // namespace

PlannedSample planned_sample(const PowerCurve& curve, double power, const SampleRules& rules) {
  std::vector<PowerOfSize> of_sizes{};
  for (const TestAtSize& size : curve.sizes) of_sizes.push_back(size.power);
  const SmallestSample smallest = smallest_sample(of_sizes, power);
  PlannedSample sample{.power = power,
                       .reached = smallest.reached,
                       .participants = whole(smallest.participants),
                       .low = whole(smallest.low),
                       .high = whole(smallest.high)};
  if (!smallest.participants) return sample;
  sample.planned = rounded_up_to_multiple(*smallest.participants, rules.multiple);
  sample.recruited = recruitment(*sample.planned, rules.attrition, kAssurance);
  return sample;
}

PowerEstimate power_at(const PowerCurve& curve, std::size_t participants) {
  const auto number = [](const TestAtSize& size) {
    return static_cast<std::size_t>(size.power.participants);
  };
  const auto above =
      std::find_if(curve.sizes.begin(), curve.sizes.end(),
                   [&](const TestAtSize& size) { return number(size) >= participants; });
  const PowerOfSize& upper = above == curve.sizes.end() ? curve.sizes.back().power : above->power;
  const bool is_between =
      above != curve.sizes.begin() && above != curve.sizes.end() && number(*above) != participants;
  const PowerOfSize& lower = is_between ? std::prev(above)->power : upper;
  const double fraction = is_between ? (static_cast<double>(participants) - lower.participants) /
                                           (upper.participants - lower.participants)
                                     : 0.0;
  return {
      .power = between(lower.fitted, upper.fitted, fraction),
      .interval = {.low = between(lower.fitted_interval.low, upper.fitted_interval.low, fraction),
                   .high =
                       between(lower.fitted_interval.high, upper.fitted_interval.high, fraction)},
      .below = lower.participants,
      .above = upper.participants};
}

const char* code_of(PowerReached reached) noexcept {
  switch (reached) {
    case PowerReached::within:
      return "ok";
    case PowerReached::at_first:
      return "at_first_size";
    case PowerReached::beyond_sizes:
      return "not_reached";
  }
  return "";
}

}  // namespace asperity
