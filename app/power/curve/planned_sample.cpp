#include "app/power/curve/planned_sample.h"

namespace asperity {

PlannedSample planned_sample(const PowerCurve& curve, double power, const SampleRules& rules) {
  std::vector<PowerOfSize> of_sizes{};
  for (const TestAtSize& size : curve.sizes) of_sizes.push_back(size.power);
  PlannedSample sample{.power = power, .smallest = smallest_sample(of_sizes, power)};
  if (!sample.smallest.participants) return sample;
  sample.planned = rounded_up_to_multiple(*sample.smallest.participants, rules.multiple);
  sample.recruited = recruitment(*sample.planned, rules.attrition, kAssurance);
  return sample;
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
