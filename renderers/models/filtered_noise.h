// Declares the filtered noise model: a flat plate with coloured noise along the direction of motion.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders texture as a random force along the motion of the hand, coloured by a recursive filter on the hand's path
/// [Fritz 1996].
///
///   w   = max(0, z_s − p_z),  F_n = k·w                  penetration of the flat plate [m], normal force [N]
///   y_j = a₁·y_{j−1} + a₂·y_{j−2} + (σ/G)·ξ_j            at the lengths ℓ = j·λ_n of the path (PathClock); y_0 and y_{−1} drawn
///   F   = F_n·n + s·H(y(ℓ))·t̂ − D                        t̂ = v_t/√(|v_t|² + v₀²), s = min(1, F_n/F_ref)
///
/// y(ℓ) and its low-pass H: RecursiveNoise. D is the drag of the friction (force/friction.h); σ = `noise_sd_N`,
/// λ_n = `noise_length_m` on the texture, so it includes `motion_scale`; F_ref = `reference_force_N`, v₀ =
/// `friction_speed_m_per_s`; ξ_j is the standard normal number that belongs to the seed and to j. λ_n and F_ref are own
/// choices; no source gives them.
///
/// The filter has the pole radius r = `pole_radius`:
///
///   one pole   λ₀ = 0: a₁ = r, a₂ = 0                       a low-pass
///   two poles  λ₀ = `peak_wavelength_m`: a₁ = 2·r·cos θ, a₂ = −r², θ = 2π·λ_n/λ₀    a resonance near waves of λ₀
///
/// G² = Σ h_i² is the filter's own power gain, with which the y_j have the standard deviation σ:
///
///   G² = (1 − a₂)/((1 + a₂)·((1 − a₂)² − a₁²)),   1/(1 − r²) of one pole.
///
/// With one pole the autocorrelation of the y_j is r^k at the lag k, and their power is halved (r ≥ 0.172) at
///
///   f_c = v/(2π·λ_n)·acos((4r − 1 − r²)/(2r)).
///
/// Interpolation multiplies the spectrum by sinc⁴(f·λ_n/v), −1.8 dB at v/4λ_n, and the variance of one pole by (2 + r)/3. What
/// is above 0.4 of the servo rate is filtered out. A hand at rest feels the plate: t̂ is 0, and the path does not grow by the
/// position noise of a device of `device_step_m`. y(0) = 0, so that a hand that touches down feels the plate whatever the
/// readings of its velocity; from ℓ = λ_n on the y_j are stationary, because y_0 and y_{−1} are drawn with their variance
/// σ² and their correlation a₁/(1 − a₂).
///
/// The path is not the place: two strokes over a place differ. A hand that moves by more than 64 λ_n in a tick skips noise.
///
/// Errors: std::invalid_argument for a peak wavelength of less than 2·λ_n.
///
/// [Fritz 1996] Fritz, Barner: Stochastic models for haptic texture.
ForceModel filtered_noise_model();

}  // namespace asperity
