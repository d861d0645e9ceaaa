// Adds an offset to the monotonic clock, so that the time of a resumed session never decreases.

#include "app/session/rig/clock.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "app/words/utc_time.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

SystemClock::SystemClock(std::int64_t not_before_ns)
    : ahead_ns_(std::max<std::int64_t>(0, not_before_ns - monotonic_now_ns())) {}

std::int64_t SystemClock::now_ns() const noexcept { return monotonic_now_ns() + ahead_ns_; }

std::string SystemClock::utc() const {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return utc_text(std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count());
}

std::string SimulatedClock::utc() const { return utc_text(kEpoch_s * 1'000'000'000 + now_ns()); }

void SimulatedClock::move_to(std::int64_t now_ns) {
  if (now_ns < now_ns_)
    throw std::logic_error("now_ns is " + std::to_string(now_ns) +
                           "; it must be at least the present time of the simulated clock, " +
                           std::to_string(now_ns_.load()));
  now_ns_ = now_ns;
}

}  // namespace asperity
