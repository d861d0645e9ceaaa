// Declares the recorded model: a flat plate with the vibration of a recorded texture.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a texture from the spectra of its recording at two speeds or more [Vasudevan 2006].
///
///   w    = max(0, z_s − p_z),  F_n = k·w                  penetration of the flat plate [m], normal force [N]
///   A_k(v)                                                amplitude of line k at the speed v (RecordedSpectra)
///   a(u) = Σ_k A_k(v)·cos(2π·k·Δ·u + φ_k)                 Δ the spacing of the lines, φ_k drawn from the seed
///   F_t  = g·G·s·(F_n/1 N)^β·H(a(u))                      s = s(w/0.1 mm) (contact_fade.h)
///   F    = F_n·n + F_t·t̂ − D                              `axis = motion`;  t̂ = v_t/√(|v_t|² + v₀²)
///   F    = max(0, F_n + F_t)·n − D                        `axis = normal`
///
/// `axis_of_spectrum = spatial` (default): the lines are waves per metre and u is the length of the path (PathClock),
/// on the texture, so it includes `motion_scale`. A wave of 1 mm is v/1 mm in hertz at every speed. `temporal`: the
/// lines are in hertz and u is the time for which the hand has moved; this is the interpolation of the source, in which
/// a speed between two recorded ones moves energy between lines and not the frequency of a wave.
///
/// Logarithms of amplitudes are linear in log v between two recorded speeds, and held beyond them. The vibration is
/// computed in advance for 8 speeds between each pair, one period 1/Δ of the sum each, and mixed linearly between two of
/// them: 0.4 % from the law for amplitudes that differ by a factor of 4 between the recorded speeds, 4 % for a factor
/// of 100. v is |v_t| on the texture after a low-pass of 10 ms. All waves keep their phase when the speed changes.
///
/// g = `gain`; β = `force_exponent` (default 1, own choice); v₀ = `friction_speed_m_per_s`; D the drag of the friction
/// (force/friction.h), under `normal` of the rendered normal force. H is the ServoLowPass, by which nothing aliases, G
/// the MotionGate: a hand at rest feels the plate; and s lets contact begin without a step with any β.
///
/// Artefacts: the phases of the recording are lost, so that a sharp ridge becomes noise of its spectrum; the vibration
/// repeats after the shortest recorded stroke; two strokes over a place differ.
///
/// The asset `recording` is a table of strokes (texture_recording.h). Errors: std::invalid_argument for a table that
/// cannot be read, and for one with a single speed unless `single_speed` is `accepted`: it does not show how the
/// texture changes with the speed.
///
/// [Vasudevan 2006] Vasudevan, Manivannan: Recordable haptic textures.
ForceModel recorded_model();

/// The role of the asset of `recorded`.
inline constexpr const char* kRecordingRole = "recording";

}  // namespace asperity
