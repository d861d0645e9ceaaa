// Declares the stochastic model: a flat plate with white noise.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders texture as a random force that is independent of position.
///
///   w   = max(0, z_s − p_z)                            penetration of the flat plate [m]
///   F_n = max(0, k·w + s·a·(m + σ·ξ_j))                normal force, in contact only [N]
///   s   = s(w/0.1 mm)                                  contact begins without a step (contact_fade.h); 1 from 0.1 mm on
///   a   = 1 where the tangential speed |v_t| ≥ v_min, else 0
///   j   = ⌊(t − t₀)·f + ½⌋                             noise step of `index = time` (default), t₀ the first sample's time [s]
///   F   = F_n·n − D                D the drag of the friction (force/friction.h)
///
/// m = `noise_mean_N`, σ = `noise_sd_N` (a standard deviation, not a variance), f = `noise_rate_Hz`, v_min =
/// `velocity_threshold_m_per_s`; ξ_j is the standard normal number that belongs to the seed and to j, held constant
/// between the steps. The noise thus has its own rate and is the same force over time at any servo rate. Sampled at f,
/// its one-sided spectrum is flat, 2σ²/f up to f/2. The ½ places the ticks of a servo that runs at the steps' rate in
/// the middle of the steps, so that lateness does not move a tick across a step.
///
/// A servo loop slower than f takes one new value in each tick: the noise clock is held at the servo's rate f_s, and the
/// spectrum is 2σ²/f_s up to f_s/2. In a fixed band it is then stronger by √(f/f_s): do not compare such rates.
///
/// `index = distance` counts the steps along the path of the hand, at any speed and without a threshold:
///
///   j   = ⌊ℓ/λ_n + ½⌋                                  ℓ the length of the path (PathClock) [m]
///   F_n = max(0, k·w + s·H(m + σ·ξ_j))                 0 instead of m + σ·ξ_j for j = 0; H the ServoLowPass
///
/// λ_n = `noise_length_m` (own choice; no source gives one), on the texture, so it includes `motion_scale`. At a speed v
/// the one-sided spectrum is 2σ²λ_n/v·sinc²(f·λ_n/v), −3.9 dB at v/2λ_n: the faster, the wider and the weaker in each hertz.
/// A tick contains up to ServoLowPass::kStepsPerTick steps; what is above 0.4 of the servo rate is filtered out. A hand at
/// rest feels the constant force of the step at which it stopped, and the plate where it touched down without moving; the
/// path does not grow by the position noise of a device of `device_step_m`.
///
/// The normal force never pulls: where the noise exceeds k·w, the force is zero. This clips the noise of light touches and
/// raises their mean by σ·φ(F/σ) − F·Φ(−F/σ) with F = k·w + m, from 0.1 mm of depth on: 35 mN for F 60 mN and σ 150 mN.
///
/// The values suggested for a texture sample are σ = k·RMS of its heights and m = 0: the mean of its heights, which the
/// source would use, is zero once the plane of the surface has been subtracted.
///
/// [Siira 1996] Siira, Pai: Haptic texturing, a stochastic approach.
/// [Wu 2009] Wu, Song, Zou: A novel haptic texture display based on image processing.
ForceModel stochastic_model();

}  // namespace asperity
