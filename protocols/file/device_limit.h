// Limits that apply to a device: those of a protocol, and those of a command line.

#pragma once

#include <optional>
#include <string>

namespace asperity {

/// What a device's item with a number may be held to.
struct DeviceLimit {
  std::string item{};  ///< "friction_N"
  double limit = 0.0;
};

/// A sentence: why no protocol whose loop runs at `rate_Hz` could have this limit (/device/limits of the schema); nothing
/// where one could.
std::optional<std::string> complaint_about(const DeviceLimit& limit, double rate_Hz);

/// The part of it that the schema cannot say: a limit on the rate of the loop itself.
std::optional<std::string> complaint_about_rate_limit(double limit_Hz, double rate_Hz);

}  // namespace asperity
