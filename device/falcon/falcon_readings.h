// What a Falcon's answers mean: places and velocities.

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "device/falcon/falcon_frame.h"
#include "device/falcon/falcon_kinematics.h"
#include "device/velocity_estimator.h"

namespace asperity::falcon {

/// One answer of the device, in the machine's own frame.
struct Reading {
  std::int64_t time_ns = 0;  ///< monotonic, when the answer was here
  ArmAngles_rad angles{};
  glm::dvec3 position_m{0.0};
  glm::dvec3 velocity_m_per_s{0.0};
  std::uint32_t buttons = 0;
  bool is_homed = false;  ///< otherwise the rest, but for the buttons, means nothing
};

/// Turns answers into readings.
///
/// Guarantees: there is no reading for counts at which the legs do not meet, so that every reading is finite. A place that
/// implies a speed that no hand has, after a bit flipped on the wire or the encoders lost counts, is reported, as by every
/// driver: it does not enter the velocity (velocity_estimator.h), and the servo loop does not use it (reading_check.h).
///
/// Real-time: does not allocate, lock or throw.
class Readings final {
 public:
  explicit Readings(const VelocityWindow& velocity) : velocity_(velocity) {}

  std::optional<Reading> take(const Answer& answer, std::int64_t now_ns) noexcept;
  bool is_homed() const noexcept { return is_homed_; }
  /// The next answer has nothing to do with those before.
  void reset() noexcept;

 private:
  VelocityEstimator velocity_;
  bool is_homed_ = false;
};

}  // namespace asperity::falcon
