// Declares the simulated tool between the hand and the surfaces: a virtual coupling, integrated implicitly.

#pragma once

#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "device/probe_state.h"
#include "device/wrench.h"

namespace asperity {

/// A rigid body's pose: the position of its centre of mass and its orientation.
struct ToolPose {
  glm::dvec3 centre_m{0.0};
  glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};

/// A contact as a penalty energy ½·k·δ² of the tool's pose, to first order around the current pose:
///
///   δ(x + dx) = δ + ∇δ · dx      dx a translation [m] and a rotation vector [rad] of the tool about
///                                its centre of mass, both in the device's frame
struct PenaltyContact {
  double stiffness_N_per_m = 0.0;   ///< k
  double depth_m = 0.0;             ///< δ, positive
  glm::dvec3 depth_per_m{0.0};      ///< of a translation; −n if n separates
  glm::dvec3 depth_per_rad_m{0.0};  ///< of a rotation [m/rad]
  double damping_N_s_per_m = 0.0;   ///< along ∇δ, during contact
  /// Friction: a damper perpendicular to `n` at a point of the tool, during contact.
  double friction_N_s_per_m = 0.0;
  glm::dvec3 n{0.0, 0.0, 1.0};
  glm::dvec3 arm_m{0.0};  ///< of the point, from the centre of mass
};

/// Simulates a body of mass m and inertia I (the same about every axis) between the device and the contacts.
///
/// Springs and dampers couple the body to the pose of the device:
///
///   F_c = k_t·(p_d − p) + b_t·(v_d − v)      T_c = k_r·φ + b_r·(ω_d − ω)
///
/// φ is the rotation vector [rad] from the tool's orientation to the device's. The contacts exert the normal forces
/// −(k·δ + b·δ̇)·∇δ and the friction forces −b_f·v_t, with v_t the component of their point's velocity perpendicular to
/// n. One step solves
///
///   (M/h + h·K + B)·V⁺ = M·V/h + Q
///
/// for the twist V⁺ at its end. Q is the generalised force at the current pose; K and B are the sums of the springs'
/// and dampers' matrices, which for a contact are k·∇δ∇δᵀ, b·∇δ∇δᵀ and that of its friction. This is backward Euler,
/// linearised once. K and B are positive semi-definite, therefore a step never adds energy to a linear problem, for any
/// stiffness of the contacts and any length of the step. Contacts that would pull are removed and the step is solved
/// again, until none of the remaining ones pulls: in at most n + 1 passes over n contacts, usually in one or two.
///
/// The hand feels the springs and dampers of the coupling: the rendered stiffness never exceeds k_t, k_r.
///
/// Units and frame: SI, in the device's frame. The centre of mass lies at `centre_in_tool_m` from the
/// device's tip, in the frame that turns with the device.
///
/// Errors: the constructor throws std::invalid_argument, naming the field, for a mass, inertia or
/// stiffness that is not positive or a damping that is negative.
///
/// Real-time: `reset` and `step` do not allocate, lock or throw.
///
/// Sources: virtual coupling [Colgate 1995]; implicit integration of the tool [Otaduy 2006].
class CoupledTool final {
 public:
  struct Properties {
    double mass_kg = 0.05;
    double inertia_kg_m2 = 2e-5;
    double stiffness_N_per_m = 2000.0;
    double damping_N_s_per_m = 2.0;
    double angular_stiffness_N_m_per_rad = 2.0;
    double angular_damping_N_m_s_per_rad = 0.002;
    glm::dvec3 centre_in_tool_m{0.0};
  };

  explicit CoupledTool(const Properties& properties);

  /// Sets the tool to the device's pose and velocity.
  void reset(const ProbeState& device) noexcept;

  /// The pose of the tool, for which the next step's contacts must be found.
  const ToolPose& pose() const noexcept { return pose_; }
  /// The velocity of the tool at a point with this offset from its centre of mass.
  glm::dvec3 velocity_m_per_s(const glm::dvec3& arm_m) const noexcept;

  /// Advances the tool by `dt_s` and returns the coupling's wrench on the hand, about the device's tip. Only the first
  /// `kMaximumContacts` contacts are used; if there are more, pass the deepest.
  Wrench step(const ProbeState& device, std::span<const PenaltyContact> contacts,
              double dt_s) noexcept;

  static constexpr std::size_t kMaximumContacts = 64;

 private:
  glm::dvec3 arm_m(const ProbeState& device) const noexcept;

  Properties properties_{};
  ToolPose pose_{};
  glm::dvec3 velocity_m_per_s_{0.0};
  glm::dvec3 angular_velocity_rad_per_s_{0.0};
};

}  // namespace asperity
