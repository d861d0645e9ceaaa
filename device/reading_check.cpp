// Implements the check that a reading of the hand is plausible.

#include "device/reading_check.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "device/small_turn.h"

namespace asperity {

namespace {

constexpr glm::dquat kIdentity{1.0, 0.0, 0.0, 0.0};

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace

template <typename Value>
const typename ReadingCheck::Past<Value>::Accepted& ReadingCheck::Past<Value>::before(
    std::int64_t time_ns) const noexcept {
  std::size_t index = newest_index;
  for (std::size_t back = 1;
       back < count && seconds_between(accepted[index].time_ns, time_ns) < kShortest_s; ++back) {
    index = (index + accepted.size() - 1) % accepted.size();
  }
  return accepted[index];
}

double ReadingCheck::farthest_m(std::int64_t from_ns, std::int64_t to_ns) const noexcept {
  return maximum_m_per_s_ * std::max(seconds_between(from_ns, to_ns), kShortest_s);
}

bool ReadingCheck::is_plausible(const ProbeState& reading, std::int64_t at_ns) const noexcept {
  if (positions_m_.count > 0) {
    const auto& from = positions_m_.before(at_ns);
    if (glm::distance(reading.position_m, from.value) > farthest_m(from.time_ns, at_ns))
      return false;
  }
  if (orientations_.count == 0 || reading.orientation == orientations_.newest().value) return true;
  const auto& from = orientations_.before(at_ns);
  return kReach_m * glm::length(small_turn_rad(from.value, reading.orientation)) <=
         farthest_m(from.time_ns, at_ns);
}

bool ReadingCheck::is_paused(const ProbeState& reading) const noexcept {
  return is_moving_ && reading.position_m == positions_m_.newest().value &&
         reading.time_ns - positions_m_.newest().time_ns <= kLongestPause_ns;
}

void ReadingCheck::accept(const ProbeState& reading) noexcept {
  if (positions_m_.count == 0 || !is_paused(reading)) {
    if (positions_m_.count == 0 || reading.position_m != positions_m_.newest().value)
      is_moving_ = glm::length(reading.velocity_m_per_s) > kMoving_m_per_s;
    else
      is_moving_ = false;  // at rest
    positions_m_.add(reading.time_ns, reading.position_m);
  }
  const bool is_turned = orientations_.count == 0
                             ? reading.orientation != kIdentity
                             : reading.orientation != orientations_.newest().value;
  if (is_turned) orientations_.add(reading.time_ns, reading.orientation);
}

void ReadingCheck::restart() noexcept {
  positions_m_ = {};
  orientations_ = {};
  is_moving_ = false;
  is_holding_ = false;
}

ReadingCheck::Verdict ReadingCheck::judge(const ProbeState& reading, Origin origin) noexcept {
  if (is_plausible(reading, is_holding_ ? held_since_ns_ : reading.time_ns)) {
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
