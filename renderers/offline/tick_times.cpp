// Times each tick on its own, and leaves out those during which the thread was preempted.

#include "renderers/offline/tick_times.h"

#include <algorithm>
#include <cmath>
#include <sys/resource.h>

#include "device/monotonic_clock.h"

namespace asperity {

namespace {

std::int64_t context_switches() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_nivcsw + usage.ru_nvcsw;
}

/// nullopt for a tick that was preempted.
using TimedTick = std::optional<std::int64_t>;

std::vector<TimedTick> each_tick(const TickCount& count, const std::function<void(int)>& tick,
                                 const std::stop_token& stop) {
  std::vector<TimedTick> ticks;
  ticks.reserve(static_cast<std::size_t>(count.counted));
  std::vector<char> others(count.evicted_bytes);
  const std::int64_t begun_ns = monotonic_now_ns();
  const std::int64_t longest_ns = count.longest.count();
  int next = 0;
  for (; next < count.warm_up && !stop.stop_requested(); ++next) {
    if (monotonic_now_ns() - begun_ns > longest_ns / 10) break;
    tick(next);
  }
  const bool may_switch = count.waits == TickCount::Waits::for_device;
  for (int i = 0; i < count.counted && !stop.stop_requested(); ++i) {
    if (i > 0 && monotonic_now_ns() - begun_ns > longest_ns) break;
    for (std::size_t byte = 0; byte < others.size(); byte += 64) ++others[byte];
    const std::int64_t switches = context_switches();
    const std::int64_t started_ns = monotonic_now_ns();
    tick(next + i);
    const std::int64_t took_ns = monotonic_now_ns() - started_ns;
    const bool is_undisturbed = may_switch || context_switches() == switches;
    ticks.push_back(is_undisturbed ? TimedTick(took_ns) : std::nullopt);
  }
  return ticks;
}

TickTimes in_order_of_time(const std::vector<TimedTick>& ticks) {
  TickTimes times;
  times.undisturbed_ns.reserve(ticks.size());
  for (const TimedTick& tick : ticks) {
    if (tick) {
      times.undisturbed_ns.push_back(*tick);
    } else {
      ++times.preempted;
    }
  }
  std::sort(times.undisturbed_ns.begin(), times.undisturbed_ns.end());
  return times;
}

}  // namespace

std::optional<std::int64_t> TickTimes::quantile_ns(double fraction) const {
  if (undisturbed_ns.empty()) return std::nullopt;
  const double last = static_cast<double>(undisturbed_ns.size() - 1);
  return undisturbed_ns[static_cast<std::size_t>(std::llround(fraction * last))];
}

std::int64_t TickTimes::longer_than_medians(double factor) const {
  const auto median_ns = quantile_ns(0.5);
  if (!median_ns) return 0;
  const double most_ns = factor * static_cast<double>(*median_ns);
  const auto first = std::upper_bound(
      undisturbed_ns.begin(), undisturbed_ns.end(), most_ns,
      [](double most, std::int64_t took_ns) { return most < static_cast<double>(took_ns); });
  return undisturbed_ns.end() - first;
}

TickTimes time_ticks(const TickCount& count, const std::function<void(int)>& tick,
                     const std::stop_token& stop) {
  return in_order_of_time(each_tick(count, tick, stop));
}

TickTimes shortest_of_ticks(const TickCount& count, int repetitions, const RepeatedTicks& motion) {
  std::vector<TimedTick> shortest;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    motion.restart();
    const std::vector<TimedTick> ticks = each_tick(count, motion.tick, {});
    shortest.resize(std::max(shortest.size(), ticks.size()));
    for (std::size_t i = 0; i < ticks.size(); ++i) {
      if (ticks[i] && (!shortest[i] || *ticks[i] < *shortest[i])) shortest[i] = ticks[i];
    }
  }
  return in_order_of_time(shortest);
}

}  // namespace asperity
