// A hand that strokes as people do, for the simulated device.

#pragma once

#include <atomic>
#include <cstdint>

#include <glm/vec3.hpp>

#include "analysis/random.h"

namespace asperity {

/// How a hand explores a surface. Means are over a stroke; deviations are between strokes.
struct HandHabits {
  glm::dvec3 centre_m{0.0};    ///< middle of the strokes, on the surface
  double direction_rad = 0.0;  ///< of the stroke, from +x towards +y
  double stroke_length_m = 0.060;
  double speed_m_per_s = 0.080;
  double speed_variation = 0.15;  ///< standard deviation of a stroke's speed, as a fraction
  double normal_force_N = 1.0;
  double force_variation = 0.10;  ///< likewise, of its force
  double drift_m =
      0.004;  ///< standard deviation of a slow wander of the stroke's centre, across and along
  double lift_height_m = 0.010;  ///< how far above the surface the hand waits
  double approach_speed_m_per_s = 0.05;
};

/// What the hand wants at one instant.
struct HandIntent {
  glm::dvec3 position_m{0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  double press_N = 0.0;  ///< downward force on top of the spring; 0 while lifted
  bool lifted = true;
};

/// Moves to and fro along a line with a minimum-jerk speed profile per stroke, presses with a force
/// that wanders, drifts, and lifts between surfaces. Seeded: the same seed and calls give the same
/// motion.
///
/// Threads: `stroke` and `lift` from any thread; `intent` from the one that reads the device.
///
/// Real-time: `intent` does not allocate, lock or throw.
class VirtualHand final {
 public:
  /// Errors: std::invalid_argument naming the habit that is not positive or finite.
  VirtualHand(const HandHabits& habits, Random random);

  void stroke() noexcept { wants_contact_.store(true, std::memory_order_relaxed); }
  void lift() noexcept { wants_contact_.store(false, std::memory_order_relaxed); }
  /// From the next stroke on. Call while lifted.
  void set_habits(const HandHabits& habits);

  /// `time_ns` never goes back.
  HandIntent intent(std::int64_t time_ns) noexcept;

 private:
  void begin_stroke(std::int64_t time_ns) noexcept;

  HandHabits habits_{};
  Random random_;
  std::atomic<bool> wants_contact_{false};
  bool started_ = false;
  bool lifted_ = true;
  std::int64_t last_ns_ = 0;
  std::int64_t stroke_began_ns_ = 0;
  double stroke_duration_s_ = 0.0;
  double stroke_from_m_ = 0.0;
  double stroke_to_m_ = 0.0;
  double stroke_force_N_ = 0.0;
  double along_m_ = 0.0;
  double across_m_ = 0.0;
  double height_m_ = 0.0;
  double direction_ = 1.0;
};

}  // namespace asperity
