// The reports of one SpaceMouse, awaited on a thread of its own.

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "device/latest_value.h"
#include "device/spacemouse/cap_reports.h"
#include "device/spacemouse/rate_control.h"
#include "device/spacemouse/spacemouse_port.h"
#include "device/units_in_use.h"

namespace asperity::spacemouse {

/// Which one.
struct LineSettings {
  std::string model{};
  std::string serial{};  ///< empty where the device tells none
  std::string place{};   ///< "usb 1-2"
};

/// Waits for reports and leaves the newest; opens the device again when it was unplugged and is back (`found_again`,
/// among those of its model).
///
/// What the caller may rely on: a loss is told as a cap at rest with no button down, so that nothing of before is left
/// when the device is back. Errors of the bus are outlived.
///
/// Errors: the constructor opens the device and throws std::runtime_error with a sentence where that fails.
///
/// Threads: owns one. `take` belongs to one other. The destructor waits for 20 ms at most, or the search under way.
/// (hidapi waits by the time of day: were the clock set back within those 20 ms, until a report comes or for as long.)
///
/// Real-time: `take` and `is_connected` are wait-free.
class SpaceMouseLine final {
 public:
  explicit SpaceMouseLine(LineSettings settings);
  ~SpaceMouseLine();
  SpaceMouseLine(const SpaceMouseLine&) = delete;
  SpaceMouseLine& operator=(const SpaceMouseLine&) = delete;

  const LineSettings& settings() const noexcept { return settings_; }
  /// True when there is something newer than what was last taken.
  bool take(CapReport& report) noexcept { return reports_.take(report); }
  bool is_connected() const noexcept { return connected_.load(std::memory_order_acquire); }

 private:
  std::vector<AttachedDevice> attached() const;
  void open(const std::string& place);
  bool reopen();
  void listen(const std::stop_token& stop);
  void lose() noexcept;

  LineSettings settings_{};
  bool was_alone_ = false;  ///< when it was opened
  LatestValue<CapReport> reports_{};
  std::atomic<bool> connected_{false};

  // The thread's own, from here on.
  UsbSession usb_{};
  std::unique_ptr<SpaceMousePort> port_{};
  std::unique_ptr<UnitInUse> in_use_{};
  CapReader reader_{};
  std::int64_t moved_ns_ = 0;
  std::jthread thread_{};
};

}  // namespace asperity::spacemouse
