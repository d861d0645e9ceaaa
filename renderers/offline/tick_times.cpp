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

}  // namespace

std::optional<std::int64_t> TickTimes::quantile_ns(double fraction) const {
  if (undisturbed_ns.empty()) return std::nullopt;
  const double last = static_cast<double>(undisturbed_ns.size() - 1);
  return undisturbed_ns[static_cast<std::size_t>(std::llround(fraction * last))];
}

TickTimes time_ticks(const TickCount& count, const std::function<void(int)>& tick,
                     const std::stop_token& stop) {
  TickTimes times;
  times.undisturbed_ns.reserve(static_cast<std::size_t>(count.counted));
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
    if (may_switch || context_switches() == switches) {
      times.undisturbed_ns.push_back(took_ns);
    } else {
      ++times.preempted;
    }
  }
  std::sort(times.undisturbed_ns.begin(), times.undisturbed_ns.end());
  return times;
}

}  // namespace asperity
