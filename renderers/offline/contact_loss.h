// Declares the proportion of a stroke in which a pressed mass loses contact with a surface.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// A stroke along +x through the patch's centre, by a mass under a constant force.
struct PressedMass {
  double mass_kg = 0.05;
  double damping_N_s_per_m = 0.0;  ///< normal to the surface
  double force_N = 1.0;
  double speed_m_per_s = 0.06;
  double rate_Hz = 1000.0;  ///< of the loop that renders the surface
  double duration_s = 1.0;  ///< of the evaluated part; half as long a beginning is dropped
};

/// The proportion of the stroke without contact:
///
///   m·z̈ = F_z − P − b·ż,    x = v·t
///
/// F_z is the normal force of the model's own renderer, at the rate of its loop and held constant between ticks. The
/// patch's border is removed and its texture repeats. Contact is lost where the surface descends faster than the mass
/// follows: on a stiff sinusoid of amplitude A, if A·√((m·ω²)² + (b·ω)²) > P with ω = 2πv/λ; a soft one (k well below
/// m·ω²) yields instead.
///
/// Limits: motion normal to the surface only; the stroke does not yield to the texture. A hand adds mass and damping to
/// the given values.
///
/// Errors: std::invalid_argument for a mass, force, speed, rate or duration that is not positive, and in the cases of
/// the model.
double share_out_of_contact(const ForceModel& model, const RendererInputs& inputs,
                            const PressedMass& stroke);

}  // namespace asperity
