// The last arithmetic before the motors.

#include "device/force_limiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

// A shortened vector is made shorter by a few units in the last place than it might be, so that no
// rounding, here or in whoever computes its length again, puts it above the limit.
constexpr double kJustInside = 1.0 - 8.0 * std::numeric_limits<double>::epsilon();

bool is_finite(const glm::dvec3& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// `v` itself, or its direction with the length `limit`.
glm::dvec3 no_longer_than(double limit, const glm::dvec3& v) noexcept {
  if (glm::length(v) <= limit) {
    return v;
  }
  // Scaled first, because the square of a huge component is infinite and would lose the direction.
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const glm::dvec3 scaled = v / largest;
  return scaled * (kJustInside * limit / glm::length(scaled));
}

void add(LimitReason reason, LimitedWrench& limited) noexcept {
  limited.reasons = static_cast<std::uint8_t>(limited.reasons | static_cast<std::uint8_t>(reason));
}

// What one of the two vectors of a wrench may be, and why it is shortened where it is longer.
struct VectorLimit {
  double length;
  double change;
  LimitReason too_long;
};

// `wanted`, shortened to the limit, and to its change from `last`.
glm::dvec3 limited_to(const VectorLimit& limit, const glm::dvec3& wanted, const glm::dvec3& last,
                      LimitedWrench& limited) noexcept {
  const glm::dvec3 aim = no_longer_than(limit.length, wanted);
  if (aim != wanted) add(limit.too_long, limited);
  const glm::dvec3 wanted_change = aim - last;
  const glm::dvec3 change = no_longer_than(limit.change, wanted_change);
  if (change == wanted_change) return aim;
  add(LimitReason::slew, limited);
  // Both ends of the line lie inside the limit, so its points do; their rounded sum may not.
  return no_longer_than(limit.length, last + change);
}

}  // namespace

ForceLimiter::ForceLimiter(const ForceLimits& limits) : limits_(limits) {
  require_positive("force_N of the force limits", limits.force_N);
  require_positive("torque_N_m of the force limits", limits.torque_N_m);
  require_positive("slew_N_per_s of the force limits", limits.slew_N_per_s);
  require_positive("slew_N_m_per_s of the force limits", limits.slew_N_m_per_s);
}

LimitedWrench ForceLimiter::limit(const Wrench& wanted, double dt_s) noexcept {
  LimitedWrench limited{};
  if (!is_finite(wanted.force_N) || !is_finite(wanted.torque_N_m)) {
    add(LimitReason::not_finite, limited);
    last_ = limited.wrench;
    return limited;
  }

  // Written so that a dt that is not a number allows no change.
  const double elapsed_s = dt_s > 0.0 ? dt_s : 0.0;
  limited.wrench.force_N =
      limited_to({limits_.force_N, limits_.slew_N_per_s * elapsed_s, LimitReason::force},
                 wanted.force_N, last_.force_N, limited);
  limited.wrench.torque_N_m =
      limited_to({limits_.torque_N_m, limits_.slew_N_m_per_s * elapsed_s, LimitReason::torque},
                 wanted.torque_N_m, last_.torque_N_m, limited);
  last_ = limited.wrench;
  return limited;
}

}  // namespace asperity
