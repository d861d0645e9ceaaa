// A Touch or Phantom of 3D Systems, through OpenHaptics: its scheduler's thread runs our loop.

#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include "device/drivers.h"
#include "device/haptic_device.h"
#include "device/openhaptics/hd_functions.h"

namespace asperity {

/// One device that libHD has opened. It keeps time itself (Pacing::theirs): each call of its scheduler is one frame,
/// hdBeginFrame … hdEndFrame, and one tick inside it.
///
/// The peak force is what the device says of itself (HD_NOMINAL_MAX_FORCE); libHD's own clamping is on as a second
/// net. Torque goes to models with six actuated degrees of freedom only. Velocity is our own estimate
/// (velocity_estimator.h). In a frame that begins with an error of libHD (warm motors, too strong, no answer), and
/// after one that ends with one, zero is sent and the push refused: the servo loop's fault tells, and `trouble` says
/// which error it was. Force output is on while it calls only.
///
/// Frame: ours, x to the participant's right, y away from them, z up; origin in the middle of the usable
/// workspace. The position is that of the gimbal's centre, not of the stylus's tip.
///
/// Errors: the constructor and `start_calls` throw std::runtime_error with a sentence; a device that says that it
/// is not calibrated is refused.
///
/// Threads: `trouble` from any; the rest as HapticDevice. `zero_force_from_outside` switches force output off, with
/// which libHD documents that it turns the motors off; the first frame that comes to its end, at zero force, switches
/// it on again. It does so only while a tick is under way: where libHD's thread hangs in its own code, the call might not
/// return. `stop_calls` waits for a tick under way. Where libHD's
/// thread hangs in its own code, it gives up after half a second and leaves behind what that thread may still look
/// at; nobody reaches the motors then, and the device stays in use until the program ends. Where it does not hang,
/// hdStopScheduler is waited for, as long as that takes libHD.
class OpenHapticsDevice final : public HapticDevice {
 public:
  /// The device that was configured under this name; empty for the default one.
  /// `patience`: how long `stop_calls` waits for libHD's own code.
  OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const std::string& name,
                    std::chrono::milliseconds patience = std::chrono::milliseconds(500));
  ~OpenHapticsDevice() override;

  void start_calls(const TickCall& call) override;
  void stop_calls() noexcept override;
  void zero_force_from_outside() noexcept override;
  std::string trouble() const override;

 private:
  struct Opened;
  struct Servo;  // what libHD's thread touches
  OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const Opened& opened,
                    std::chrono::milliseconds patience);
  static Opened open(const HdFunctions& hd, const std::string& name);

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  void end_frames() noexcept;
  void switch_off() noexcept;

  std::shared_ptr<const HdFunctions> hd_;
  std::chrono::milliseconds patience_{500};
  std::unique_ptr<Servo> servo_;  // left behind at the end where libHD's thread was given up
  std::atomic<bool> is_given_up_{false};
  unsigned long schedule_ = 0;
  bool is_called_ = false;
  bool has_other_rate_ = false;  ///< than libHD's usual one
};

/// "openhaptics": the device that is configured as the default; `which` is its serial number or the name under
/// which another one was configured.
Driver openhaptics_driver();

}  // namespace asperity
