// Runs a device through short stages on the real servo loop, and hands back every tick.

#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "app/words/phrase_of_error.h"
#include "device/haptic_device.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

/// The work was stopped on request; the force is zero.
class DeviceStageStopped final : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A call into the driver does not return. It uses the device until the program ends: the device must not be destroyed, and
/// nothing is called on it any more. The watch of the servo thread keeps its force at zero as far as the driver permits.
class DriverHangs final : public PhrasedError {
  using PhrasedError::PhrasedError;
};

/// One stretch of ticks on a device.
struct DeviceStage {
  double duration_s = 1.0;
  /// The force in the device's frame, `since_s` after the stage began; it fades in and out as every
  /// surface does, and passes the limiter. Empty: nothing is presented. Must not allocate or throw.
  std::function<glm::dvec3(double since_s, const ProbeState& probe)> force_N{};
  /// Farther than this from where the stage began the force is let go of, for good.
  double reach_m = 0.030;
  ServoSettings servo{};
  /// Called repeatedly by the thread that conducts the loop, every 5 ms or so; empty: nothing to do.
  std::function<void(ServoLoop& loop, double since_s)> conduct{};
  /// From then on the loop hears no heartbeat.
  std::optional<double> falls_silent_at_s{};
};

/// What happened. Times of the records are counted from the stage's beginning.
struct StageRecord {
  std::vector<TickRecord> ticks{};
  std::vector<double> time_s{};  ///< of each tick, since the presentation began (0 before it)
  Fault fault = Fault::none;
  bool ran_away = false;  ///< beyond DeviceStage::reach_m
  std::string trouble{};  ///< what the device complained of when it was lost
  std::string scheduling{};
};

/// Shown the ticks that came since it was last called, every 5 ms or so, by the thread that conducts the
/// loop and never by the servo's: for a picture while the device moves.
using WatchTicks = std::function<void(std::span<const TickRecord>)>;

/// How a stage's time goes by.
enum class StagePacing {
  real_time,  ///< on a ServoThread
  stepped,    ///< on a simulated clock, as fast as possible: for the simulated device
};

/// Each stage has a servo loop of its own, which leaves the device at zero force.
///
/// Errors: DeviceStageStopped when the token asks to stop: the loop's emergency stop comes first.
/// PhrasedError when the device is lost: that it said so and why, that it did not call, or that it did not answer and
/// says no reason; and what to do. DriverHangs, in real time: at most `kLongestHang` after a call into the driver that does
/// not return.
///
/// Threads: belongs to one.
class DeviceBench final {
 public:
  static constexpr std::chrono::seconds kLongestHang{4};

  /// The device outlives the bench, and has no other reader. `watch` may be empty.
  DeviceBench(HapticDevice& device, double rate_Hz, std::stop_token stop, WatchTicks watch = {});

  StageRecord run(const DeviceStage& stage, StagePacing pacing);

  HapticDevice& device() noexcept { return device_; }
  double rate_Hz() const noexcept { return rate_Hz_; }

 private:
  struct Driven;
  void run_in_real_time(const DeviceStage& stage, const std::shared_ptr<Driven>& driven,
                        StageRecord& record);
  void conduct(const DeviceStage& stage, Driven& driven, StageRecord& record);
  void run_stepped(const DeviceStage& stage, Driven& driven, StageRecord& record);
  void drain(RecordRing& ring, StageRecord& record) const;

  HapticDevice& device_;
  double rate_Hz_ = 1000.0;
  std::stop_token stop_{};
  WatchTicks watch_{};
  std::int64_t now_ns_ = 0;  // of stepped stages; never before the machine's clock
};

}  // namespace asperity
