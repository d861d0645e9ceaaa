// Measures a device: its timing, its mechanics, and that it lets go when it has to.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stop_token>
#include <string>

#include "app/device_bench/device_bench.h"
#include "app/profiles/device_profile.h"
#include "device/haptic_device.h"

namespace asperity {

/// What is done one after the other.
enum class DeviceTestPart {
  timing,
  safety,
  sweeps,
  pushes,
  tones,
  springs,
  small_pushes,
  workspace
};

/// What comes next, and how much is done.
struct DeviceTestNews {
  DeviceTestPart part = DeviceTestPart::timing;
  std::optional<int> axis{};  ///< 0, 1, 2 for x, y, z where they are taken apart
  std::string what{};         ///< "slow and faster sweeps along x", for a terminal
  double done = 0.0;          ///< 0 to 1
};

struct DeviceTestOptions {
  double rate_Hz = 1000.0;
  /// No force is ever stronger; also not above what the device gives for long.
  double force_N = 3.0;
  /// The name of an item with a number → what it is held to, instead of its own limit.
  std::map<std::string, double> limits{};
  /// A simulated device's timing is reported and not judged.
  bool is_simulated = false;
  /// Of what moves the device; timing and safety are always in real time with `real_time`.
  StagePacing mechanics = StagePacing::real_time;
  StagePacing timing = StagePacing::real_time;
  /// How long a person has to move the handle along the borders of its workspace; 0: it is not moved.
  double workspace_s = 0.0;
  std::function<void(const DeviceTestNews&)> tell{};  ///< before each part, and each axis of it
  WatchTicks watch{};                                 ///< see DeviceBench
};

/// Measures it, in a minute and a half in real time. The device moves by itself: by at most 30 mm, with at
/// most `force_N`; the handle hangs free. Every force goes through the servo loop and the limiter,
/// fades in and out, and is let go of when the handle runs away.
///
///   timing      rate_Hz lateness_p50_s lateness_p99_s lateness_max_s missed_deadlines force_zero_N
///               position_noise_m
///   safety      limiter zero_after_stop zero_after_not_finite zero_without_heartbeat
///   mechanics   friction_N damping_N_s_per_m position_resolution_m latency_s moving_mass_kg resonance_Hz
///               stiffness_N_per_m force_resolution_N workspace_reached
///
/// Each item is there exactly once, and in that order; beside them the responses to the tones. Default limits: rate_Hz at least 95 % of what was
/// asked for, lateness_p99_s at most a period, force_zero_N 0; workspace_reached at least 0.8. How each
/// number is found stands in docs/formats/device_profile.md. What is not known of the device that a simulated one stands
/// for (DeviceCapability::not_known) is not measured of it.
///
/// Errors: std::invalid_argument for a rate or a force that is not positive and for a limit on what is no
/// item with a number; DeviceStageStopped; std::runtime_error when the device is lost.
DeviceProfile test_device(HapticDevice& device, const DeviceTestOptions& options,
                          const std::stop_token& stop);

}  // namespace asperity
