// Declares the directional penetration depth of two textured surfaces, its gradient and its force.

#pragma once

#include <variant>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "device/wrench.h"
#include "renderers/pd_gradient/geometry/contact_geometry.h"

namespace asperity {

/// δ = max over D of (h_B − h_A), its gradient by central differences [Otaduy 2004].
///
/// The step is a length, because it acts as a filter and is not a numerical detail: for a grating of wavelength λ it
/// keeps sin(2π·step/λ)/(2π·step/λ) of the tangential force, 90 % at λ/8. It must not depend on the grid.
struct HardMaximum {
  double step_m = 0.0;

  bool operator==(const HardMaximum&) const = default;
};

/// The mean of all depths, with the weights w = exp((h_B − h_A)/τ); ⟨·⟩ denotes means with these weights:
///
///   δ = ∫_D w·(h_B − h_A) dA / ∫_D w dA      ∇δ = ⟨(1 + (h_B − h_A − δ)/τ)·∇(h_B − h_A)⟩
///
/// It gives a smoother and different force: heights within approximately τ of the highest contribute together. A place
/// that is more than τ less deep than δ has a negative weight in ∇δ: where its depth increases its weight increases,
/// and it lies below the mean. δ is never above the hard maximum, so that the force does not jump at the beginning of a
/// contact. It equals the hard maximum where a plate lies flat on another one, for any size; a ball on a plate is
/// rendered τ later, for any radius. Parts of D that lie several τ lower have no influence, nor has the width of the
/// window.
struct SmoothMaximum {
  double tau_m = 0.0;

  bool operator==(const SmoothMaximum&) const = default;
};

using MaximumLaw = std::variant<HardMaximum, SmoothMaximum>;

/// Throws std::invalid_argument, naming the field, for a step or τ that is not positive and finite.
void require_sound(const MaximumLaw& law);

/// The displacements of A in both directions for the central differences, from the declared step: along the window by
/// the step, and about u, v and n by an angle that moves the middle of the window's border by the step. With a quarter
/// of this tilt, the torque of two places of nearly equal depth would depend on the errors of the sampled peaks: levers
/// would be off by some 5.5 % at 64 samples over eight waves, instead of 4 % with this tilt. On many crests of nearly equal
/// depth a tilt averages the levers of those that it makes the deepest, so that the torque depends on the width of the window.
struct DifferenceSteps {
  double along_m = 0.0;   ///< along u and v
  double tilt_rad = 0.0;  ///< about u and v: 2·along_m / width
  double turn_rad = 0.0;  ///< about n: the same
};

DifferenceSteps difference_steps(const SamplingGrid& grid, double step_m) noexcept;

/// The directional penetration depth of a contact, and its gradient with respect to the motion of A.
///
///   δ = max over (u, v) in D of ( h_B(u, v) − h_A(u, v) )
///
/// Heights are along n from the frame's origin: h_B of the upper surface of B, h_A of the lower one of A; D is the set
/// of samples of the window that both surfaces cover. (The source measures heights against n and has h_A − h_B.) The
/// depth is negative while the surfaces are apart. n, the window and B are fixed while A moves.
///
/// At one interior maximum r with slopes (h_u, h_v), in the limit of small steps,
///   ∇δ = (h_u, h_v, −1; −r × (−h_u, −h_v, 1)).
struct Penetration {
  double depth_m = 0.0;
  glm::dvec2 slope{0.0};  ///< ∂δ/∂u, ∂δ/∂v
  glm::dvec3 lever_m{0.0};  ///< ∂δ/∂θu, ∂δ/∂θv, ∂δ/∂θn, about axes through the origin, per radian
  glm::dvec3 deepest_m{0.0};  ///< on A, in the frame
  int covered = 0;            ///< samples in D
  /// Samples at which several sheets of A, or of B, face the same way: not a height field along n.
  int folded = 0;
  /// The deepest sample lies at the border of D, where the surfaces may continue: δ is a lower bound.
  bool at_border = false;
  /// This border is the window's: one of its outermost samples is the deepest.
  bool at_window = false;
  /// Hard maximum: how far apart the deepest places under opposite tilts lie, at least (spread_of). 0 if there is one.
  double spread_m = 0.0;
};

/// (δ(θ) + δ(−θ) − 2δ)/θ, for a tilt about u or v by θ and by −θ. To first order in θ a depth changes by θ times the
/// distance of its place from the axis, so that each of the two depths has increased by no more than θ times the
/// distance at which its deepest place now lies from that of δ: the result is at most the distance between the two
/// places across the axis, and about λ for two equal crests that are λ apart.
double spread_of(double here_m, double forth_m, double back_m, double tilt_rad) noexcept;

/// The same depth and position with slopes reduced to the fraction `part`; the derivative along n is unchanged.
Penetration flattened(double part, const Penetration& found) noexcept;

/// The result for heights that are compressed along n until the depth is `depth_m`, a fraction of the original: slopes
/// are reduced by this fraction, the deepest position and the derivative along n are unchanged.
Penetration pressed_to(double depth_m, const Penetration& found) noexcept;

/// The force of the energy U = ½·k·δ² on A, in the world; its torque is about the frame's origin:
///
///   (F; T) = −k·δ·∇δ        zero while δ ≤ 0;  B feels the opposite
///
/// Exchanging A and B (and n, v with −n, −v) reverses F exactly, and T except for δ·n × F: rotations are those of A, so
/// the force acts at A's deepest point and not at B's, which is δ above it.
Wrench contact_wrench(const Penetration& penetration, const ContactFrame& frame,
                      double stiffness_N_per_m) noexcept;

}  // namespace asperity
