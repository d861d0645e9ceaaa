// Declares the arithmetic of the servo's time: the interval between samples and the next deadline.

#pragma once

#include <cstdint>

namespace asperity {

/// The period of a rate in whole nanoseconds, at least 1.
std::int64_t period_ns_of(double rate_Hz) noexcept;

/// The time between two samples, clamped to [½, 4] periods, so that neither two samples with the same time stamp nor a
/// stall passes an absurd interval to a renderer. The servo loop and all offline code use this
/// function, which makes recordings replay exactly.
double clamped_dt_s(std::int64_t previous_ns, std::int64_t now_ns, double rate_Hz) noexcept;

/// When a tick is due and when the thread wakes for it; equal unless a deadline was missed.
struct NextTick {
  std::int64_t due_ns = 0;
  std::int64_t wake_ns = 0;
};

/// Computes the tick that follows one that began at `started_ns` and ended at `finished_ns`.
///
/// Deadlines lie on the unlimited grid first + n·period. The next deadline is the first grid point after the start. If
/// the tick overran it, the thread wakes at the first grid point after the end, for the missed deadline: the recorded
/// lateness is correct, the miss is counted once, and no tick is made up for.
struct DeadlineGrid {
  std::int64_t first_ns = 0;
  std::int64_t period_ns = 1;

  NextTick after(std::int64_t started_ns, std::int64_t finished_ns) const noexcept;
};

}  // namespace asperity
