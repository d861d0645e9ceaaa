// A delta, omega, sigma or lambda of Force Dimension, through the manufacturer's SDK.

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

/// A device that the SDK has opened.
///
/// Velocity is our own estimate (velocity_estimator.h), because that of the SDK is a mean over 20 ms, which at 0.1 m/s
/// are two millimetres of texture. A reading that the SDK returns twice (its time guard) does not count as new; if none
/// is new for 50 ms, the device does not answer.
///
/// The watchdog and the velocity guard of the SDK keep the manufacturer's settings. When they, the button of the device
/// or its power switch the force off, the next tick detects it: zero is sent and `do_send` refuses, so that the servo
/// loop has a fault and ramps the force up again afterwards; `trouble` states the cause. Opening a device switches its
/// force on, at zero. If the motors are saturated, the push is marked as limited in force, and `trouble` counts such
/// pushes until two seconds have passed without one.
///
/// A device that fails for 200 ms is closed. A thread of the driver searches for its serial number four times a second and
/// resumes when it is back and still knows its zero. Its force is switched on again, at zero, unless the user
/// or the velocity guard had switched it off. In a session the device never moves by itself. The destructor sends zero and
/// applies the electromagnetic brakes (dhdStop); it waits for a search in progress, which takes as long as the SDK
/// takes to open a device.
///
/// Frame: ours, x to the participant's right, y away from the participant, z up; origin of the device.
/// A gripper is the second button: pressed when its parts are less than 10° apart, until they are more than 15° apart,
/// for devices of either hand. It gets no force, and its angle is not recorded. The angles are our choice.
///
/// Errors: the constructor throws std::runtime_error with a sentence if the device cannot be opened, is of
/// an unknown type, or has lost its zero and may not or cannot find it.
///
/// Threads: `trouble` from any; the rest as HapticDevice. `zero_force_from_outside` calls the SDK in a second thread, as
/// the regulation of libdrd does; where a call of the servo thread hangs in the SDK, this one may hang as well.
///
/// Real-time: as far as the SDK's functions are.
class ForceDimensionDevice final : public HapticDevice {
 public:
  /// DriverOptions::may_move.
  using MayMove = std::function<bool(const std::string& sentence)>;

  /// DriverOptions::tell.
  using Tell = std::function<void(const std::string& sentence)>;

  /// Opens the device with this index. A device that was switched off has lost its zero and has to move by itself, for
  /// some seconds, to find it (find_zero.h): only with libdrd, and after `may_move` returned true; otherwise it is
  /// refused without a movement. After `stop` was requested it is not moved. A movement in progress is ended: two
  /// threads switch force and regulation off until libdrd has ended, and then OpeningStopped is thrown. If that takes more
  /// than a second, or a function of the SDK does not return, `tell` receives once, in another thread, what the user has
  /// to do; the constructor still waits.
  ForceDimensionDevice(std::shared_ptr<const DhdFunctions> sdk, int index,
                       const MayMove& may_move = {}, const std::stop_token& stop = {},
                       const Tell& tell = {});
  ~ForceDimensionDevice() override;

  /// For velocities: a delay of 2 ms at 1 kHz, and noise of σ·316/s for an error σ of each position.
  static constexpr VelocityWindow kWindow{.samples = 5};

  void zero_force_from_outside() noexcept override;
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
  bool is_robotic_ = false;  ///< also opened by libdrd
  int type_ = -1;
  bool has_wrist_ = false;
  bool has_gripper_ = false;
  UnitInUse in_use_;

  // Of the servo thread, and of the keeper while `is_given_up_` is set.
  std::atomic<bool> is_given_up_{false};
  std::atomic<bool> has_lost_zero_{false};
  std::thread keeper_{};
  std::mutex mutex_{};
  std::condition_variable wake_{};
  bool ends_ = false;
  bool is_closed_ = false;  ///< the SDK has closed it

  // Of the servo thread.
  ProbeState last_{};
  bool has_read_ = false;
  std::optional<std::int64_t> failing_since_ns_{};
  std::int64_t last_new_ns_ = 0;
  bool force_is_on_ = true;
  bool is_gripped_ = false;
  VelocityEstimator velocity_{kWindow};
  VelocityEstimator angular_velocity_{kWindow, kFastestTurn_rad_per_s};
  int pushes_since_saturated_ = 0;
  glm::dvec3 turned_rad_{0.0};  ///< the sum of all small rotations, each about its axis

  std::atomic<std::uint64_t> saturated_{0};
  std::atomic<bool> answers_{true};
  std::atomic<bool> is_stale_{false};
  std::atomic<int> force_off_cause_{-1};  ///< of the SDK; −1 while the force is on
  // Written once, before `has_failed_`: the first failure.
  std::array<char, 160> failure_{};
  std::atomic<bool> has_failed_{false};
};

/// "force_dimension": all devices that the SDK lists. `which` is a serial number, or a place such as "dhd 0".
Driver force_dimension_driver();

}  // namespace asperity
