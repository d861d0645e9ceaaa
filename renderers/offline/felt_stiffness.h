// Declares the stiffness of a stimulus to the hand that presses on it, computed from its model's forces.

#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "renderers/force/force_model.h"

namespace asperity {

/// The region and the resolution of the search. Missing values follow from the stimulus: the part of the texture that
/// can be reached on the patch, once if it repeats; steps of 1/64 of its pitch on the device, 1/256 of the wavelength
/// of a model that has one as a parameter, 1 µm otherwise.
struct StiffnessSearch {
  double force_limit_N = 5.0;  ///< the normal force at which the stiffness is evaluated
  /// The rectangle about the patch's centre, on the device; 0 along an axis makes it a line.
  std::optional<glm::dvec2> extent_m{};
  std::optional<double> step_m{};  ///< in x and y, to either side of a place
};

struct FeltStiffness {
  double stiffness_N_per_m = 0.0;
  /// The normal force there: the limit, or slightly less than the greatest force if the model does not reach the limit.
  double force_N = 0.0;
};

/// The largest eigenvalue of the symmetric part of −∂F/∂x [N/m], with x the resting tip in all three directions, at the
/// stiffest place found. It is the stiffness of an equivalent spring along one direction, the K of b > K·T/2 + |B|
/// [Colgate 1997]. For a force −k·δ·∇δ (pd_gradient, height_map at a lateral gain of 1) it is that of k(∇δ∇δᵀ + δ∇∇δ),
/// with kδ the force. The rotational part of F, which is not a gradient (the other part of ∂F/∂x), is left out.
///
/// F is that of the model's own renderer, which is `reset` and evaluated once at each place, at rest and at time 0:
/// there is no friction, and noise in time is the same everywhere. Its derivatives are central differences over
/// ±`step_m` in x and y and over 1/2000 of the depth along z. The depth at each place is the smallest at which the
/// normal force reaches the limit. If it does not reach the limit within 0.1 m (or twice the depth on a plain plate, if
/// that is more), it is slightly smaller than the depth of the greatest force there: the force is 1/1000 less.
///
/// The search evaluates 128 by 128 places, one in each cell of a grid, drawn with a fixed seed, and the samples of the
/// height field with the greatest curvature or inclination; from the 16 stiffest it climbs to the local maximum. The
/// patch's border is removed.
///
/// A jump of the force is not a stiffness: a difference that grows as its step decreases is left out. The result does
/// not cover jumps of a model's force (of height_map's literal law at contact and at its depth limit), nor the first
/// 0.1 mm of a contact, where some textures fade in (contact_fade.h). nullopt if no place
/// has a stiffness: the force jumps everywhere, or does not grow.
///
/// A model with its own law of indentation (indentation_law.h) has that of the surface without texture, in closed form.
///
/// Limits: for a model with internal motion (pd_gradient's virtual coupling) the result is that of the force directly
/// after `reset`, which differs from what a hand feels.
///
/// Errors: std::invalid_argument for a limit or a step that is not positive, and in the cases of the model.
std::optional<FeltStiffness> felt_stiffness(const ForceModel& model, const RendererInputs& inputs,
                                            const StiffnessSearch& search);

}  // namespace asperity
