// The conversation with one Falcon, on a thread of its own.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "device/falcon/falcon_firmware.h"
#include "device/falcon/falcon_frame.h"
#include "device/falcon/falcon_port.h"
#include "device/falcon/falcon_readings.h"
#include "device/latest_value.h"

namespace asperity::falcon {

struct LineSettings {
  std::string place{};   ///< "usb 1-2"
  std::string serial{};  ///< empty where the device tells none
  Firmware firmware{};   ///< empty: the device has to run some already
  VelocityWindow velocity{};
  /// Ask for SCHED_FIFO for the thread; without the right to it, it goes on as a normal one.
  bool wants_fifo = true;
};

/// Sends the newest motor words and receives readings, frame for frame, as fast as the device answers
/// (about 1 kHz); opens the device again when it was unplugged and is back.
///
/// What the caller may rely on:
/// - The motors get zero while the device is not homed, for `kForceLasts_ns` after the last `command` at
///   the latest, after every loss until the next `command`, and at destruction.
/// - Errors of the bus are outlived; a device that says nothing for a second is opened anew.
///
/// Errors: the constructor opens the device, loads its firmware where none runs, and throws
/// std::runtime_error with a sentence where that fails.
///
/// Threads: owns one. `take` and `command` belong to one other. The destructor waits for it, for 1.5 s at
/// the worst (loading firmware).
///
/// Real-time: `take`, `command` and `is_connected` are wait-free.
class FalconLine final {
 public:
  static constexpr std::int64_t kForceLasts_ns = 100'000'000;

  explicit FalconLine(LineSettings settings);
  ~FalconLine();
  FalconLine(const FalconLine&) = delete;
  FalconLine& operator=(const FalconLine&) = delete;

  const LineSettings& settings() const noexcept { return settings_; }
  /// Frames per second that the device answered when it was opened.
  double rate_Hz() const noexcept { return rate_Hz_; }

  /// True when there is a newer reading than the last one taken.
  bool take(Reading& reading) noexcept { return readings_.take(reading); }
  void command(const std::array<std::int16_t, 3>& motor_words) noexcept;
  bool is_connected() const noexcept { return connected_.load(std::memory_order_acquire); }

 private:
  void open();
  bool reopen(const std::stop_token& stop);
  void make_ready(FalconPort& port, const std::stop_token& stop) const;
  double measured_rate_Hz();
  void converse(const std::stop_token& stop);
  Transfer exchange();
  void lose() noexcept;
  Command command_now(std::int64_t now_ns) const noexcept;

  LineSettings settings_{};
  double rate_Hz_ = 0.0;
  bool was_alone_ = false;  ///< when it was opened

  LatestValue<Reading> readings_{};
  std::atomic<std::uint64_t> words_{0};  // three times sixteen bits
  std::atomic<std::int64_t> commanded_ns_{0};
  std::atomic<bool> connected_{false};

  // The thread's own, from here on.
  UsbSession usb_{};
  std::unique_ptr<FalconPort> port_{};
  FrameReader reader_{};
  Readings answers_;
  std::int64_t heard_ns_ = 0;
  std::jthread thread_{};
};

}  // namespace asperity::falcon
