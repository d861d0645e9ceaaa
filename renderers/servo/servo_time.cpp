// Implements the arithmetic of periods, sample intervals and deadlines.

#include "renderers/servo/servo_time.h"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

constexpr double kShortestTick_periods = 0.5;
constexpr double kLongestTick_periods = 4.0;

}  // namespace

std::int64_t period_ns_of(double rate_Hz) noexcept {
  return std::max<std::int64_t>(1, std::llround(1e9 / rate_Hz));
}

double clamped_dt_s(std::int64_t previous_ns, std::int64_t now_ns, double rate_Hz) noexcept {
  const double period_s = 1.0 / rate_Hz;
  const double elapsed_s = static_cast<double>(now_ns - previous_ns) * 1e-9;
  return std::clamp(elapsed_s, kShortestTick_periods * period_s, kLongestTick_periods * period_s);
}

NextTick DeadlineGrid::after(std::int64_t started_ns, std::int64_t finished_ns) const noexcept {
  const auto first_point_after = [this](std::int64_t time_ns) {
    if (time_ns < first_ns) return first_ns;
    return first_ns + ((time_ns - first_ns) / period_ns + 1) * period_ns;
  };
  const std::int64_t due_ns = first_point_after(started_ns);
  return {due_ns, finished_ns <= due_ns ? due_ns : first_point_after(finished_ns)};
}

}  // namespace asperity
