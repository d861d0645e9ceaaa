// Declares the stochastic model: a flat plate with white noise.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders texture as a random force that is independent of position.
///
///   w   = max(0, z_s − p_z)                            penetration of the flat plate [m]
///   F_n = max(0, k·w + a·(m + σ·ξ_j))                  normal force, in contact only [N]
///   a   = 1 where the tangential speed |v_t| ≥ v_min, else 0
///   j   = ⌊(t − t₀)·f + ½⌋                             noise step, t₀ the first sample's time [s]
///   F   = F_n·n − μ·F_n·v_t/√(v_t² + v₀²)
///
/// m = `noise_mean_N`, σ = `noise_sd_N` (a standard deviation, not a variance), f = `noise_rate_Hz`, v_min =
/// `velocity_threshold_m_per_s`; ξ_j is the standard normal number that belongs to the seed and to j, held constant
/// between the steps. The noise thus has its own rate and is the same force over time at any servo rate. Sampled at f,
/// its one-sided spectrum is flat, 2σ²/f up to f/2. The ½ places the ticks of a servo that runs at the steps' rate in
/// the middle of the steps, so that lateness does not move a tick across a step.
///
/// The normal force never pulls: where the noise exceeds k·w, the force is zero. This clips the noise at light touch
/// (noticeably for σ > k·w/3).
///
/// The values suggested for a texture sample are σ = k·RMS of its heights and m = 0: the mean of its heights, which the
/// source would use, is zero once the plane of the surface has been subtracted.
///
/// [Siira 1996] Siira, Pai: Haptic texturing, a stochastic approach.
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel stochastic_model();

}  // namespace asperity
