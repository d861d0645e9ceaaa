// A Touch or Phantom of 3D Systems, through OpenHaptics: its scheduler's thread runs our loop.

#pragma once

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
/// (velocity_estimator.h). After a force error of libHD (warm motors, too strong, too fast) the next push is
/// refused: the servo loop's fault tells, and `trouble` says which error it was.
///
/// Frame: ours, x to the participant's right, y away from them, z up; origin in the middle of the usable
/// workspace. The position is that of the gimbal's centre, not of the stylus's tip.
///
/// Errors: the constructor and `start_calls` throw std::runtime_error with a sentence.
///
/// Threads: `trouble` from any; the rest as HapticDevice. Where libHD's thread hangs, `stop_calls` gives up after
/// half a second and leaves behind what that thread may still look at.
class OpenHapticsDevice final : public HapticDevice {
 public:
  /// The device that was configured under this name; empty for the default one.
  OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const std::string& name);
  ~OpenHapticsDevice() override;

  void start_calls(const TickCall& call) override;
  void stop_calls() noexcept override;
  std::string trouble() const override;

 private:
  struct Opened;
  struct Servo;  // what libHD's thread touches
  OpenHapticsDevice(std::shared_ptr<const HdFunctions> hd, const Opened& opened);
  static Opened open(const HdFunctions& hd, const std::string& name);

  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench& limited) noexcept override;

  std::shared_ptr<const HdFunctions> hd_;
  std::unique_ptr<Servo> servo_;  // null after libHD's thread was given up
  unsigned long schedule_ = 0;
  bool is_called_ = false;
};

/// "openhaptics": the device that is configured as the default; `which` is its serial number or the name under
/// which another one was configured.
Driver openhaptics_driver();

}  // namespace asperity
