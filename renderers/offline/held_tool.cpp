// Implements the integration steps of a held tool.

#include "renderers/offline/held_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "device/refusal.h"

namespace asperity {
namespace {

constexpr std::array<HandPreset, 2> kPresets{{
    {.name = "light", .hand = {}, .choice = "lightly damped, the default"},
    {.name = "firm",
     .hand = {.mass_kg = 0.02, .damping_N_s_per_m = 30.0, .stiffness_N_per_m = 200.0},
     .choice = "chosen so that contact is kept"},
}};

// The slowest decay of m·ẍ + b·ẋ + k·x = 0.
double decay_of(double mass_kg, double damping_N_s_per_m, double stiffness_N_per_m) noexcept {
  const double half = 0.5 * damping_N_s_per_m / mass_kg;
  const double over = half * half - stiffness_N_per_m / mass_kg;
  return over > 0.0 ? half - std::sqrt(over) : half;
}

}  // namespace

std::span<const HandPreset> hand_presets() noexcept { return kPresets; }

HeldTool::HeldTool(const HandModel& hand, const Stroke& stroke) : hand_(hand), stroke_(stroke) {
  require_positive("HandModel::mass_kg", hand.mass_kg);
  require_not_negative("HandModel::damping_N_s_per_m", hand.damping_N_s_per_m);
  require_not_negative("HandModel::stiffness_N_per_m", hand.stiffness_N_per_m);
  state_.position_m = stroke.start_m;
  state_.velocity_m_per_s = {stroke.speed_m_per_s, 0.0, 0.0};
  velocity_m_per_s_ = {stroke.speed_m_per_s, 0.0};
}

const ProbeState& HeldTool::advance(double dt_s) noexcept {
  dt_s_ = dt_s;
  time_s_ += dt_s;
  const glm::dvec2 step_m = dt_s * velocity_m_per_s_ + 0.5 * dt_s * dt_s * acceleration_m_per_s2_;
  const glm::dvec2 guess_m_per_s = velocity_m_per_s_ + dt_s * acceleration_m_per_s2_;
  state_.position_m += glm::dvec3{step_m.x, 0.0, step_m.y};
  state_.velocity_m_per_s = {guess_m_per_s.x, 0.0, guess_m_per_s.y};
  state_.time_ns = std::llround(time_s_ * 1e9);
  return state_;
}

void HeldTool::feel(const glm::dvec3& force_N) noexcept {
  const double behind_m = stroke_.start_m.x + stroke_.speed_m_per_s * time_s_ - state_.position_m.x;
  // All forces except the damper's for the unknown new velocity.
  const glm::dvec2 free_N{force_N.x + hand_.stiffness_N_per_m * behind_m +
                              hand_.damping_N_s_per_m * stroke_.speed_m_per_s,
                          stroke_.press_N ? force_N.z - *stroke_.press_N : 0.0};
  const double half_s = 0.5 * dt_s_;
  velocity_m_per_s_ =
      (velocity_m_per_s_ + half_s * (acceleration_m_per_s2_ + free_N / hand_.mass_kg)) /
      (1.0 + half_s * hand_.damping_N_s_per_m / hand_.mass_kg);
  if (!stroke_.press_N) velocity_m_per_s_.y = 0.0;
  acceleration_m_per_s2_ = (free_N - hand_.damping_N_s_per_m * velocity_m_per_s_) / hand_.mass_kg;
  state_.velocity_m_per_s = {velocity_m_per_s_.x, 0.0, velocity_m_per_s_.y};
}

double slowest_decay_per_s(const HandModel& hand, std::optional<double> surface_N_per_m) noexcept {
  const double along = decay_of(hand.mass_kg, hand.damping_N_s_per_m, hand.stiffness_N_per_m);
  if (!surface_N_per_m) return along;
  return std::min(along, decay_of(hand.mass_kg, hand.damping_N_s_per_m, *surface_N_per_m));
}

}  // namespace asperity
