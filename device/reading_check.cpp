// Implements the check that a reading of the hand is plausible.

#include "device/reading_check.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "device/small_turn.h"

namespace asperity {

bool ReadingCheck::is_plausible(const ProbeState& reading) const noexcept {
  if (count_ == 0) return true;
  const Accepted* from = nullptr;
  double elapsed_s = 0.0;
  for (std::size_t back = 0; back < count_ && elapsed_s < kShortest_s; ++back) {
    from = &accepted_[(newest_ + accepted_.size() - back) % accepted_.size()];
    elapsed_s = 1e-9 * static_cast<double>(reading.time_ns - from->time_ns);
  }
  const double farthest_m = maximum_m_per_s_ * std::max(elapsed_s, kShortest_s);
  return glm::distance(reading.position_m, from->position_m) <= farthest_m &&
         kReach_m * glm::length(small_turn_rad(from->orientation, reading.orientation)) <=
             farthest_m;
}

void ReadingCheck::accept(const ProbeState& reading) noexcept {
  newest_ = (newest_ + 1) % accepted_.size();
  accepted_[newest_] = {reading.time_ns, reading.position_m, reading.orientation};
  count_ = std::min(count_ + 1, accepted_.size());
}

void ReadingCheck::restart(const ProbeState& reading) noexcept {
  count_ = 0;
  is_holding_ = false;
  accept(reading);
}

ReadingCheck::Verdict ReadingCheck::judge(const ProbeState& reading, Origin origin) noexcept {
  if (is_plausible(reading)) {
    is_holding_ = false;
    if (origin == Origin::fresh) accept(reading);
    return Verdict::plausible;
  }
  if (!is_holding_) {
    is_holding_ = true;
    held_since_ns_ = reading.time_ns;
  }
  return reading.time_ns - held_since_ns_ < kLongestHold_ns ? Verdict::held : Verdict::lost;
}

}  // namespace asperity
