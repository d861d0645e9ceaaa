// What a device's sensors make of the hand: late, in steps, with noise.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "analysis/numbers/random.h"
#include "device/probe_state.h"
#include "device/velocity_estimator.h"

namespace asperity {

/// How far the reading of a hand is from the hand; the defaults: not at all.
struct SensorSettings {
  /// How old what is read is, at most 0.05. The way of a force to the motors belongs here too: in a
  /// loop of hand and force both delays do the same.
  double latency_s = 0.0;
  double position_noise_m = 0.0;  ///< standard deviation, in each axis and each reading anew
  double position_step_m = 0.0;   ///< positions are multiples of this, in each axis
  /// Velocity is estimated from the positions that are read, as drivers do it. Without, it is the
  /// hand's own, `latency_s` old, whatever noise and steps the positions have.
  std::optional<VelocityWindow> velocity{};
  std::uint64_t noise_seed = 0;
};

/// In this order:
///
///   x̂(t) = step · round((x(t − latency) + noise · z) / step),   z standard normal
///
/// so that noise and steps together have a deviation of √(noise² + step²/12) where noise is not
/// small against the step. Between two readings the hand moved evenly. Before `latency_s` have
/// passed it is where it was first. Buttons are not late; nor is the time, which is that of the
/// reading, because no device measures it better.
///
/// What the caller may rely on: with the defaults every reading is the hand, bit for bit.
///
/// Errors: the constructor throws std::invalid_argument naming the setting.
///
/// Real-time: `read` does not allocate, lock or throw. Up to 10 kHz the latency is the one that was set.
class ImperfectSensor final {
 public:
  explicit ImperfectSensor(const SensorSettings& settings);

  /// `hand` is where it is now; times do not go back.
  ProbeState read(const ProbeState& hand) noexcept;

 private:
  struct Past {
    std::int64_t time_ns = 0;
    glm::dvec3 position_m{0.0};
    glm::dvec3 velocity_m_per_s{0.0};
  };
  const Past& past(std::size_t i) const noexcept { return pasts_[(oldest_ + i) % pasts_.size()]; }
  void delay(ProbeState& state) noexcept;

  SensorSettings settings_{};
  Random random_;
  std::optional<VelocityEstimator> velocity_{};
  std::vector<Past> pasts_{};  // a ring
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
};

}  // namespace asperity
