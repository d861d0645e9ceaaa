// A delta, omega, sigma or lambda of Force Dimension, through its maker's SDK.

#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "device/drivers.h"
#include "device/force_dimension/dhd_functions.h"
#include "device/force_dimension/dhd_models.h"
#include "device/haptic_device.h"
#include "device/units_in_use.h"
#include "device/velocity_estimator.h"

namespace asperity {

/// One device that the SDK has opened.
///
/// Velocity is our own estimate (velocity_estimator.h), because the SDK's is a mean over 20 ms: at 0.1 m/s
/// two millimetres of texture. A reading that the SDK gives twice (its time guard) is not
/// taken for a new one; when none is new for 50 ms, the device does not answer.
///
/// The SDK's watchdog and velocity guard stay as its maker set them. When they, the device's own button
/// or its power switch the force off, the next tick sees it: zero is sent and `do_send` refuses, so that the servo
/// loop's fault tells and its ramp brings the force back; `trouble` says which it was. Opening a device switches its
/// force on, at zero. With less force than was asked for (motors saturated) it goes on: the push is marked as
/// limited in force, and `trouble` counts until two seconds of pushes were given in full.
///
/// A device that fails for 200 ms is given up; a thread of the driver's looks for its serial number four times a second and
/// goes on with it when it is back and still knows its zero. Its force is switched on again, at zero, unless a person
/// or the velocity guard had switched it off. It is never moved by itself in a session. The destructor sends zero and
/// leaves the motors to the SDK's electromagnetic brakes (dhdStop); it waits for a look that is under way, which takes
/// as long as the SDK takes to open a device.
///
/// Frame: ours, x to the participant's right, y away from them, z up; origin the device's.
/// A gripper is the second button: pressed once its parts are less than 10° apart, until they are more than 15° apart,
/// whichever hand the device is for. It gets no force, and its angle is not recorded. The angles are ours.
///
/// Errors: the constructor throws std::runtime_error with a sentence when the device cannot be opened, is of
/// a kind that we do not know, or has lost its zero and may not or cannot find it.
///
/// Threads: `trouble` from any; the rest as HapticDevice.
///
/// Real-time: as far as the SDK's functions are.
class ForceDimensionDevice final : public HapticDevice {
 public:
  /// DriverOptions::may_move.
  using MayMove = std::function<bool(const std::string& sentence)>;

  /// DriverOptions::tell.
  using Tell = std::function<void(const std::string& sentence)>;

  /// Opens the one with this index. One that was switched off has lost its zero, and has to move by itself to find
  /// it, for some seconds: only with libdrd, and after `may_move` said yes; otherwise it is refused, unmoved. It is not
  /// moved either once `stop` was asked for, and stopped where it moves already: its force and its regulation are
  /// switched off, from two threads, until libdrd has given up, and then OpeningStopped is thrown. Where libdrd has not
  /// given up and let go a second after the stop, or one of its functions does not return, `tell` is told what to do,
  /// once, from another thread; what does not return is waited for all the same.
  ForceDimensionDevice(std::shared_ptr<const DhdFunctions> sdk, int index,
                       const MayMove& may_move = {}, const std::stop_token& stop = {},
                       const Tell& tell = {});
  ~ForceDimensionDevice() override;

  /// Of the velocities: 2 ms late at 1 kHz, and σ·316/s of noise for an error σ of each position.
  static constexpr VelocityWindow kWindow{.samples = 5};

  std::string trouble() const override;

 private:
  struct Opened;
  ForceDimensionDevice(std::shared_ptr<const DhdFunctions> sdk, const Opened& opened);

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  bool take(int answer, const char* function) noexcept;
  void fail_at(std::int64_t now_ns) noexcept;
  void keep();
  std::optional<char> find_again();
  bool reopen();
  void look_at_status() noexcept;
  void look_at_gripper(ProbeState& state) noexcept;

  std::shared_ptr<const DhdFunctions> sdk_;
  char id_ = 0;
  bool is_robotic_ = false;  ///< opened by libdrd as well
  int type_ = -1;
  bool has_wrist_ = false;
  bool has_gripper_ = false;
  UnitInUse in_use_;

  // The servo's thread, and while the device is given up the keeper's: `is_given_up_` hands `id_` over.
  std::atomic<bool> is_given_up_{false};
  std::atomic<bool> has_lost_zero_{false};
  std::thread keeper_{};
  std::mutex mutex_{};
  std::condition_variable wake_{};
  bool ends_ = false;
  bool is_closed_ = false;  ///< given up, and the SDK told so

  // The servo's thread.
  ProbeState last_{};
  bool has_read_ = false;
  std::optional<std::int64_t> failing_since_ns_{};
  std::int64_t last_new_ns_ = 0;
  bool force_is_on_ = true;
  bool is_gripped_ = false;
  VelocityEstimator velocity_{kWindow};
  VelocityEstimator angular_velocity_{kWindow};
  int pushes_since_saturated_ = 0;
  glm::dvec3 turned_rad_{0.0};  ///< the sum of all small turns so far, each about its own axis

  std::atomic<std::uint64_t> saturated_{0};
  std::atomic<bool> answers_{true};
  std::atomic<bool> is_stale_{false};
  std::atomic<int> force_off_cause_{-1};  ///< of the SDK; −1 while the force is on
  // Written once, before has_failed_, for the first failure of this device's life.
  std::array<char, 160> failure_{};
  std::atomic<bool> has_failed_{false};
};

/// "force_dimension": every device that the SDK sees. `which` is a serial number, or a place such as "dhd 0".
Driver force_dimension_driver();

}  // namespace asperity
