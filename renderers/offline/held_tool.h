// Declares a tool in a hand that is drawn over a surface: mass, spring and damper.

#pragma once

#include <optional>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"

namespace asperity {

/// The mechanical parameters of the hand and its tool along the stroke.
struct HandModel {
  double mass_kg = 0.05;             ///< of the tool and of what moves with it
  double damping_N_s_per_m = 3.0;    ///< of the hand
  double stiffness_N_per_m = 200.0;  ///< of the grip along the stroke
};

/// A hand with a name. Its values are chosen, not measured.
struct HandPreset {
  const char* name = "";
  HandModel hand{};
  const char* choice = "";  ///< what the values were chosen for, as a phrase of the command line
};

/// All presets; the first is the default.
///
/// `firm` is damped so strongly that its tool neither bounces nor is caught on the cones of the library's protocols. On 3 kN/m, as
/// there, it keeps contact from 0.5 N on; on a stiffer surface it sinks into the gaps more slowly, with P/b, than it passes them.
/// No published measurement of a hand above 100 Hz is known that has a damping of 30 N s/m.
std::span<const HandPreset> hand_presets() noexcept;

/// Integrates the motion of a tool whose hand moves along +x at a constant speed, after the drawing in the source,
/// which gives no numbers [Otaduy 2004]:
///
///   m·ẍ = k_h·(v·t − x) + b_h·(v − ẋ) + F_x
///   height   z is constant                                      (constant height)
///   press    m·z̈ = F_z − P − b_h·ż, P the force of the hand     (constant force)
///
/// F is the surface's force on the tool at its position after each step. y stays 0. The integrator is velocity Verlet
/// with implicit dampers: of second order, with one evaluation of F per step.
///
/// With a recorded force instead of a computed one, the acceleration is the effect of this force on a held tool
/// (FeltRoughness).
///
/// Errors: std::invalid_argument, naming the field, for a mass that is not positive, and a negative damping or
/// stiffness.
///
/// Real-time: `advance` and `feel` do not allocate, lock or throw.
class HeldTool final {
 public:
  struct Stroke {
    double speed_m_per_s = 0.0;
    std::optional<double> press_N{};  ///< nullopt: held at its height
    glm::dvec3 start_m{0.0};
  };

  HeldTool(const HandModel& hand, const Stroke& stroke);

  /// The current state of the tool; initially it moves with the hand.
  const ProbeState& state() const noexcept { return state_; }
  /// Advances the position by one step; the velocity is an estimate until `feel`.
  const ProbeState& advance(double dt_s) noexcept;
  /// Ends the step with the surface's force at the new position, in newtons. Also required before the first step.
  void feel(const glm::dvec3& force_N) noexcept;
  /// Along x and z, after `feel`.
  const glm::dvec2& acceleration_m_per_s2() const noexcept { return acceleration_m_per_s2_; }

 private:
  HandModel hand_{};
  Stroke stroke_{};
  ProbeState state_{};
  double time_s_ = 0.0;
  double dt_s_ = 0.0;
  glm::dvec2 velocity_m_per_s_{0.0};  ///< at the end of the last complete step
  glm::dvec2 acceleration_m_per_s2_{0.0};
};

/// The decay rate of the initial transient: that of the slowest mode of the hand, against a surface of this stiffness
/// if the hand presses with a force. In 1/s; 0 without damping.
double slowest_decay_per_s(const HandModel& hand, std::optional<double> surface_N_per_m) noexcept;

}  // namespace asperity
