// A flat plate with white noise on it.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Texture as random force, unrelated to place.
///
///   w   = max(0, z_s − p_z)                            penetration of the flat plate [m]
///   F_n = max(0, k·w + a·(m + σ·ξ_j))                  normal force, in contact only [N]
///   a   = 1 where the tangential speed |v_t| ≥ v_min, else 0
///   j   = ⌊(t − t₀)·f + ½⌋                             noise step, t₀ the first sample's time [s]
///   F   = F_n·n − μ·F_n·v_t/√(v_t² + v₀²)
///
/// m = `noise_mean_N`, σ = `noise_sd_N` (a standard deviation, not a variance), f =
/// `noise_rate_Hz`, v_min = `velocity_threshold_m_per_s`; ξ_j is the standard normal number that
/// belongs to the seed and to j, held in between. The noise therefore has a clock of its own and is
/// the same force over time at any servo rate. Sampled at f, its one-sided spectrum is flat, 2σ²/f
/// up to f/2. The ½ keeps a servo that ticks on the steps from straddling them when it is late.
///
/// The normal force never pulls: where the noise exceeds k·w, the probe is free. That clips the
/// noise of light touches (visibly for σ > k·w/3).
///
/// A sample of texture suggests σ = k·RMS of its heights and m = 0: the mean of its heights, which
/// the source would use, is zero once the plane of the surface is taken out.
///
/// [Siira 1996] Siira, Pai: Haptic texturing, a stochastic approach.
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel stochastic_model();

}  // namespace asperity
