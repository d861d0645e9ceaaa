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

// Of the way from c to the wanted force, to the precision of its numbers.
constexpr int kHalvings = 53;

// Periods are whole nanoseconds: three of 333 333 ns are a window.
constexpr double kRounding_s = 1e-7;

}  // namespace

glm::dvec3 nearest_on_fall(const glm::dvec3& g, const glm::dvec3& w) noexcept {
  const double squared = glm::dot(g, g);
  if (!(squared > 0.0)) return glm::dvec3(0.0);
  return std::clamp(glm::dot(g, w) / squared, 0.0, 1.0) * g;
}

double growth(const glm::dvec3& from, const glm::dvec3& to) noexcept {
  return glm::length(to - nearest_on_fall(from, to));
}

ForceLimiter::ForceLimiter(const ForceLimits& limits) : limits_(limits) {
  require_positive("force_N of the force limits", limits.force_N);
  require_positive("torque_N_m of the force limits", limits.torque_N_m);
  require_positive("slew_N of the force limits", limits.slew_N);
  require_positive("slew_N_m of the force limits", limits.slew_N_m);
}

void ForceLimiter::reset() noexcept {
  held_.front() = Held{};
  held_count_ = 1;
}

void ForceLimiter::let_pass(double elapsed_s) noexcept {
  // Written so that a time that is not a number does not pass.
  const double passed_s = elapsed_s > 0.0 ? elapsed_s : 0.0;
  for (std::size_t i = 1; i < held_count_; ++i) held_[i].ended_s += passed_s;
  while (held_count_ > 1 && held_[held_count_ - 1].ended_s > kWindow_s - kRounding_s) {
    --held_count_;
  }
}

// The force before ends now. In a full window it only fell, and is replaced: what may follow the rest of a fall is less than
// what may follow its beginning.
void ForceLimiter::hold(const Wrench& wrench) noexcept {
  if (held_count_ == kMostHeld) {
    held_.front().wrench = wrench;
    return;
  }
  std::copy_backward(held_.begin(), held_.begin() + static_cast<std::ptrdiff_t>(held_count_),
                     held_.begin() + static_cast<std::ptrdiff_t>(held_count_) + 1);
  held_.front() = {.wrench = wrench};
  ++held_count_;
}

glm::dvec3 ForceLimiter::limited_to(const VectorLimit& limit, const glm::dvec3& wanted,
                                    LimitedWrench& limited) const noexcept {
  const glm::dvec3 aim = no_longer_than(limit.length, wanted);
  if (aim != wanted) add(limit.too_long, limited);
  const auto may_follow = [&](const glm::dvec3& vector) {
    for (std::size_t i = 0; i < held_count_; ++i) {
      if (growth(held_[i].wrench.*limit.part, vector) > limit.slew) return false;
    }
    return true;
  };
  const glm::dvec3 fallen = nearest_on_fall(held_.front().wrench.*limit.part, aim);
  const bool may_grow = held_count_ < kMostHeld;
  if (aim == fallen || (may_grow && may_follow(aim))) return aim;
  add(LimitReason::slew, limited);
  if (!may_grow) return fallen;
  double allowed = 0.0;
  double step = 0.5;
  for (int halving = 0; halving < kHalvings; ++halving, step *= 0.5) {
    if (may_follow(fallen + (allowed + step) * (aim - fallen))) allowed += step;
  }
  // Both ends of the line lie inside the limit, so its points do; their rounded sum may not.
  return no_longer_than(limit.length, fallen + allowed * (aim - fallen));
}

LimitedWrench ForceLimiter::limit(const Wrench& wanted, double elapsed_s) noexcept {
  LimitedWrench limited{};
  if (!is_finite(wanted.force_N) || !is_finite(wanted.torque_N_m)) {
    add(LimitReason::not_finite, limited);
    reset();
    return limited;
  }
  let_pass(elapsed_s);
  limited.wrench.force_N =
      limited_to({limits_.force_N, limits_.slew_N, &Wrench::force_N, LimitReason::force},
                 wanted.force_N, limited);
  limited.wrench.torque_N_m =
      limited_to({limits_.torque_N_m, limits_.slew_N_m, &Wrench::torque_N_m, LimitReason::torque},
                 wanted.torque_N_m, limited);
  hold(limited.wrench);
  return limited;
}

}  // namespace asperity
