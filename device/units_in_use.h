// Which devices this process has open, so that no look at what is attached disturbs them.

#pragma once

#include <mutex>
#include <stop_token>
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

  /// Those of one driver, each with the blocker that this program uses it.
  static std::vector<AttachedDevice> of(std::string_view driver);

  /// Whether there is one, of any driver.
  static bool is_any();

  /// Held by DriverRegistry while a driver looks for devices or opens one, and by a driver that opens its lost
  /// device again. Between the two looks of another thread a device that it has opened only to ask its name would
  /// be closed while another user of the library begins to use it.
  static std::mutex& looking();
};

/// While it lives, other threads may look for devices and open them: a driver waits for a person, who may take
/// minutes. What the driver has open is in use for the others by then: listed here, or claimed on its bus.
///
/// Its end waits until no other thread looks, or until `stop` is requested: then the lock is left to the others, and
/// the opening thread can only give up.
class LetOthersLook final {
 public:
  /// `alone` is DriverOptions::alone: null where it is not held.
  explicit LetOthersLook(std::unique_lock<std::mutex>* alone, std::stop_token stop = {});
  ~LetOthersLook();
  LetOthersLook(const LetOthersLook&) = delete;
  LetOthersLook& operator=(const LetOthersLook&) = delete;

 private:
  std::unique_lock<std::mutex>* alone_;
  std::stop_token stop_;
};

}  // namespace asperity
