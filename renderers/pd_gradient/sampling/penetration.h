// How deep one textured surface is in another along n, how that changes as A moves, and the force.

#pragma once

#include <variant>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/wrench.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"

namespace asperity {

/// δ = max over D of (h_B − h_A), its gradient by central differences [Otaduy 2004].
///
/// The step is a length, because it is a filter and no numerical detail: of a grating of wavelength
/// λ it keeps sin(2π·step/λ)/(2π·step/λ) of the tangential force, 90 % at λ/8. It must not change
/// with the grid.
struct HardMaximum {
  double step_m = 0.0;
};

/// The mean of all depths, each weighing by w = exp((h_B − h_A)/τ), ⟨·⟩ for means that weigh so:
///
///   δ = ∫_D w·(h_B − h_A) dA / ∫_D w dA      ∇δ = ⟨(1 + (h_B − h_A − δ)/τ)·∇(h_B − h_A)⟩
///
/// A smoother force, and another one: heights within some τ of the highest push together. A place that is more
/// than τ less deep than δ has a negative weight in ∇δ: where it gets deeper it counts more, and it is below
/// the mean. δ is never
/// above the hard maximum, so that nothing is felt at once where a contact begins. It is equal where a
/// plate lies flat on another one, whatever their size; a ball on a plate is felt τ later, whatever its
/// radius. What of D lies some τ lower does not matter, and so does no window's width.
struct SmoothMaximum {
  double tau_m = 0.0;
};

using MaximumLaw = std::variant<HardMaximum, SmoothMaximum>;

/// Throws std::invalid_argument, naming the field, for a step or τ that is not positive and finite.
void require_sound(const MaximumLaw& law);

/// How far A is moved either way for the central differences, from the declared step: along the window
/// by the step, and turned about u, v and n so that the middle of the window's border moves by the step.
/// A tilt of a quarter of that would let two places that are nearly as deep as each other decide the
/// torque by what samples miss of their peaks: levers are then off by some 5.5 % at 64 samples over eight
/// waves, with this one by 4 %.
struct DifferenceSteps {
  double along_m = 0.0;   ///< along u and v
  double tilt_rad = 0.0;  ///< about u and v: 2·along_m / width
  double turn_rad = 0.0;  ///< about n: the same
};

DifferenceSteps difference_steps(const SamplingGrid& grid, double step_m) noexcept;

/// The directional penetration depth of a contact, and its gradient over the motion of A.
///
///   δ = max over (u, v) in D of ( h_B(u, v) − h_A(u, v) )
///
/// with heights along n from the frame's origin: h_B the upper surface of B, h_A the lower one of A,
/// D the samples of the window that both surfaces cover. (The source counts heights against n, and
/// has h_A − h_B.) Negative while the surfaces are apart. n and the window stay where they are while
/// A moves, and so does B.
///
/// At one interior maximum r with slopes (h_u, h_v), in the limit of small steps,
///   ∇δ = (h_u, h_v, −1; −r × (−h_u, −h_v, 1)).
struct Penetration {
  double depth_m = 0.0;
  glm::dvec2 slope{0.0};  ///< ∂δ/∂u, ∂δ/∂v
  glm::dvec3 lever_m{0.0};  ///< ∂δ/∂θu, ∂δ/∂θv, ∂δ/∂θn, about axes through the origin, per radian
  glm::dvec3 deepest_m{0.0};  ///< where on A, in the frame
  int covered = 0;            ///< samples in D
  /// Samples where more than one sheet of A, or of B, looks the same way: no height field along n.
  int folded = 0;
  /// The deepest sample lies at the border of D, where the surfaces may go on: δ is a lower bound.
  bool at_border = false;
  /// That border is the window's: one of its outermost samples is the deepest.
  bool at_window = false;
};

/// The same depth at the same place, slopes that are less by a part; what moving along n does stays.
Penetration flattened(double part, const Penetration& found) noexcept;

/// As if the heights were pressed together along n until the depth is `depth_m`, a part of what it is:
/// slopes become less by that part, the deepest place and what moving along n does stay.
Penetration pressed_to(double depth_m, const Penetration& found) noexcept;

/// The force of the energy U = ½·k·δ² on A, in the world, its torque about the frame's origin:
///
///   (F; T) = −k·δ·∇δ        zero while δ ≤ 0;  B feels the opposite
///
/// Exchanging A and B (and n, v with −n, −v) reverses F exactly and T but for δ·n × F: rotations are
/// A's, so the force acts at A's deepest point and not at B's, δ above it.
Wrench contact_wrench(const Penetration& penetration, const ContactFrame& frame,
                      double stiffness_N_per_m) noexcept;

}  // namespace asperity
