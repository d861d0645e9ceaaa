// Declares stochastic resonance: noise that is added to the force of a surface.

#pragma once

#include <memory>
#include <vector>

#include "renderers/force/force_model.h"
#include "renderers/force/force_renderer.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// The cut-off frequency of the noise [Hz].
inline constexpr double kResonanceCutoff_Hz = 300.0;

/// Adds the parameters of stochastic resonance to those of a point model: `resonance_ratio` and `resonance_threshold_N`.
void add_resonance_parameters(std::vector<Parameter>& parameters);

/// The standard deviation σ_sr of the noise [N] with these values; 0 where the layer is switched off or not declared.
double resonance_sd_N(const ParameterValues& parameters) noexcept;

/// A model's values without those of this layer where it is switched off.
ParameterValues without_unused_resonance(const ParameterValues& parameters);

/// Adds noise to the normal force of a surface while it is touched. A weak texture that is below the detection threshold
/// can be detected more often with noise than without it [Collins 1996].
///
///   F    = F_s + g·max(y(t), −F_sz/g)·n,   y = σ_sr·L(ξ)      in contact; F_s the force of the model [N]
///   σ_sr = r·θ                                               standard deviation of y [N]
///
/// r = `resonance_ratio` (0: no noise). θ = `resonance_threshold_N` is the participant's detection threshold as a force;
/// it must be measured, for example with a staircase, and has no default. g fades at the border of the patch like the
/// force of the model, and in over the first 0.1 mm of penetration (contact_fade.h). F never pulls. The friction in F_s is
/// that of the model's normal force, without the noise.
///
/// ξ_j is the standard normal number that belongs to the seed and to j = ⌊(t − t₀)·6000/s⌋, t₀ the first sample's time. L
/// is the ServoLowPass, whose cut-off frequency is a twentieth of the rate of its steps: 300 Hz at 6000 steps per second.
/// L(ξ) has the variance Σh_i², h the response of L to a unit impulse, and is divided by its square root. The noise is the
/// same function of time at any servo rate. Its one-sided spectrum is 2·σ_sr²·|L|²/(6000 Hz·Σh_i²): flat within 0.2 dB up
/// to 200 Hz, −3 dB at 300 Hz, −18 dB at 500 Hz. A servo loop below 1 kHz aliases what is above half of its rate. After
/// more than 64 steps (10.7 ms) without contact the filter begins anew.
///
/// A hard threshold θ, and a signal that adds A < θ in one of two intervals: with one look per interval the proportion of
/// correct responses is ½ + ½·[Φ((A − θ)/σ) − Φ(−θ/σ)], because one interval alone exceeds θ with this difference of
/// probabilities and the responses to all other cases are guesses. Its only maximum is at σ² = A(2θ − A)/(2·ln(θ/(θ − A))).
///
/// Returns `surface` unchanged if σ_sr is 0. `inputs` are those that `surface` was made from, with complete parameters.
/// Errors: std::invalid_argument for a positive `resonance_ratio` with `resonance_threshold_N` 0.
///
/// [Collins 1996] Collins, Imhoff, Grigg: Noise-enhanced tactile sensation.
std::unique_ptr<ForceRenderer> with_resonance(std::unique_ptr<ForceRenderer> surface,
                                              const RendererInputs& inputs);

}  // namespace asperity
