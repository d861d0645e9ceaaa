// The physical side of a session: a device, the servo loop that drives it, and the pacing of the
// loop.

#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/random.h"
#include "app/session/rig/clock.h"
#include "device/drivers.h"
#include "device/simulated_device.h"
#include "device/virtual_hand.h"
#include "protocols/design/protocol.h"
#include "renderers/servo/record_ring.h"
#include "renderers/servo/servo_loop.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

class Recorder;

struct RigSettings {
  ServoSettings servo{};
  ForceLimits limits{};
  SimulatedDeviceSettings device{};
};

/// The settings that a protocol requires. `device` is named as in --device: the device that the
/// simulated device models; without meaning for other devices.
/// Errors: std::runtime_error for a "simulated:MODEL" that does not exist.
RigSettings rig_settings_for(const Protocol& protocol, const std::vector<ScriptedFault>& faults,
                             const std::string& device = "simulated");

/// The interface of the physical side to the conductor.
///
/// `pass` lets time pass in a session: ticks happen, the recorder takes their records, the loop
/// receives the conductor's heartbeat. All waiting of the conductor is done in `pass`.
///
/// Threads: everything belongs to the conductor's thread, except `emergency_stop`.
class Rig {
 public:
  virtual ~Rig() = default;
  Rig(const Rig&) = delete;
  Rig& operator=(const Rig&) = delete;

  virtual const Clock& clock() const noexcept = 0;
  virtual ServoLoop& loop() noexcept = 0;
  virtual RecordRing& records() noexcept = 0;
  virtual VirtualHand& hand() noexcept = 0;
  virtual const DeviceCapability& capability() const noexcept = 0;
  virtual const ForceLimits& limits() const noexcept = 0;  ///< of the device
  /// "stepped" or "real_time", and how the thread is scheduled.
  virtual std::string pacing() const = 0;
  virtual std::string scheduling() const = 0;
  /// The current problem of the device (HapticDevice::complaint); empty while there is none.
  virtual std::string complaint() const { return {}; }

  /// Sets the hand for the next attempt, lifted. A stepped rig restarts, so that an attempt does
  /// not depend on earlier ones.
  virtual void prepare_attempt(const HandHabits& habits, const Random& random) = 0;

  virtual void pass(double duration_s, Recorder& recorder) = 0;

  /// Zero force at once, latched; from any thread.
  virtual void emergency_stop() noexcept = 0;
  /// Clears the fault that the loop reported to the caller; another fault that has come since
  /// remains.
  virtual void clear_fault(Fault seen) noexcept { loop().clear_fault(seen); }

 protected:
  Rig() = default;
};

/// A simulated device on a simulated clock, which runs as fast as the machine can.
class SteppedRig final : public Rig {
 public:
  SteppedRig(const RigSettings& settings, std::int64_t session_index);
  ~SteppedRig() override;

  const Clock& clock() const noexcept override { return clock_; }
  ServoLoop& loop() noexcept override;
  RecordRing& records() noexcept override;
  VirtualHand& hand() noexcept override;
  const DeviceCapability& capability() const noexcept override;
  const ForceLimits& limits() const noexcept override;
  std::string pacing() const override { return "stepped"; }
  std::string scheduling() const override { return "none"; }
  void prepare_attempt(const HandHabits& habits, const Random& random) override;
  void pass(double duration_s, Recorder& recorder) override;
  /// Takes effect in the loop's next tick, within an attempt or between attempts.
  void emergency_stop() noexcept override { stop_wanted_.store(true); }
  void clear_fault(Fault seen) noexcept override;

  /// A resumed session continues after the last stored time.
  void move_clock_to(std::int64_t now_ns);

 private:
  struct Assembly;
  RigSettings settings_{};
  SimulatedClock clock_;
  std::int64_t grid_origin_ns_ = 0;
  std::int64_t ticks_since_origin_ = 0;
  double owed_s_ = 0.0;
  std::atomic<bool> stop_wanted_{false};
  std::unique_ptr<Assembly> assembly_;
};

/// Opens the device of a rig. The hand holds the simulated device; other devices ignore it.
using DeviceOpening = std::function<std::unique_ptr<HapticDevice>(VirtualHand& hand)>;

/// The device of a rig in real time: its name as RunInputs::device, and the settings of its driver.
struct NamedDevice {
  std::string name = "simulated";
  DriverOptions options{};
};

/// A device in real time, on a servo thread.
///
/// The device and the loop belong to the servo thread as well: the destructor waits for a tick for a second at most, and
/// leaves both, at zero force, to a tick that does not return (ServoThread). The device then stays open until that tick
/// returns or the program ends.
class RealTimeRig final : public Rig {
 public:
  /// `not_before_ns`: the session's clock starts from there when the machine's clock is behind it
  /// (which restarts with the machine).
  RealTimeRig(const RigSettings& settings, const HandHabits& habits, const Random& random,
              Scheduling scheduling, std::int64_t not_before_ns);
  /// Uses the device that `open` opens instead of the simulated one of the settings.
  RealTimeRig(const RigSettings& settings, const HandHabits& habits, const Random& random,
              Scheduling scheduling, std::int64_t not_before_ns, const DeviceOpening& open);
  ~RealTimeRig() override;

  const Clock& clock() const noexcept override { return clock_; }
  ServoLoop& loop() noexcept override;
  RecordRing& records() noexcept override;
  VirtualHand& hand() noexcept override;
  const DeviceCapability& capability() const noexcept override;
  const ForceLimits& limits() const noexcept override;
  std::string pacing() const override { return "real_time"; }
  std::string scheduling() const override { return thread_.scheduling(); }
  std::string complaint() const override;
  void prepare_attempt(const HandHabits& habits, const Random& random) override;
  void pass(double duration_s, Recorder& recorder) override;
  void emergency_stop() noexcept override { loop().emergency_stop(); }

 private:
  struct Driven;
  SystemClock clock_;
  std::shared_ptr<Driven> driven_;  // shared with the servo thread
  ServoThread thread_;
};

/// A rig in real time, whose thread is scheduled as favourably as the system permits: on the
/// simulated device of the settings where the name is that of one, otherwise on a device that one
/// of the drivers opens. It can play recordings ("replay:FILE").
/// Errors: as DriverRegistry::open.
std::unique_ptr<RealTimeRig> open_rig(const NamedDevice& device, const DriverRegistry& drivers,
                                      const RigSettings& settings, const Random& hand,
                                      std::int64_t not_before_ns);

}  // namespace asperity
