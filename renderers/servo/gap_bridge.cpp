// Implements how the force continues after a gap between two ticks.

#include "renderers/servo/gap_bridge.h"

#include <algorithm>

#include "device/force_limiter.h"

namespace asperity {

void GapBridge::begin(const Wrench& sent, double gap_s) noexcept {
  const double bridged_s = std::clamp(gap_s, kShortest_s, kLongest_s);
  const double rest_s = length_s_ - passed_s_;
  const bool continues = rest_s > 0.0 && bridged_s <= gap_s_;
  from_ = sent;
  gap_s_ = continues ? std::max(rest_s, bridged_s) : bridged_s;
  length_s_ = continues ? (rest_s * rest_s + passed_s_ * bridged_s) / length_s_ : bridged_s;
  passed_s_ = 0.0;
}

Wrench GapBridge::approach(const Wrench& wanted, double elapsed_s) noexcept {
  passed_s_ = std::min(passed_s_ + std::max(elapsed_s, 0.0), length_s_);
  if (passed_s_ >= length_s_) return wanted;
  const double share = passed_s_ / length_s_;
  from_.force_N = nearest_on_fall(from_.force_N, wanted.force_N);
  from_.torque_N_m = nearest_on_fall(from_.torque_N_m, wanted.torque_N_m);
  return {.force_N = from_.force_N + share * (wanted.force_N - from_.force_N),
          .torque_N_m = from_.torque_N_m + share * (wanted.torque_N_m - from_.torque_N_m)};
}

}  // namespace asperity
