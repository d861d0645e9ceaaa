// Declares the measurement of what each tick takes.

#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace asperity {

/// How many ticks are measured, and how.
struct TickCount {
  int warm_up = 500;  ///< not counted
  int counted = 5'000;
  /// No tick begins after this time since the first one, and none of the warm-up after a tenth of it. At least one is counted.
  std::chrono::nanoseconds longest = std::chrono::hours(24);
  /// Memory that is written before each tick, so that the caches do not contain what the tick needs: 0 for warm caches.
  std::size_t evicted_bytes = 0;
  /// Whether a tick waits for another processor, so that the kernel may run other threads meanwhile as a part of the tick.
  enum class Waits { never, for_device } waits = Waits::never;
};

/// What ticks took.
struct TickTimes {
  std::vector<std::int64_t> undisturbed_ns{};  ///< ascending
  /// Ticks that are left out because the kernel gave the processor to another thread meanwhile: they measure the machine. None
  /// where a tick waits for a device.
  std::int64_t preempted = 0;

  /// The time that so large a fraction of the ticks did not exceed: 0.5 for the median, 1 for the maximum. nullopt without ticks.
  std::optional<std::int64_t> quantile_ns(double fraction) const;
  /// The number of ticks that took more than so many times as long as the median.
  std::int64_t longer_than_medians(double factor) const;
};

/// Calls tick(0), tick(1), … in this thread: first the ones of the warm-up, then the ones that are counted, each timed alone with the
/// monotonic clock. When a stop is requested, the ticks until then are returned.
TickTimes time_ticks(const TickCount& count, const std::function<void(int)>& tick,
                     const std::stop_token& stop = {});

/// A motion that can be repeated: `restart` puts what is timed in the state in which tick(0) finds it.
struct RepeatedTicks {
  std::function<void()> restart{};
  std::function<void(int)> tick{};
};

/// The shortest time of each tick over repetitions of the same motion, of which other programs disturb different ticks. What
/// every repetition of a tick needs remains: the ticks with more work are the long ones. `preempted` are ticks that no repetition
/// timed undisturbed.
TickTimes shortest_of_ticks(const TickCount& count, int repetitions, const RepeatedTicks& motion);

}  // namespace asperity
