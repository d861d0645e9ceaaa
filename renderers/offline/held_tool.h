// A tool in a hand that is drawn over a surface: mass, spring and damper.

#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"

namespace asperity {

/// What the hand and the tool in it are along the stroke.
struct HandModel {
  double mass_kg = 0.05;             ///< of the tool and of what moves with it
  double damping_N_s_per_m = 3.0;    ///< of the hand
  double stiffness_N_per_m = 200.0;  ///< of the hand's hold along the stroke
};

/// A tool whose hand moves along +x at a constant speed, after the drawing of the source, which gives
/// no numbers [Otaduy 2004]:
///
///   m·ẍ = k_h·(v·t − x) + b_h·(v − ẋ) + F_x
///   height   z stays, whatever pushes                           (constant height)
///   press    m·z̈ = F_z − P − b_h·ż, P the force of the hand     (constant force)
///
/// with F the surface's force on the tool, taken where the tool is after each step. y stays 0. Steps
/// are those of velocity Verlet with the dampers implicit: of second order, F asked for once a step.
///
/// Fed with a force that was recorded instead of computed, its acceleration is what that force does to a
/// held tool (FeltRoughness).
///
/// Errors: std::invalid_argument, naming the field, for a mass that is not positive, and a damping or a
/// stiffness that is negative.
///
/// Real-time: `advance` and `feel` do not allocate, lock or throw.
class HeldTool final {
 public:
  struct Stroke {
    double speed_m_per_s = 0.0;
    std::optional<double> press_N{};  ///< nothing: held at its height
    glm::dvec3 start_m{0.0};
  };

  HeldTool(const HandModel& hand, const Stroke& stroke);

  /// The tool as it is: at first in step with the hand.
  const ProbeState& state() const noexcept { return state_; }
  /// Moves it on; its velocity is a guess until `feel`.
  const ProbeState& advance(double dt_s) noexcept;
  /// The surface's force there, in newtons: ends the step. Also before the first one.
  void feel(const glm::dvec3& force_N) noexcept;
  /// Along x and z, after `feel`.
  const glm::dvec2& acceleration_m_per_s2() const noexcept { return acceleration_m_per_s2_; }

 private:
  HandModel hand_{};
  Stroke stroke_{};
  ProbeState state_{};
  double time_s_ = 0.0;
  double dt_s_ = 0.0;
  glm::dvec2 velocity_m_per_s_{0.0};  ///< at the end of the last whole step
  glm::dvec2 acceleration_m_per_s2_{0.0};
};

/// How fast a hand forgets how the stroke began: the slowest of its modes, against a surface of that
/// stiffness where it presses with a force. In 1/s; 0 without damping.
double slowest_decay_per_s(const HandModel& hand, std::optional<double> surface_N_per_m) noexcept;

}  // namespace asperity
