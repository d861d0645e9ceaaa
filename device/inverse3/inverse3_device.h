// An Inverse3 of Haply, through the service that its maker installs on the same machine.

#pragma once

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

#include "device/drivers.h"
#include "device/haptic_device.h"
#include "device/inverse3/inverse3_messages.h"

namespace asperity {

/// Where the Inverse Service listens.
struct InverseServicePlace {
  std::string host = "127.0.0.1";
  int port = 10001;
  /// "HOST:PORT", "HOST" or "" for the usual place. Errors: std::runtime_error for a port that is none.
  static InverseServicePlace of(const std::string& text);
  std::string text() const { return host + ":" + std::to_string(port); }
};

/// How long the service is waited for.
struct Inverse3Patience {
  std::chrono::milliseconds connection{1000};  ///< with finding a host that is a name
  std::chrono::milliseconds inventory{1000};   ///< what it says first, and while a device is opened
  /// Of the hand, in a session: as long as a device may say nothing.
  std::chrono::milliseconds update{HapticDevice::kLongestSilence_ns / 1'000'000};
};

/// One Inverse3. It keeps time itself (Pacing::theirs): the service gives one update of the hand for each message
/// that it gets, and the thread of this driver turns each update into one tick, the tick's force into the next
/// message, and sends no more of them than the loop wants ticks. A force reaches the service up to one period after
/// the update that it answers.
///
/// An update that does not come in time (50 ms) is asked for again, with no force. When the connection ends, the
/// driver tries twice a second to have it back, and calls again when this device is there again, with the axes and
/// the origin that it had; the watch over its calls (servo_thread.h) tells of the loss, after as long.
///
/// When the program dies or stands still another process asks the service for zero (WatchdogProcess), over the same
/// connection; without that process there is no force: a device for which it cannot be started is refused, and when it
/// ends the device is lost to the servo until it is opened anew.
///
/// What the service does to the force on its way (its filters) stands in the capability's remarks, as it was when
/// the device was opened. How it spells a force is found out then, with 0.02 N that nobody feels; where the service
/// does not tell what it applies, the remarks say that it was not confirmed. Velocity is our own estimate. A grip is
/// read where it is the only one and this the only arm.
///
/// Frame: the service's, x to the right, y away from the participant, z up. With the presets "defaults" and
/// "arm_front" the origin is moved from the base to where the service's documents have the handle rest,
/// (0, −0.12, 0.15) m; with "arm_front_centered" it is the service's.
///
/// Errors: the constructor throws std::runtime_error with a sentence when the service or the device does not answer,
/// where no process can be started, and for another preset, basis or transform: its axes or its millimetres would not be ours; OpeningStopped at once when
/// `stop` is asked for.
///
/// While a tick does not return, `zero_force_from_outside` sends that request over the connection, which its thread does
/// not use within a tick.
///
/// Threads: `trouble` from any; the rest as HapticDevice. `stop_calls` takes up to 1.5 s where the service has fallen
/// silent, and where a host that is a name has to be found anew.
///
/// Real-time: reading and pushing do not allocate; between two ticks the same thread reads and writes JSON, which does.
class Inverse3Device final : public HapticDevice {
 public:
  Inverse3Device(const InverseServicePlace& place, const std::string& device_id,
                 const Inverse3Patience& patience = {}, const std::stop_token& stop = {});
  ~Inverse3Device() override;

  void start_calls(const TickCall& call) override;
  void stop_calls() noexcept override;
  void zero_force_from_outside() noexcept override;
  std::string trouble() const override;

 private:
  struct Opened;
  struct Line;
  explicit Inverse3Device(std::unique_ptr<Opened> opened);
  static std::unique_ptr<Opened> open(const InverseServicePlace& place,
                                      const std::string& device_id,
                                      const Inverse3Patience& patience,
                                      const std::stop_token& stop);

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  std::unique_ptr<Line> line_;
};

/// "inverse3": every Inverse3 that the service knows, by its device id.
Driver inverse3_driver(const Inverse3Patience& patience = {});

}  // namespace asperity
