// A device test in progress: the device on its bench, and the items of the profile so far.

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/words/phrase.h"
#include "app/device_bench/device_bench.h"
#include "app/device_bench/device_test.h"
#include "app/profiles/device_profile.h"

namespace asperity {

inline constexpr int kTestedAxes = 3;
inline constexpr std::array<const char*, kTestedAxes> kTestedAxisNames{"x", "y", "z"};
/// From then on a stage has its full force, and the handle has come to rest.
inline constexpr double kSettled_s = 0.15;

/// The values of one quantity along three axes.
struct ByAxis {
  std::array<std::optional<double>, kTestedAxes> values{};
  std::array<Phrase, kTestedAxes> reasons{};  ///< why a value is missing
  Phrase text{};                              ///< how it was measured

  bool has(int axis) const { return values[static_cast<std::size_t>(axis)].has_value(); }
  double of(int axis, double otherwise) const {
    return values[static_cast<std::size_t>(axis)].value_or(otherwise);
  }
  const Phrase& reason(int axis) const { return reasons[static_cast<std::size_t>(axis)]; }
  void set(int axis, double value) { values[static_cast<std::size_t>(axis)] = value; }
  void miss(int axis, const Phrase& reason) { reasons[static_cast<std::size_t>(axis)] = reason; }
};

/// A soft spring with a damper to the position at which a stage began.
struct Hold {
  double stiffness_N_per_m = 200.0;
  double damping_N_s_per_m = 1.5;
  glm::dvec3 origin_m{0.0};

  glm::dvec3 force_N(double since_s, const ProbeState& probe) noexcept {
    if (since_s <= 0.0) origin_m = probe.position_m;
    return stiffness_N_per_m * (origin_m - probe.position_m) -
           damping_N_s_per_m * probe.velocity_m_per_s;
  }
};

/// Why a stage has no result; empty if it has.
Phrase blocker_of(const StageRecord& record, const DeviceStage& stage);

/// What all parts of a device test share: they run stages, announce themselves and store items.
class DeviceTestRun final {
 public:
  /// Sets the force limit of the device: the least of the options', its peak and its continuous force. `device` and
  /// `options` outlive the run.
  DeviceTestRun(HapticDevice& device, const DeviceTestOptions& options,
                const std::stop_token& stop);

  HapticDevice& device() noexcept { return device_; }
  const DeviceTestOptions& options() const noexcept { return options_; }
  bool has_motors() const noexcept { return has_motors_; }
  double force_N() const noexcept { return force_N_; }  ///< the limit of every force
  DeviceProfile& profile() noexcept { return profile_; }

  StageRecord time(const DeviceStage& stage) { return bench_.run(stage, options_.timing); }
  StageRecord move(const DeviceStage& stage) { return bench_.run(stage, options_.mechanics); }

  void announce(DeviceTestPart part, std::string what, double done) const;
  void announce(DeviceTestPart part, const std::string& what, int axis, double done) const;

  /// Stores an item with a number, and compares it with its limit.
  void judge(const std::string& name, std::optional<double> value, const Phrase& text,
             std::vector<double> by_axis = {});
  /// The value is the worst of the axes.
  void judge(const std::string& name, const ByAxis& found);
  /// Stores an item that is met or not.
  void judge_met(const std::string& name, bool is_met, const Phrase& text);
  void leave_out(const std::vector<std::string>& names, const Phrase& why);
  /// Leaves an item out that cannot be measured: there are no motors, or the real device's value is unknown.
  bool is_left_out(const std::string& name);

 private:
  HapticDevice& device_;
  const DeviceTestOptions& options_;
  UsualLimits usual_;
  DeviceBench bench_;
  bool has_motors_ = true;
  double force_N_ = 0.0;
  DeviceProfile profile_{};
};

}  // namespace asperity
