// Declares limits on a device, from a protocol or from the command line.

#pragma once

#include <optional>
#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

/// A limit on a numeric item of a device.
struct DeviceLimit {
  std::string item{};  ///< "friction_N"
  double limit = 0.0;
};

/// The reason, as a sentence, why a protocol with a loop at `rate_Hz` cannot have this limit (/device/limits of the
/// schema); nullopt if it can.
std::optional<Phrase> complaint_about(const DeviceLimit& limit, double rate_Hz);

/// The check that the schema cannot express: a limit on the rate of the loop itself.
std::optional<Phrase> complaint_about_rate_limit(double limit_Hz, double rate_Hz);

}  // namespace asperity
