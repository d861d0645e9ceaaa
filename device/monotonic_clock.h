// The clock that ticks, readings and records are stamped by.

#pragma once

#include <cstdint>

#include <time.h>

namespace asperity {

/// Nanoseconds of CLOCK_MONOTONIC, which std::chrono::steady_clock is on Linux as well.
///
/// Real-time: does not allocate, lock or throw.
inline std::int64_t monotonic_now_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

}  // namespace asperity
