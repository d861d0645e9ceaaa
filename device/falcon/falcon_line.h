// The conversation with one Falcon, on a thread of its own.

#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "device/falcon/falcon_firmware.h"
#include "device/falcon/falcon_frame.h"
#include "device/falcon/falcon_last_words.h"
#include "device/falcon/falcon_port.h"
#include "device/falcon/falcon_readings.h"
#include "device/latest_value.h"
#include "device/monotonic_clock.h"
#include "device/watchdog_process.h"

namespace asperity::falcon {

/// Throws OpeningStopped where `stop` asks for it.
void require_no_stop(const std::stop_token& stop);

struct LineSettings {
  std::string place{};   ///< "usb 1-2"
  std::string serial{};  ///< empty where the device tells none
  Firmware firmware{};   ///< empty: the device has to run some already
  VelocityWindow velocity{};
  /// Ask for SCHED_FIFO for the thread; without the right to it, it goes on as a normal one.
  bool wants_fifo = true;
  /// The clock of readings, silences and forces, in nanoseconds; a test may pass its own. Any thread. Real-time: it
  /// neither allocates nor throws.
  std::function<std::int64_t()> clock = monotonic_now_ns;
};

/// Sends the newest motor words and receives readings, frame for frame, as fast as the device answers
/// (about 1 kHz); opens the device again when it was unplugged and is back.
///
/// What the caller may rely on:
/// - The motors get zero while the device is not homed, for `kForceLasts_ns` after the last `command` at
///   the latest, after every loss until the next `command`, and at destruction. When the program dies
///   or stands still another process sends it (WatchdogProcess); without that process there is no force:
///   a device for which it cannot be started is refused, and when it ends the motors get zero from the
///   next frame on, until the device is opened again.
/// - Errors of the bus are outlived; a device that says nothing for a second is opened anew. After a frame
///   that was not answered in time what comes late is thrown away, so that an answer is always the
///   one to the frame before it.
///
/// Errors: the constructor opens the device, loads its firmware where none runs, and throws
/// std::runtime_error with a sentence where that fails; OpeningStopped where `stop` asks for it.
///
/// Threads: owns one, at SCHED_FIFO only while it exchanges frames, not while it looks for a device.
/// `take` and `command` belong to one other; `command` with zero words may come from any. The destructor waits for the transfer under way and does
/// not begin another but the parting zero: 0.5 s at the worst, while firmware is loaded, and a second more where the
/// device takes no zero and it is left to the watchdog; for a search
/// 0.6 s more for each Falcon on the bus that answers nothing.
///
/// Real-time: `take`, `command`, `is_connected` and `is_watched` are wait-free.
class FalconLine final {
 public:
  static constexpr std::int64_t kForceLasts_ns = 100'000'000;

  explicit FalconLine(LineSettings settings, const std::stop_token& stop = {});
  ~FalconLine();
  FalconLine(const FalconLine&) = delete;
  FalconLine& operator=(const FalconLine&) = delete;

  const LineSettings& settings() const noexcept { return settings_; }
  std::int64_t now_ns() const noexcept { return settings_.clock(); }
  /// Frames per second that the device answered when it was opened.
  double rate_Hz() const noexcept { return rate_Hz_; }

  /// True when there is a newer reading than the last one taken.
  bool take(Reading& reading) noexcept { return readings_.take(reading); }
  void command(const std::array<std::int16_t, 3>& motor_words) noexcept;
  bool is_connected() const noexcept { return connected_.load(std::memory_order_acquire); }
  /// False when nobody would set the motors to zero, should this program die; no force is given then.
  bool is_watched() const noexcept { return watched_.load(std::memory_order_acquire); }

 private:
  void open(const std::stop_token& stop);
  bool reopen(const std::stop_token& stop);
  bool is_reopened(const std::stop_token& stop);
  void make_ready(FalconPort& port, const std::stop_token& stop) const;
  void begin_watch();
  double measured_rate_Hz();
  void converse(const std::stop_token& stop);
  Transfer exchange();
  Transfer exchange_one(std::int64_t began_ns);
  bool is_left_over();
  void lose() noexcept;
  void leave_to_watchdog() noexcept;
  Command command_at(std::int64_t time_ns) const noexcept;

  LineSettings settings_{};
  double rate_Hz_ = 0.0;
  bool was_alone_ = false;  ///< when it was opened

  LatestValue<Reading> readings_{};
  std::atomic<std::uint64_t> words_{0};  // three times sixteen bits
  std::atomic<std::int64_t> commanded_ns_{0};
  std::atomic<bool> connected_{false};
  std::atomic<bool> watched_{true};

  // The thread's own, from here on.
  UsbSession usb_{};
  std::unique_ptr<FalconPort> port_{};
  LastWords last_words_{};  // the watchdog's
  std::unique_ptr<WatchdogProcess> watchdog_{};
  FrameReader reader_{};
  Readings answers_;
  std::int64_t heard_ns_ = 0;
  std::int64_t exchanged_ns_ = 0;  // when the last exchange began
  int in_doubt_ = 0;               // exchanges that may be answered late
  std::jthread thread_{};
};

}  // namespace asperity::falcon
