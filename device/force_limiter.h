// The last arithmetic before the motors.

#pragma once

#include <cstdint>

#include "device/wrench.h"

namespace asperity {

/// What a wrench may be at most. Never above the device's own limits.
struct ForceLimits {
  double force_N = 5.0;     ///< magnitude [Wu 2009]
  double torque_N_m = 0.1;  ///< magnitude
  double slew_N_per_s =
      5000.0;  ///< magnitude of the change of force per second: from zero to 5 N in 1 ms
  double slew_N_m_per_s =
      100.0;  ///< magnitude of the change of torque per second: from zero to 0.1 N·m in 1 ms
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

/// Makes any wrench safe to send.
///
/// In this order: a wrench with a component that is not finite becomes zero at once, past the slew
/// limits; a force longer than the limit keeps its direction and gets the limit's length; a change
/// of force faster than the slew limit is shortened along the line from the last force to the new
/// one, so the result is never longer than the longer of the two. The torque is limited in the same
/// way, independently of the force.
///
/// What the caller may rely on: the length of each vector returned, √(x² + y² + z²) in double, is
/// never above its limit, not by one unit in the last place. A wrench within the limits is returned
/// bit for bit.
///
/// Errors: the constructor throws std::invalid_argument for a limit that is not positive and
/// finite.
///
/// Real-time: `limit` and `reset` do not allocate, lock or throw.
class ForceLimiter final {
 public:
  explicit ForceLimiter(const ForceLimits& limits);
  const ForceLimits& limits() const noexcept { return limits_; }
  /// `dt_s` is the time since the last call, positive; anything else allows no change.
  LimitedWrench limit(const Wrench& wanted, double dt_s) noexcept;
  /// The motors were set to zero: the next change is counted from there.
  void reset() noexcept { last_ = Wrench{}; }

 private:
  ForceLimits limits_{};
  Wrench last_{};
};

}  // namespace asperity
