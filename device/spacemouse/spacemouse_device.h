// A SpaceMouse of 3Dconnexion as a probe: its cap drives, and nobody feels a force.

#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "device/drivers.h"
#include "device/haptic_device.h"
#include "device/spacemouse/rate_control.h"
#include "device/spacemouse/spacemouse_line.h"

namespace asperity {

/// One SpaceMouse, which is input only: as long as its cap is deflected the probe moves and turns, as fast as it is
/// deflected (`spacemouse::RateControl`: speeds, dead zone, workspace, the button that takes the probe home). The first
/// button is the participant's.
///
/// When it is lost. A cap at rest sends nothing, for hours: silence is no fault then, however old the last report. A
/// deflected one repeats itself, every 8 to 16 ms in the models that somebody has measured. So the device does not
/// answer
///
///   · at once when it is unplugged, at rest as well: hidapi says so, and no report has to be missed, or
///   · 50 ms after the last report of a cap that drove the probe. For so long the probe goes on.
///
/// It then stands where it is. Plugged in again, the device answers again, its cap at rest. One that was silent answers
/// with its next report: where the cap's return to rest was what got lost, somebody has to touch it, and `trouble` says
/// so. A report that repeats itself for ever is a hand that holds still, as far as anybody can tell.
///
/// The velocity is that of the probe's path, without lag, and changes in steps, as the reports come.
///
/// Frame: x to the right, y away, z up; z = 0 is the surface. Forces are limited and go nowhere.
///
/// Errors: the constructor throws as SpaceMouseLine and RateControl do.
///
/// Real-time: reading and sending do not allocate, lock, wait or throw; the bus has a thread of its own
/// (spacemouse/spacemouse_line.h). Readings are timed by the monotonic clock, as the reports are.
class SpaceMouseDevice final : public HapticDevice {
 public:
  explicit SpaceMouseDevice(const spacemouse::LineSettings& which,
                            const spacemouse::RateControlSettings& motion = {});

  void zero_force_from_outside() noexcept override {}
  std::string trouble() const override;

 private:
  enum class State { well, unplugged, silent };
  bool do_read(std::int64_t now_ns, ProbeState& state) noexcept override;
  bool do_send(const Wrench&) noexcept override;
  State heard_at(std::int64_t now_ns, bool is_told_anew) noexcept;

  spacemouse::RateControl motion_;
  spacemouse::SpaceMouseLine line_;
  std::int64_t moved_ns_ = 0;  // of the last report
  std::atomic<State> state_{State::well};
};

/// For the list of drivers: "spacemouse".
Driver spacemouse_driver();

}  // namespace asperity
