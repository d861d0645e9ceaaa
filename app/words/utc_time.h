// Formats dates for storage: UTC, ISO 8601.

#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// Nanoseconds since 1970 as UTC ISO 8601 with milliseconds.
std::string utc_text(std::int64_t since_1970_ns);
/// Days since 1970 of a date in UTC ISO 8601, read to the second. Errors: std::invalid_argument for another text.
double days_since_1970(const std::string& utc);

}  // namespace asperity
