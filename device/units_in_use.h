// Which devices this process has open, so that no look at what is attached disturbs them.

#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "device/drivers.h"

namespace asperity {

/// A device that this process has open through its maker's library or service: listed from construction to
/// destruction.
///
/// A maker's library serves the whole process: opened a second time, a device is handed out again without a word,
/// and closed once it is closed for everybody. So this list is one for the process as well, and no argument.
///
/// Threads: any.
class UnitInUse final {
 public:
  UnitInUse(std::string driver, AttachedDevice device);
  ~UnitInUse();
  UnitInUse(const UnitInUse&) = delete;
  UnitInUse& operator=(const UnitInUse&) = delete;

  /// Those of one driver, each with the hindrance that this program uses it.
  static std::vector<AttachedDevice> of(std::string_view driver);

  /// Held by DriverRegistry while a driver looks for devices or opens one, and by a driver that opens its lost
  /// device again. Between the two looks of another thread a device that it has opened only to ask its name would
  /// be closed under whoever began to use it.
  static std::mutex& looking();
};

}  // namespace asperity
