// What a Falcon's answers mean: places and velocities.

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "device/falcon/falcon_frame.h"
#include "device/falcon/falcon_kinematics.h"
#include "device/reading_check.h"
#include "device/velocity_estimator.h"

namespace asperity::falcon {

/// Where the arms are and the grip that they hold, in the machine's own frame.
struct Pose {
  ArmAngles_rad angles{};
  glm::dvec3 position_m{0.0};
};

/// One answer of the device, in the machine's own frame.
struct Reading {
  std::int64_t time_ns = 0;  ///< monotonic, when the answer was here
  glm::dvec3 position_m{0.0};
  /// The latest plausible pose: torques are computed from it. Those of a wild one would push in a wrong direction.
  Pose plausible{};
  glm::dvec3 velocity_m_per_s{0.0};
  std::uint32_t buttons = 0;
  bool is_homed = false;  ///< otherwise the rest, but for the buttons, means nothing
};

/// Turns answers into readings.
///
/// Guarantees: there is no reading for counts at which the legs do not meet, so that every reading is finite. A place that
/// implies a speed that no hand has (reading_check.h), after a bit flipped on the wire or the encoders lost counts, is
/// reported, so that the servo loop can hold the last one and then lose the device. It enters neither the velocity nor
/// `Reading::plausible`, which is held for up to kPoseLasts_ns: by then the loop has latched its fault, and the place is
/// where a motion begins that is new.
///
/// Real-time: does not allocate, lock or throw.
class Readings final {
 public:
  static constexpr std::int64_t kPoseLasts_ns = 50'000'000;

  explicit Readings(const VelocityWindow& velocity) : velocity_(velocity) {}

  std::optional<Reading> take(const Answer& answer, std::int64_t now_ns) noexcept;
  bool is_homed() const noexcept { return is_homed_; }
  /// The next answer has nothing to do with those before.
  void reset() noexcept;

 private:
  void judge(std::int64_t now_ns, const Pose& pose) noexcept;

  VelocityEstimator velocity_;
  ReadingCheck check_{kFastestHand_m_per_s};
  Pose plausible_{};
  std::int64_t plausible_ns_ = 0;
  bool is_homed_ = false;
};

}  // namespace asperity::falcon
