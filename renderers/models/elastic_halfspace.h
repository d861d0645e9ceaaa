// Declares the models of a rigid tip on a soft textured surface: a half-space, and an elastic foundation.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a rigid tip on a soft textured body: a linear half-space that deforms around the contact and relaxes.
///
/// Symbols: h(x, y) relief [m], times `height_scale`; h_A(x, y) profile of the tip [m], 0 at its lowest point; z height of the
/// tip over the plane [m]; E∞ `youngs_modulus_Pa`, ν `poisson_ratio`, E* = E∞/(1 − ν²) [Pa]; p pressure [Pa]; u displacement of
/// the surface into the body [m].
///
///   u(x) = (1/πE*)·∫ p(x')/|x − x'| dA'               [Boussinesq 1885, Johnson 1985]
///   g = u − w ≥ 0,   p ≥ 0,   p·g = 0                 w = h − h_A − z, the overlap of the undeformed bodies
///   F = ∫ p·(−∂h/∂x, −∂h/∂y, 1) dA − D                T = ∫ r × p·(−∂h/∂x, −∂h/∂y, 1) dA, about the tip
///
/// in 32 × 32 cells around the tip (half_space_contact.h), D the drag of the friction (force/friction.h). F and T are the
/// gradient of the elastic energy. The body is a standard linear solid: E(t) = E∞·(1 + (ρ − 1)·e^(−t/τ)), ρ `relaxation_ratio`,
/// τ `relaxation_time_s`; h is then the relief less the dent that earlier loads leave (relaxing_half_space.h).
///
/// Closed forms, on a plane: ball F = (4/3)·E*·√R·δ^(3/2), contact radius a = √(Rδ) [Hertz 1882]; flat end F = 2E*·R·δ; both have
/// dF/dδ = 2E*·a, and directly after a change of depth ρ times this.
///
/// Limits: small strains (a ≤ 0.3 R), a body that is much thicker and wider than the contact, slopes much smaller than 1, no
/// adhesion, no mass. The contact is frictionless: tangential displacements, which for ν < ½ are coupled to the pressure, are
/// left out. Texture finer than two cells is lost. The Material's stiffness only determines walls.
///
/// Time of a tick: up to 0.6 ms, so that a servo loop keeps its period up to 1 kHz (maximum_rate_Hz of the declaration).
///
/// ForceRenderer::limits counts ticks: `contact`; `unfinished` (the conditions were violated by more than 1/100 of the overlap
/// after the iterations of the tick), `cell_border` (the contact reached the border of the cells), `large_strain` (a > 0.3 R).
ForceModel elastic_halfspace_model();

}  // namespace asperity
