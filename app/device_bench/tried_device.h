// A device that was opened for a moment, without force, before anybody's hand is on it.

#pragma once

#include <functional>
#include <string>

#include "analysis/words/phrase.h"
#include "device/device_capability.h"
#include "device/drivers.h"
#include "protocols/design/protocol.h"
#include "renderers/servo/servo_loop.h"
#include "results_schema/rows.h"

namespace asperity {

/// What a few hundred ticks of the loop that a session will run on say, nothing being felt.
struct TriedDevice {
  std::string device{};  ///< as RunInputs::device
  double rate_Hz = 0.0;  ///< that the protocol asks for
  Phrase failure{};      ///< a sentence: why it could not be opened; the rest is then empty
  /// What it has to do by itself before it can be used, in its driver's own words; it was not moved, because
  /// nobody has agreed to that. Empty otherwise.
  std::string wants_to_move{};
  bool was_stopped = false;  ///< by DriverOptions::stop, while it was opened
  DeviceCapability capability{};
  ServoQualityRow quality{};
  double strongest_N = 0.0;
  Fault fault = Fault::none;
};

/// Opens it, runs the loop for some 0.3 s with nothing to feel, and closes it. Opening takes as long as the
/// device does. One that has to move by itself to find its zero is refused unmoved, unless what its driver says of
/// that is word for word what somebody has `agreed` to: TriedDevice::wants_to_move of a try before. Nobody is waited
/// for while it is open.
///
/// Never throws for what the device does; std::bad_alloc.
TriedDevice try_device(const std::string& device, const Protocol& protocol,
                       const DriverRegistry& drivers, const DriverOptions& options,
                       const std::string& agreed = {});

/// How devices are tried: by `try_device`, which finds the machine as busy as it is; a test may know better.
using DeviceTrial = std::function<TriedDevice(
    const std::string& device, const Protocol& protocol, const DriverRegistry& drivers,
    const DriverOptions& options, const std::string& agreed)>;

}  // namespace asperity
