// The arithmetic of the servo's time: how long a tick lasted, and when the next one is due.

#pragma once

#include <cstdint>

namespace asperity {

/// The period of a rate in whole nanoseconds, at least 1.
std::int64_t period_ns_of(double rate_Hz) noexcept;

/// Time between two samples of the hand, clamped to [½, 4] periods, so that neither two samples
/// with one time stamp nor a stall can tell a renderer or a slew limit something absurd. The servo
/// loop and everything offline use this one function: a recorded run replays because of it.
double clamped_dt_s(std::int64_t previous_ns, std::int64_t now_ns, double rate_Hz) noexcept;

/// When a tick should begin and when the thread wakes for it; the same unless a deadline was
/// missed.
struct NextTick {
  std::int64_t due_ns = 0;
  std::int64_t wake_ns = 0;
};

/// The tick after one that began at `started_ns` and ended at `finished_ns`.
///
/// Deadlines lie on the grid first + n·period, for ever. The next one is due at the first point of
/// the grid after the start. If the tick overran it, the thread wakes at the first point of the
/// grid after the end, for the deadline that it missed: the lateness tells the truth, the miss is
/// counted once, and no tick is made up.
struct DeadlineGrid {
  std::int64_t first_ns = 0;
  std::int64_t period_ns = 1;

  NextTick after(std::int64_t started_ns, std::int64_t finished_ns) const noexcept;
};

}  // namespace asperity
