// Declares closed forms for the springs and dampers that a sampled loop can render.

#pragma once

#include <optional>

namespace asperity {

/// The inherent viscous damping [N s/m] that a device needs to render F = −K·x − B·ẋ passively, with a reading and a
/// force once every `period_s` (T), the force held in between and ẋ the difference of two readings:
///
///   b > K·T/2 + |B|
///
/// The condition for passivity of a device with damping b that renders H(z) is [Colgate 1997]
///
///   b > T/(2(1 − cos ωT)) · Re{(1 − e^(−jωT))·H(e^(jωT))}      for 0 ≤ ω ≤ π/T
///
/// With H(z) = K + B·(z − 1)/(T·z) the spring contributes K·T/2 at every frequency, because Re{1 − e^(−jωT)} = 1 − cos
/// ωT. The damper contributes −B·cos ωT, because Re{(1 − e^(−jωT))²} = −2·cos ωT·(1 − cos ωT). The most difficult
/// frequency for a positive B is half the sampling rate, where it acts with the opposite sign; for a negative one it is
/// ω = 0. A damper therefore requires as much damping of a device as a spring of 2|B|/T.
///
/// A virtual coupling of k_t and b_t requires k_t·T/2 + b_t, independent of what its tool touches: the tool and its
/// contacts are integrated implicitly and add no energy, and at half the sampling rate the tool's mass is at rest. The
/// two springs in series, K·k_t/(K + k_t), are not a bound: a tool of 2 g on the default coupling requires 1.11 N s/m
/// on a contact of 500 N/m, 1.43 on one of 50 kN/m, and 1.5 on a rigid one, at 1 kHz.
///
/// [Colgate 1997] Colgate, Schenkel: Passivity of a class of sampled-data systems.
double passive_damping_N_s_per_m(double stiffness_N_per_m, double damper_N_s_per_m,
                                 double period_s) noexcept;

/// The same for a force from positions that are `lag_s` (a) old in the mean:
///
///   b > K·(T/2 + a) + |B|
///
/// A pure delay a multiplies H by e^(−jωa). The spring then contributes T·K·sin(nx)/(2 sin x) with x = ωT/2 and n = 1 +
/// 2a/T, at most nTK/2 = K·(T/2 + a), which it has at ω = 0; the damper still contributes at most |B|. A low-pass whose
/// weights h_k ≥ 0 on positions of the age a_k have the sum 1 contributes Σ h_k·K·(T/2 + a_k) at most: only its mean age
/// counts.
double delayed_damping_N_s_per_m(double stiffness_N_per_m, double damper_N_s_per_m, double lag_s,
                                 double period_s) noexcept;

/// The spring [N/m] that requires as much damping of a device as a spring and a damper together: K + 2|B|/T.
double equivalent_spring_N_per_m(double stiffness_N_per_m, double damper_N_s_per_m,
                                 double period_s) noexcept;

/// The measured limits of a device for springs.
struct MeasuredSprings {
  std::optional<double> damping_N_s_per_m{};  ///< its inherent viscous damping b
  /// The stiffest spring that it was seen to hold, and the rate of the loop that held it; 0: unknown.
  std::optional<double> held_N_per_m{};
  double held_at_Hz = 0.0;
  /// The stiffest spring of the test: a device that held it in a loop as fast has shown no limit.
  double stiffest_tried_N_per_m = 0.0;
};

/// The stiffest spring [N/m] that the device holds in a loop of `rate_Hz`; nullopt if nothing limits it. The smaller of
///
///   2b·f                     the limit of passivity, b > K·T/2
///   K_held · min(f/f_held, 1)    a slower loop holds less: as of 2b·f, in proportion to the rates
std::optional<double> stiffest_spring_N_per_m(const MeasuredSprings& device,
                                              double rate_Hz) noexcept;

/// The steepest damper B [N s/m] on which an apparent mass m does not oscillate if the velocity in F = −B·v is delayed
/// by τ (`delay_s`) and the force is held for T:
///
///   B < 2m/T · sin(π/(2(2τ/T + 1)))
///
/// From m·(v_{n+1} − v_n) = −B·T·v_{n−d} with d = τ/T: at the limit z = e^(jθ) solves z^d·(1 − z) = B·T/m; its angle
/// gives θ = π/(2d + 1) and its modulus 2·sin(θ/2). Without a delay the limit is 2m/T, with an oscillation at half the
/// sampling rate; with a long delay it is (π/2)·m/(τ + T/2), at a frequency of 1/(4τ + 2T).
///
/// Limits: a free mass. A velocity that is estimated by a line through n readings is delayed by τ = (n − 1)·T/2; the
/// line's attenuation of fast velocities is neglected, as are the damping and grip of a hand and the quantisation of
/// positions. With 5 N s/m and 300 N/m on 50 g a loop begins to vibrate at 99 N s/m where the limit is 100 (undelayed
/// velocity), at 42 for 28 (five readings and 0.25 ms) and at 23 for 16 (eight readings and 1 ms).
double steepest_damper_N_s_per_m(double moving_mass_kg, double delay_s, double period_s) noexcept;

}  // namespace asperity
