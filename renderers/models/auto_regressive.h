// Declares the autoregressive model: a flat plate whose friction varies along the path of the hand.

#pragma once

#include <span>
#include <vector>

#include "renderers/force/force_model.h"
#include "renderers/recordings/texture_recording.h"

namespace asperity {

/// Renders texture as a friction coefficient that varies along the path of the hand [Pai 2001].
///
///   w   = max(0, z_s − p_z),  F_n = k·w                  penetration of the flat plate [m], normal force [N]
///   m_j = Σ_{k=1..4} a_k·m_{j−k} + g·ξ_j                 at the lengths ℓ = j·λ_n of the path (PathClock)
///   μ_e = clamp(μ + G·H(m(ℓ)), 0, max(2, μ))             the effective coefficient of friction
///   F   = F_n·n − (μ_e − μ)·F_n·t̂ − D                    t̂ = v_t/√(|v_t|² + v₀²)
///
/// D is the drag of the shared friction with the Material's μ (force/friction.h); with the law `rounded` it is μ·F_n·t̂, and
/// the force along the surface is exactly −μ_e·F_n·t̂. With the laws that build up over a distance, a decrease of
/// μ_e can push the hand by up to μ·F_n directly after a reversal.
///
/// a_k = `coefficient_k`; g such that the m_j have the standard deviation `friction_sd`; λ_n = `noise_length_m` on the
/// texture, so it includes `motion_scale`; v₀ = `friction_speed_m_per_s`; ξ_j is the standard normal number that belongs
/// to the seed and to j. m(ℓ), linear between the m_j, and its low-pass H: RecursiveNoise. G is 1 for a moving hand and
/// fades to 0 where it stops (MotionGate): m holds there, and a hand at rest feels the plate with its friction.
///
/// Of order 2, with poles of radius r and a resonance near waves of λ₀: a₁ = 2·r·cos θ, a₂ = −r², θ = 2π·λ_n/λ₀. The
/// defaults are r 0.9, λ₀ 1 mm, λ_n 0.1 mm and a standard deviation of 0.3 times the Material's default friction (own
/// choices; no source gives numbers). The one-sided spectrum at a speed v, with ω = 2π·f·λ_n/v and T = λ_n/v:
///
///   2·g²·T/|1 − Σ a_k·exp(−i·ω·k)|² · sinc⁴(f·T),   of order 2 with var m = g²·(1 − a₂)/((1 + a₂)·((1 − a₂)² − a₁²))
///
/// μ_e is never negative, which clips the variation where it exceeds μ and raises the mean by s·φ(μ/s) − μ·Φ(−μ/s), s the
/// standard deviation of H(m): by nothing at s = 0.06 and μ = 0.2, by 0.4·s at μ = 0.
///
/// ℓ is the length of the path, not the place: two strokes over a place differ.
///
/// Values for a texture sample: autoregression_of_relief.
///
/// Errors: std::invalid_argument for coefficients of a process that is not stationary, one with a root |z| ≥ 1.
///
/// [Pai 2001] Pai, van den Doel, James, Lang, Lloyd, Richmond, Yau: Scanning physical interaction behavior of 3D objects.
ForceModel auto_regressive_model();

/// The parameters with which `auto_regressive` has the statistics of given variations of friction: Burg's estimate of
/// the coefficients of order 2, with every root moved to 0.999 of its radius so that a pure wave remains a stationary
/// process, and the standard deviation. The segments, each less its mean, have one sample per `step_m`; segments of
/// fewer than 8 samples are left out. Empty without a segment.
ParameterValues autoregression_of_profiles(std::span<const std::vector<double>> segments,
                                           double step_m);

/// The same for a relief: along up to 64 of its rows, the ratio of the force along x to the normal force of a point that slides
/// without friction. It is the slope: the differences of heights that are `step_m` apart, divided by it. `step_m`
/// is λ_n = 0.1 mm, or the pitch of a coarser field.
ParameterValues autoregression_of_relief(const HeightField& field);

/// The same for a recorded force along the motion: the ratio of each sample's force to its normal force, less a trend
/// in each stroke, as means over steps of the path. A step is λ_n = 0.1 mm, or that of the samples of the fastest
/// stroke where it is longer. Samples without a normal force are left out; a step without a sample ends a segment.
ParameterValues autoregression_of_recording(const TextureRecording& recording);

}  // namespace asperity
