// A probe that a deflected cap drives: the deflection is a velocity.

#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "device/haptic_device.h"
#include "device/spacemouse/cap_reports.h"

namespace asperity::spacemouse {

struct RateControlSettings {
  double full_speed_m_per_s = 0.1;   ///< along an axis at full deflection
  double full_turn_rad_per_s = 1.0;  ///< about one
  double dead_zone = 0.05;           ///< the share of the deflection that moves nothing
  glm::dvec3 workspace_minimum_m{-0.1, -0.1, -0.01};
  glm::dvec3 workspace_maximum_m{0.1, 0.1, 0.05};
  glm::dvec3 home_m{0.0, 0.0, 0.02};  ///< above the surface, which lies at z = 0
};

/// What was last told of the cap, and when.
struct CapReport {
  Cap cap{};
  std::int64_t moved_ns = 0;  ///< monotonic, when push or turn were last told, changed or not
};

/// Each axis of the push drives the probe along itself, and each of the turn about itself, at the rate
///
///   r(d) = ±R s²,   s = (|d| − z) / (1 − z) beyond the dead zone z, 0 within,   with the sign of d
///
/// where R is the full speed or turn: finer near rest than a straight line. With the rates v and ω that hold from one
/// reading to the next, T later,
///
///   x ← x + vT, at most to the faces of the workspace,   q ← exp(ωT/2) q
///
/// ω is about the axes of the room. The velocity is the path's own: none towards a face that the probe lies at.
///
/// What was told of the cap holds for 50 ms (`kHolds_ns`), as a device repeats it every 16 ms while it is deflected: no
/// report carries the probe farther, however late the next reading. `is_overdue` from then on, unless the rate is zero:
/// a cap at rest is silent, and that is no fault.
///
/// The second button takes the probe home: straight, at full speed and full turn, until it is there, whatever the cap
/// does meanwhile.
///
/// Frame: Asperity's; begins at home, unturned.
///
/// Errors: the constructor throws std::invalid_argument naming the setting that is out of its domain.
///
/// Real-time: all but the constructor does not allocate, lock or throw.
class RateControl final {
 public:
  static constexpr std::int64_t kHolds_ns = HapticDevice::kLongestSilence_ns;
  static constexpr std::uint32_t kHomeButton = 0b10;
  /// Those that are a participant's: bit 0.
  static constexpr std::uint32_t kOtherButtons = 0b01;

  explicit RateControl(const RateControlSettings& settings = {});
  const RateControlSettings& settings() const noexcept { return settings_; }

  /// Goes on to `now_ns` with what is known. Times that go back stand still.
  void advance(std::int64_t now_ns) noexcept;
  /// From now on this is what is known.
  void take(const CapReport& report) noexcept;
  /// Nothing moves, not even home, until the next report.
  void stop() noexcept;
  bool is_overdue(std::int64_t now_ns) const noexcept;

  const glm::dvec3& position_m() const noexcept { return position_m_; }
  const glm::dquat& orientation() const noexcept { return orientation_; }
  glm::dvec3 velocity_m_per_s() const noexcept;
  glm::dvec3 angular_velocity_rad_per_s() const noexcept;
  std::uint32_t buttons() const noexcept { return buttons_ & kOtherButtons; }

 private:
  glm::dvec3 rates(const glm::dvec3& deflection, double full) const noexcept;
  glm::dvec3 to_home_m() const noexcept { return settings_.home_m - position_m_; }
  glm::dvec3 turn_home_rad() const noexcept;
  void turn_by(const glm::dvec3& turn_rad) noexcept;
  void go_home(double dt_s) noexcept;

  RateControlSettings settings_{};
  glm::dvec3 position_m_{0.0};
  glm::dquat orientation_{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 push_m_per_s_{0.0};
  glm::dvec3 turn_rad_per_s_{0.0};
  std::int64_t moved_ns_ = 0;
  std::int64_t last_ns_ = 0;
  bool has_begun_ = false;
  bool goes_home_ = false;
  std::uint32_t buttons_ = 0;
};

}  // namespace asperity::spacemouse
