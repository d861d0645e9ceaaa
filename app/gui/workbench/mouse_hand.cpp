// Moves the probe to the mouse as a critically damped system in steps of 1 ms, at a depth below the body.

#include "app/gui/workbench/mouse_hand.h"

namespace asperity {

namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kPeriod_s = 0.001;
constexpr double kOmega_rad_per_s = 80.0;
constexpr double kAboveBodies_m = 0.001;  // their highest point is at 0
constexpr double kLowest_m = 1.0;

}  // namespace

void MouseHand::begin(const glm::dvec2& at_m) {
  target_m_ = at_m_ = at_m;
  velocity_m_per_s_ = {};
  next_ns_ = 0;
  level_m_ = 0.0;
  follow_body();
}

void MouseHand::follow_body() {
  if (body_ == nullptr) return;
  const auto hit = body_->search().first_front({.origin_m = {at_m_.x, at_m_.y, kAboveBodies_m},
                                                .direction = {0.0, 0.0, -1.0},
                                                .outward = {0.0, 0.0, 1.0},
                                                .reach = kLowest_m});
  if (hit) level_m_ = kAboveBodies_m - hit->distance;
}

std::vector<ProbeState> MouseHand::advance(std::int64_t until_ns) {
  std::vector<ProbeState> path{};
  for (; next_ns_ <= until_ns; next_ns_ += kPeriod_ns) {
    const double former_level_m = level_m_;
    if (next_ns_ > 0) {
      velocity_m_per_s_ += kPeriod_s * (kOmega_rad_per_s * kOmega_rad_per_s * (target_m_ - at_m_) -
                                        2.0 * kOmega_rad_per_s * velocity_m_per_s_);
      at_m_ += kPeriod_s * velocity_m_per_s_;
      follow_body();
    }
    path.push_back({.time_ns = next_ns_,
                    .position_m = {at_m_.x, at_m_.y, level_m_ - depth_m_},
                    .velocity_m_per_s = {velocity_m_per_s_.x, velocity_m_per_s_.y,
                                         (level_m_ - former_level_m) / kPeriod_s}});
  }
  return path;
}

}  // namespace asperity
