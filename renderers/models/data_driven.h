// Declares the data-driven model: a flat plate with the vibration of autoregressive models over speed and force.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Renders a texture from autoregressive models of the acceleration of a tool at several speeds and normal forces
/// [Culbertson 2014].
///
///   w    = max(0, z_s − p_z),  F_n = k·w                  penetration of the flat plate [m], normal force [N]
///   v    ← low-pass of |v_t|                              twice v ← (v + λ·dt·v_in)/(1 + λ·dt), λ = 125/s
///   c, σ = VibrationMap at (v, F_n)                       renderers/vibrations/vibration_map.h
///   a_n  = Σ_j c_j·a_{n−j} + σ·ξ_n                        acceleration at 1 kHz [m/s²]; ξ_n normal, of the seed and of n
///   F_t  = g·G·s·m·y(a)                                   y: the a_n at the time of the tick (BandLimitedInterpolation)
///   F    = F_n·n + F_t·t̂ − D                              `axis = motion`;  t̂ = v_t/√(|v_t|² + v₀²)
///   F    = F_n·n + F_t·(t̂ × n) − D                        `axis = binormal`
///   F    = max(0, F_n + F_t)·n − D                        `axis = normal`
///
/// g = `gain`; m = `effective_mass_kg` (default 0.05 kg, own choice: it is unknown for a user's handle, and `device-test` measures
/// that of a device as `moving_mass_kg`); v₀ = `friction_speed_m_per_s`; D the drag of the shared friction with the Material's μ
/// (force/friction.h), under `normal` of the rendered normal force. In v_in |v_t| is the speed on the texture,
/// which includes `motion_scale`; in t̂ it is that of the hand. `binormal` is the direction of the source: across the motion, along the surface; such a force does no work on
/// the hand. `motion` is the direction of the forces that `texture-recording` records, and the default of `recorded`.
///
/// `variance = logarithmic` (default) interpolates log σ², `linear` σ² as the toolkit does, which has silent models on its axes.
/// The line spectral frequencies are interpolated, never the c_j, so that the process is stationary everywhere.
/// The process is realised as a normalised ladder [Gray 1975]: the same a_n while c and σ stay, and when they change, also from
/// one triangle to the next, its states stay and keep their energy. Past values of a as states can be amplified by
/// orders of magnitude there (measured: 5 N instead of 0.3 N at reversals on a recorded grating).
///
/// The process runs at 1 kHz whatever the servo rate: a filter that runs at another rate is another texture. Its output is
/// interpolated between its samples, and below 1 kHz limited to half the servo rate (down to 500 Hz; slower servo loops alias).
///
/// Delays: the low-pass of the speed, 2/λ = 16 ms, −3 dB at 13 Hz, −6 dB at 20 Hz; the interpolation, 12 ms (24 ms at 500 Hz),
/// which shifts the vibration in time and not relative to itself. Force acts on c and σ without a filter.
///
/// s = s(w/0.1 mm) lets contact begin without a step (contact_fade.h): the models of the lowest normal force need not be silent.
/// G is the MotionGate: a hand at rest feels the plate. In the source the models on the axes v = 0 and F_n = 0 are silent, and
/// the vibration fades towards them; a set without such models holds its slowest vibration down to rest, where G ends it.
///
/// Artefacts: two strokes over a place differ; sharp features become noise; the vibration includes the dynamics of the tool with
/// which it was recorded.
///
/// The asset `vibration_models` is a table (vibration_models.h). Errors: std::invalid_argument for a table that cannot be read
/// and, with `variance = logarithmic`, for one with a silent model.
///
/// Real-time: below 1 µs a tick at order 20; the map is searched from the triangle of the last tick.
///
/// [Gray 1975] Gray, Markel: A normalized digital filter structure.
/// [Culbertson 2014] Culbertson, Lopez Delgado, Kuchenbecker: One hundred data-driven haptic texture models.
ForceModel data_driven_model();

/// The role of the asset of `data_driven`.
inline constexpr const char* kVibrationModelsRole = "vibration_models";

}  // namespace asperity
