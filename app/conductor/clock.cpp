#include "app/conductor/clock.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <stdexcept>

#include "renderers/servo_thread.h"

namespace asperity {

std::string utc_text(std::int64_t since_1970_ns) {
  // Rounded down, also before 1970.
  const auto time = std::chrono::floor<std::chrono::milliseconds>(
      std::chrono::sys_time<std::chrono::nanoseconds>(std::chrono::nanoseconds(since_1970_ns)));
  const auto whole = std::chrono::floor<std::chrono::seconds>(time);
  const auto seconds = static_cast<std::time_t>(whole.time_since_epoch().count());
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  const auto padded = [](std::int64_t number, std::size_t width) {
    std::string digits = std::to_string(number);
    if (digits.size() < width) digits.insert(0, width - digits.size(), '0');
    return digits;
  };
  return padded(parts.tm_year + 1900, 4) + '-' + padded(parts.tm_mon + 1, 2) + '-' +
         padded(parts.tm_mday, 2) + 'T' + padded(parts.tm_hour, 2) + ':' + padded(parts.tm_min, 2) +
         ':' + padded(parts.tm_sec, 2) + '.' + padded((time - whole).count(), 3) + 'Z';
}

SystemClock::SystemClock(std::int64_t not_before_ns)
    : ahead_ns_(std::max<std::int64_t>(0, not_before_ns - monotonic_now_ns())) {}

std::int64_t SystemClock::now_ns() const noexcept { return monotonic_now_ns() + ahead_ns_; }

std::string SystemClock::utc() const {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return utc_text(std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count());
}

std::string SimulatedClock::utc() const { return utc_text(kEpoch_s * 1'000'000'000 + now_ns()); }

void SimulatedClock::move_to(std::int64_t now_ns) {
  if (now_ns < now_ns_) throw std::logic_error("a simulated clock cannot go back");
  now_ns_ = now_ns;
}

}  // namespace asperity
