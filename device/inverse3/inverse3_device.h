// An Inverse3 of Haply, through the service that its maker installs on the same machine.

#pragma once

#include <memory>
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

/// One Inverse3. It keeps time itself (Pacing::theirs): the service gives one update of the hand for each message
/// that it gets, and the thread of this driver turns each update into one tick, the tick's force into the next
/// message, and sends no more of them than the loop wants ticks. A force reaches the service up to one period after
/// the update that it answers.
///
/// An update that does not come within 100 ms is asked for again, with no force. When the connection ends, the
/// driver tries twice a second to have it back, and calls again when this device is there again; the watch over its
/// calls (servo_thread.h) tells of the loss. A force is per message: a service that hears nothing lets go.
///
/// What the service does to the force on its way (its filters) stands in the capability's remarks, as it was when
/// the device was opened. How it spells a force is found out then, with 0.02 N that nobody feels. Velocity is our own
/// estimate.
///
/// Frame: the service's, which is taken for x to the right, y away from the participant, z up; with the
/// preset "defaults" the origin is moved from the base to where the service's documents have the handle rest, (0, −0.12, 0.15) m.
///
/// Errors: the constructor throws std::runtime_error with a sentence when the service or the device does not answer.
///
/// Threads: `trouble` from any; the rest as HapticDevice.
class Inverse3Device final : public HapticDevice {
 public:
  Inverse3Device(const InverseServicePlace& place, const std::string& device_id);
  ~Inverse3Device() override;

  void start_calls(const TickCall& call) override;
  void stop_calls() noexcept override;
  std::string trouble() const override;

 private:
  struct Opened;
  struct Line;
  explicit Inverse3Device(std::unique_ptr<Opened> opened);
  static std::unique_ptr<Opened> open(const InverseServicePlace& place,
                                      const std::string& device_id);

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  std::unique_ptr<Line> line_;
};

/// "inverse3": every Inverse3 that the service knows, by its device id.
Driver inverse3_driver();

}  // namespace asperity
