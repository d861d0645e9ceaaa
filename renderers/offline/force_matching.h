// Declares the strength of a texture as a force, and the amplitude that makes two models equally strong.

#pragma once

#include <string>

#include "renderers/force/force_model.h"

namespace asperity {

/// The standard open-loop path for the comparison of texture forces: straight along +x through the patch's centre at
/// constant speed and constant height, where the height gives the mean normal force `mean_normal_force_N`. There is no
/// yielding hand or device.
///
/// The patch keeps its plane and its motion scale; its border is removed and its texture repeats, so that all stimuli
/// are compared over the same distance, 0.12 m by default.
struct TextureForcePath {
  double speed_m_per_s = 0.060;
  double duration_s = 2.0;
  double dropped_s = 0.2;  ///< beginning that is excluded from means and spectra
  double rate_Hz = 1000.0;
  double mean_normal_force_N = 1.0;
  double low_Hz = 5.0;  ///< the band of the RMS, both limits included
  double high_Hz = 500.0;
};

/// The RMS of the texture force along the path, within the band.
///
///   D(t) = F(t) − F₀(t)
///   RMS² = RMS²_band(D_x) + RMS²_band(D_y) + RMS²_band(D_z)
///
/// F is the force of the stimulus, F₀ that of the same model without texture and friction (`without_texture`) along the
/// same path. The friction in F is constant except for the effect of the texture on it; a law of friction that remembers
/// the contact (FrictionLaw::remembers) builds up first, so with such a law F₀ has the friction too. Equal RMS is not equal
/// perceived intensity.
///
/// Errors: std::invalid_argument for an invalid path, inputs that the model rejects, and a mean normal force that no
/// height gives, naming the model and the force that is reached.
double texture_force_rms_N(const ForceModel& model, const RendererInputs& inputs,
                           const TextureForcePath& path = {});

/// The result of `solve_amplitude`, which is stored with the stimulus.
struct SolvedAmplitude {
  std::string parameter{};  ///< ModelDeclaration::amplitude_parameter
  double value = 0.0;       ///< in that parameter's unit
  double texture_force_rms_N = 0.0;
};

/// The value of the model's amplitude parameter at which the texture force has the given RMS, accurate to 1e-9 of it, and to
/// 5e-3 for a model with its own law of indentation (indentation_law.h): the smallest solution found by doubling from the
/// given or default value. All other inputs are unchanged.
///
/// Errors: those of texture_force_rms_N; and std::invalid_argument for a target that is not positive, a model without
/// amplitude parameter, and a target that cannot be reached within the parameter's declared range, naming model, range
/// and the RMS at both ends.
SolvedAmplitude solve_amplitude(const ForceModel& model, const RendererInputs& inputs,
                                double target_rms_N, const TextureForcePath& path = {});

}  // namespace asperity
