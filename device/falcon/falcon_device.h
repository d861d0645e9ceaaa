// The Novint Falcon.

#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

#include "device/drivers.h"
#include "device/falcon/falcon_line.h"
#include "device/haptic_device.h"

namespace asperity {

struct FalconSettings {
  falcon::LineSettings line{};
  /// How long a person may take to home the grip before opening gives up.
  std::chrono::milliseconds homing_patience{60'000};
  /// Told what that person has to do.
  std::function<void(const std::string& sentence)> tell{};
  std::stop_token stop{};                         ///< DriverOptions::stop
  std::unique_lock<std::mutex>* alone = nullptr;  ///< DriverOptions::alone
};

/// What every Falcon declares; one that is attached tells its serial number and its rate besides. Workspace and force
/// are those of its kinematics, and smaller than what it is sold as; no unit was measured.
DeviceCapability falcon_capability();

/// A Falcon: its place from three encoders, three motors, four buttons, no torque.
///
/// What the caller may rely on:
/// - `read` gives the newest of the device's answers, normally no older than one of its frames (1 ms).
///   It says that the device is lost at once when it is unplugged, 50 ms after the last answer
///   otherwise, and while it is not homed.
/// - `push` says what the motors were given: a force beyond them keeps its direction and is marked as
///   limited.
/// - It does not answer while its watchdog process is gone (falcon/falcon_line.h).
/// - Unplugged and plugged in again, it answers again: with its firmware and homing where it kept its
///   power, after loading and another homing where it did not. The force stays zero until the next push.
///
/// Velocity: a line through the last eight answers (`VelocityWindow`): 3.5 ms behind at 1 kHz, with a
/// noise of 1.7 mm/s where one encoder count is 38 µm.
///
/// Frame: x to the right as the hand sees it, y from the hand to the machine, z up; the origin in the
/// middle of the workspace, 115 mm in front of the shoulders.
///
/// Errors: `open` throws std::runtime_error with a sentence: no permission, in use, no firmware, loading
/// failed three times, not homed in time, no watchdog process. OpeningStopped: while firmware is loaded after the
/// transfer under way, otherwise at once.
///
/// Real-time: reading and sending do not allocate, lock, wait or throw; the bus has a thread of its own
/// (falcon/falcon_line.h).
class FalconDevice final : public HapticDevice {
 public:
  static std::unique_ptr<FalconDevice> open(const FalconSettings& settings);
  ~FalconDevice() override;

  void zero_force_from_outside() noexcept override;
  std::string trouble() const override;

 private:
  enum class State { well, unwatched, unplugged, silent, not_homed };
  explicit FalconDevice(std::unique_ptr<falcon::FalconLine> line);
  void wait_until_homed(const FalconSettings& settings);
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;
  State state_at(std::int64_t clock_ns) const noexcept;

  std::unique_ptr<falcon::FalconLine> line_;
  falcon::Reading reading_{};
  std::atomic<State> state_{State::silent};
};

/// For the list of drivers: "falcon".
Driver falcon_driver();

}  // namespace asperity
