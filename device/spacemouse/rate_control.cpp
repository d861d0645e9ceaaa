// A probe that a deflected cap drives: the deflection is a velocity.

#include "device/spacemouse/rate_control.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "device/refusal.h"
#include "device/small_turn.h"

namespace asperity::spacemouse {
namespace {

constexpr glm::dquat kUnturned{1.0, 0.0, 0.0, 0.0};

void check(const RateControlSettings& settings) {
  require_positive("full_speed_m_per_s of the rate control", settings.full_speed_m_per_s);
  require_positive("full_turn_rad_per_s of the rate control", settings.full_turn_rad_per_s);
  require_not_negative("dead_zone of the rate control", settings.dead_zone);
  if (!(settings.dead_zone < 1.0)) {
    refuse("dead_zone of the rate control", settings.dead_zone, "less than 1");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double low_m = settings.workspace_minimum_m[axis];
    const double high_m = settings.workspace_maximum_m[axis];
    if (!(std::isfinite(low_m) && std::isfinite(high_m) && low_m < high_m)) {
      refuse("workspace_minimum_m of the rate control", low_m, "below workspace_maximum_m");
    }
    if (!(low_m <= settings.home_m[axis] && settings.home_m[axis] <= high_m)) {
      refuse("home_m of the rate control", settings.home_m[axis], "within the workspace");
    }
  }
}

// Towards `way`, at `speed`.
glm::dvec3 heading(const glm::dvec3& way, double speed) noexcept {
  const double length = glm::length(way);
  return length > 0.0 ? (speed / length) * way : glm::dvec3(0.0);
}

}  // namespace

RateControl::RateControl(const RateControlSettings& settings) : settings_(settings) {
  check(settings);
  position_m_ = settings_.home_m;
}

void RateControl::advance(std::int64_t now_ns) noexcept {
  const std::int64_t from_ns = has_begun_ ? last_ns_ : now_ns;
  last_ns_ = has_begun_ ? std::max(last_ns_, now_ns) : now_ns;
  has_begun_ = true;
  if (goes_home_) {
    go_home(1e-9 * static_cast<double>(last_ns_ - from_ns));
    return;
  }
  const std::int64_t until_ns = std::min(last_ns_, moved_ns_ + kHolds_ns);
  const double dt_s = 1e-9 * static_cast<double>(std::max(std::int64_t{0}, until_ns - from_ns));
  position_m_ = glm::clamp(position_m_ + dt_s * push_m_per_s_, settings_.workspace_minimum_m,
                           settings_.workspace_maximum_m);
  turn_by(dt_s * turn_rad_per_s_);
}

void RateControl::take(const CapReport& report) noexcept {
  push_m_per_s_ = rates(report.cap.push, settings_.full_speed_m_per_s);
  turn_rad_per_s_ = rates(report.cap.turn, settings_.full_turn_rad_per_s);
  moved_ns_ = report.moved_ns;
  if ((report.cap.buttons & ~buttons_ & kHomeButton) != 0) goes_home_ = true;
  buttons_ = report.cap.buttons;
}

void RateControl::stop() noexcept {
  push_m_per_s_ = turn_rad_per_s_ = glm::dvec3(0.0);
  goes_home_ = false;
}

bool RateControl::is_overdue(std::int64_t now_ns) const noexcept {
  const bool is_deflected = push_m_per_s_ != glm::dvec3(0.0) || turn_rad_per_s_ != glm::dvec3(0.0);
  return is_deflected && now_ns - moved_ns_ > kHolds_ns;
}

glm::dvec3 RateControl::velocity_m_per_s() const noexcept {
  if (goes_home_) return heading(to_home_m(), settings_.full_speed_m_per_s);
  glm::dvec3 velocity_m_per_s = push_m_per_s_;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_kept =
        (velocity_m_per_s[axis] > 0.0 &&
         position_m_[axis] >= settings_.workspace_maximum_m[axis]) ||
        (velocity_m_per_s[axis] < 0.0 && position_m_[axis] <= settings_.workspace_minimum_m[axis]);
    if (is_kept) velocity_m_per_s[axis] = 0.0;
  }
  return velocity_m_per_s;
}

glm::dvec3 RateControl::angular_velocity_rad_per_s() const noexcept {
  return goes_home_ ? heading(turn_home_rad(), settings_.full_turn_rad_per_s) : turn_rad_per_s_;
}

glm::dvec3 RateControl::rates(const glm::dvec3& deflection, double full) const noexcept {
  glm::dvec3 rates{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const double beyond = std::abs(deflection[axis]) - settings_.dead_zone;
    if (!(beyond > 0.0)) continue;
    const double share = std::min(1.0, beyond / (1.0 - settings_.dead_zone));
    rates[axis] = std::copysign(full * share * share, deflection[axis]);
  }
  return rates;
}

glm::dvec3 RateControl::turn_home_rad() const noexcept {
  return small_turn_rad(orientation_, kUnturned);
}

void RateControl::turn_by(const glm::dvec3& turn_rad) noexcept {
  const double angle_rad = glm::length(turn_rad);
  if (!(angle_rad > 0.0)) return;
  const glm::dvec3 axis = turn_rad / angle_rad;
  const double sine = std::sin(0.5 * angle_rad);
  const glm::dquat turn(std::cos(0.5 * angle_rad), sine * axis.x, sine * axis.y, sine * axis.z);
  orientation_ = glm::normalize(turn * orientation_);
}

void RateControl::go_home(double dt_s) noexcept {
  const glm::dvec3 way_m = to_home_m();
  const glm::dvec3 turn_rad = turn_home_rad();
  const double step_m = dt_s * settings_.full_speed_m_per_s;
  const double step_rad = dt_s * settings_.full_turn_rad_per_s;
  const bool is_there = glm::length(way_m) <= step_m;
  const bool is_unturned = glm::length(turn_rad) <= step_rad;
  position_m_ = is_there ? settings_.home_m : position_m_ + heading(way_m, step_m);
  if (is_unturned) {
    orientation_ = kUnturned;
  } else {
    turn_by(heading(turn_rad, step_rad));
  }
  goes_home_ = !(is_there && is_unturned);
}

}  // namespace asperity::spacemouse
