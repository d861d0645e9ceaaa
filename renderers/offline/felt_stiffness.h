// How stiff a stimulus is to the hand that presses on it, from the forces of its model.

#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "renderers/force/force_model.h"

namespace asperity {

/// Where it is looked for, and how finely. What is left out follows from the stimulus: the part of the texture that
/// can be met on the patch, once where it repeats; steps of 1/64 of its pitch on the device, 1/256 of the wavelength
/// of a model that has one as a parameter, 1 µm otherwise.
struct StiffnessSearch {
  double force_limit_N = 5.0;  ///< the normal force at which it is asked for
  /// The rectangle about the patch's centre, on the device; 0 along an axis is a line.
  std::optional<glm::dvec2> extent_m{};
  std::optional<double> step_m{};  ///< in x and y, to either side of a place
};

struct FeltStiffness {
  double stiffness_N_per_m = 0.0;
  /// The normal force there: the limit, or just less than the greatest force where the model gives less.
  double force_N = 0.0;
};

/// The largest eigenvalue of the symmetric part of −∂F/∂x [N/m], x the resting tip in all three directions, at the
/// stiffest place found: there a spring along one direction is as stiff, which is K of b > K·T/2 + |B| [Colgate 1997].
/// For a force −k·δ·∇δ (pd_gradient, height_map at a lateral gain of 1) it is that of k(∇δ∇δᵀ + δ∇∇δ), with kδ the
/// force. What F turns without being a gradient of anything (the other part of ∂F/∂x) is left out.
///
/// F is that of the model's own renderer, `reset` and asked once at each place, at rest and at time 0: there is no friction,
/// and noise in time is the same everywhere. Its derivatives are central differences over ±`step_m`
/// across and 1/2000 of the depth along z. Each place is as deep as its normal force first reaches the limit, or where
/// it never does within 0.1 m (twice the depth at which a plain plate does, where that is more) nearly (1/1000 less) the
/// greatest that it has there, just above that.
///
/// Looked at are 128 by 128 places, one in each cell of a grid, drawn from a fixed seed, and those where the height field
/// is bent or inclined most; from the 16 stiffest uphill to the stiffest near them. The patch's border is taken away.
///
/// A jump of the force is no stiffness: a difference that grows as its step is made smaller is left out. Where a
/// model's force jumps (at contact, height_map's literal law at its depth limit), nothing is said of it. Nothing is
/// returned where no place has a stiffness: everywhere the force jumps, or does not grow.
///
/// Limits: of a model that moves by itself (pd_gradient's virtual coupling) it is the force right after `reset`, which is
/// not what a hand feels.
///
/// Errors: std::invalid_argument for a limit or a step that is not positive, and what the model refuses.
std::optional<FeltStiffness> felt_stiffness(const ForceModel& model, const RendererInputs& inputs,
                                            const StiffnessSearch& search);

}  // namespace asperity
