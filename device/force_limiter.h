// The last arithmetic before the motors.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "device/wrench.h"

namespace asperity {

/// What a wrench may be at most, and how far it may grow or turn within ForceLimiter::kWindow_s. The force is never above the
/// device's own limit.
struct ForceLimits {
  double force_N = 5.0;     ///< magnitude [Wu 2009]
  double torque_N_m = 0.1;  ///< magnitude
  double slew_N = 1.0;  ///< a texture of 0.5 N at 300 Hz changes by 2·0.5 N·sin(π·0.3) = 0.81 N
  double slew_N_m = 0.02;  ///< a fifth of the torque
};

/// Why a wrench was changed on its way to the motors; bits of LimitedWrench::reasons.
enum class LimitReason : std::uint8_t { not_finite = 1, force = 2, torque = 4, slew = 8 };

struct LimitedWrench {
  Wrench wrench{};
  std::uint8_t reasons = 0;  ///< 0: sent as asked
  bool has(LimitReason reason) const noexcept {
    return (reasons & static_cast<std::uint8_t>(reason)) != 0;
  }
};

/// The point nearest to `w` on the line from 0 to `g`: what remains of `g` in `w` after a fall.
glm::dvec3 nearest_on_fall(const glm::dvec3& g, const glm::dvec3& w) noexcept;

/// How far a force grows or turns in a step, min |to − s·from| for 0 ≤ s ≤ 1: 0 for a fall.
double growth(const glm::dvec3& from, const glm::dvec3& to) noexcept;

/// Makes any wrench safe to send.
///
/// In this order: a wrench with a component that is not finite becomes zero at once; a force longer than the limit keeps its
/// direction and gets the limit's length; a force that grows or turns too fast is moved less far. The torque is limited in the
/// same way, independently of the force.
///
/// **Growth.** The motors hold each force until the next is sent. The force f grows or turns from a force g by its distance from
/// the line from 0 to g, on which g only falls towards zero, d(f, g) = growth(g, f).
///
/// Every force is sent with d(f, g) ≤ slew_N for each g that the motors held within the last kWindow_s, that is, for the force
/// before, and for those that ended less than kWindow_s before. The time of a call is that since the call before, but at most one
/// nominal period: a force that was held during a stall is no reason for a larger step. At 1 kHz and below, a window has one step
/// of at most slew_N; at 4 kHz the four steps in it grow by slew_N together.
///
/// **Falls.** A fall towards zero is never delayed: a force that is held longer than its surface exerts it feeds energy to the
/// hand. Of the force before, g, the part in the wanted force w is the point c of the line from 0 to g that is nearest to w. The
/// force sent is the point farthest from c on the line from c to w that all distances allow. A part of w along g that is shorter
/// than g is thus sent as it is; where w points against g, the force is at zero or beyond at once. The sets {f: d(f, g) ≤ slew_N}
/// are convex and contain 0 and the force before, thus c as well, so that there is such a point. With one g in the window it is the
/// point nearest to w.
///
/// What the caller may rely on: the length of each vector returned, √(x² + y² + z²) in double, is
/// never above its limit, not by one unit in the last place. A wrench within the limits is returned
/// bit for bit.
///
/// Errors: the constructor throws std::invalid_argument for a limit that is not positive and
/// finite.
///
/// Real-time: `limit` and `reset` do not allocate, lock or throw. The time of `limit` is bounded; a few microseconds where a force
/// is moved less far.
class ForceLimiter final {
 public:
  static constexpr double kWindow_s = 1e-3;

  explicit ForceLimiter(const ForceLimits& limits);
  const ForceLimits& limits() const noexcept { return limits_; }
  /// `elapsed_s` is the time since the last call, at most a nominal period. If it is not positive, no time has passed.
  LimitedWrench limit(const Wrench& wanted, double elapsed_s) noexcept;
  /// The motors were set to zero: the force grows from there.
  void reset() noexcept;

 private:
  /// A wrench that the motors held, and the time since its end.
  struct Held {
    Wrench wrench{};
    double ended_s = 0.0;
  };
  /// Of one of the two vectors of a wrench.
  struct VectorLimit {
    double length;
    double slew;
    glm::dvec3 Wrench::*part;
    LimitReason too_long;
  };
  /// Calls within kWindow_s, at up to 31 kHz. With more of them no force grows.
  static constexpr std::size_t kMostHeld = 32;

  void let_pass(double elapsed_s) noexcept;
  void hold(const Wrench& wrench) noexcept;
  glm::dvec3 limited_to(const VectorLimit& limit, const glm::dvec3& wanted,
                        LimitedWrench& limited) const noexcept;

  ForceLimits limits_{};
  std::array<Held, kMostHeld> held_{};  ///< the newest first
  std::size_t held_count_ = 1;
};

}  // namespace asperity
