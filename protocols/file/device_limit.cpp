// Implements the checks of limits on a device.

#include "protocols/file/device_limit.h"

#include <cmath>
#include <cstdint>

#include <nlohmann/json.hpp>

#include "protocols/design/wording.h"
#include "protocols/keys/tables.h"
#include "protocols/keys/valid_part.h"

namespace asperity {

std::optional<Phrase> complaint_about(const DeviceLimit& limit, double rate_Hz) {
  if (!std::isfinite(limit.limit)) return phrase("Protocols", "a limit must be a finite number");
  nlohmann::json number = limit.limit;
  // Counts are written as whole numbers.
  constexpr double kExact = 9e15;
  if (limit.limit == std::trunc(limit.limit) && std::abs(limit.limit) < kExact) {
    number = static_cast<std::int64_t>(limit.limit);
  }
  const ValidPart part =
      valid_part(nlohmann::json{{limit.item, number}}, kDeviceLimitsTable, "/device/limits");
  if (!part.problems.empty()) return part.problems.front().message;
  if (limit.item != "rate_Hz") return {};
  return complaint_about_rate_limit(limit.limit, rate_Hz);
}

std::optional<Phrase> complaint_about_rate_limit(double limit_Hz, double rate_Hz) {
  if (limit_Hz <= rate_Hz) return {};
  return phrase("Protocols",
                "a loop set to %1 Hz cannot reach %2 Hz: the limit must be at most %3, the "
                "requested rate")
      .with(digits(rate_Hz), digits(limit_Hz), place_name("/device/rate_Hz"));
}

}  // namespace asperity
