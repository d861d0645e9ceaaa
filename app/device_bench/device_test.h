// Measures a device: its timing, its mechanics, and whether its forces end when they have to.

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

/// The parts of the measurement, in order.
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

/// The part that begins, and the progress so far.
struct DeviceTestNews {
  DeviceTestPart part = DeviceTestPart::timing;
  std::optional<int> axis{};  ///< 0, 1, 2 for x, y, z, if the part treats axes separately
  std::string what{};         ///< "slow and faster sweeps along x", for a terminal
  double done = 0.0;          ///< 0 to 1
};

struct DeviceTestOptions {
  double rate_Hz = 1000.0;
  /// The limit of every force, reduced to the peak and the continuous force of the device.
  double force_N = 3.0;
  /// The limits of items, by their names, instead of the default limits.
  std::map<std::string, double> limits{};
  /// A simulated device's timing is reported and not judged.
  bool is_simulated = false;
  StagePacing mechanics = StagePacing::real_time;  ///< of the parts that move the device
  StagePacing timing = StagePacing::real_time;     ///< of timing and safety
  /// The time for a person to move the handle along the borders of its workspace; 0 leaves this part out.
  double workspace_s = 0.0;
  std::function<void(const DeviceTestNews&)>
      tell{};          ///< called before each part, and each of its axes
  WatchTicks watch{};  ///< see DeviceBench
};

/// Measures a device, in one and a half to three minutes in real time. The device moves by itself: by at most 30 mm, with at
/// most `force_N`; the handle must not be held. Every force passes the servo loop and the limiter,
/// fades in and out, and is switched off when the handle moves too far away.
///
///   timing      rate_Hz lateness_p50_s lateness_p99_s lateness_max_s missed_deadlines force_zero_N
///               position_noise_m
///   safety      limiter zero_after_stop zero_after_not_finite zero_without_heartbeat
///   mechanics   friction_N damping_N_s_per_m position_resolution_m latency_s moving_mass_kg resonance_Hz
///               stiffness_N_per_m force_resolution_N workspace_reached
///
/// Each item occurs exactly once, in this order, in addition to the responses to the tones. Default limits: rate_Hz at
/// least 95 % of the requested rate, lateness_p99_s at most a period, force_zero_N 0; workspace_reached at least 0.8.
/// docs/formats/device_profile.md describes how each number is found. Properties of a real device that its simulated
/// model does not know (DeviceCapability::not_known) are not measured.
///
/// Errors: std::invalid_argument for a rate or a force that is not positive, and for a limit of an item that does not
/// exist or has no number; DeviceStageStopped; DriverHangs; std::runtime_error if the device is lost.
DeviceProfile test_device(HapticDevice& device, const DeviceTestOptions& options,
                          const std::stop_token& stop);

}  // namespace asperity
