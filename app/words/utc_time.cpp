// Formats milliseconds since 1970 with a Z at the end, and counts the days of such a date.

#include "app/words/utc_time.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>

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

double days_since_1970(const std::string& utc) {
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  int second = 0;
  if (std::sscanf(utc.c_str(), "%4d-%2d-%2dT%2d:%2d:%2d", &year, &month, &day, &hour, &minute,
                  &second) != 6) {
    throw std::invalid_argument("\"" + utc + "\" is not a date; it must have the form " +
                                "2026-01-01T00:00:00Z");
  }
  // The year is counted from March, so that leap days come last.
  const int shifted_year = month <= 2 ? year - 1 : year;
  const int shifted_month = month <= 2 ? month + 9 : month - 3;
  const int days = 365 * shifted_year + shifted_year / 4 - shifted_year / 100 + shifted_year / 400 +
                   (153 * shifted_month + 2) / 5 + day - 1;
  constexpr int kDaysTo1970 = 719468;
  return days - kDaysTo1970 + (hour + (minute + second / 60.0) / 60.0) / 24.0;
}

}  // namespace asperity
