// What a Falcon's answers mean: places and velocities, and which answers are not to be believed.

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
/// What the caller may rely on: there is no reading for counts at which the legs do not meet, and none
/// farther from the last reading than 1 mm and the way at 5 m/s since the last answer, which no hand
/// does. So every reading is finite, and a wild answer among good ones, a bit that flipped on the wire, is
/// dropped.
///
/// Encoders that go on telling of another place have lost or won counts: where the grip really is, nobody
/// knows. They are believed again after 100 ms, twice what a device may be silent: by then the device is
/// lost, its force at zero, and a person decides whether to go on.
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
  std::optional<Reading> last_{};
  std::int64_t heard_ns_ = 0;  // the last answer that told of a place, believed or not
  std::optional<std::int64_t> doubted_since_ns_{};
  bool is_homed_ = false;
};

}  // namespace asperity::falcon
