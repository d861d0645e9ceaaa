// How strong a texture is as a force, and the amplitude that makes two models equally strong.

#pragma once

#include <string>

#include "renderers/force/force_model.h"

namespace asperity {

/// The one open-loop path on which texture forces are compared: straight along +x through the
/// patch's centre at constant speed and constant height, the height being the one at which the mean
/// normal force is `mean_normal_force_N`. Nothing yields: no hand, no device.
///
/// The patch keeps its plane and its motion scale; its border is taken away and its texture
/// repeats, so that every stimulus is compared over the same distance, 0.12 m by default.
struct TextureForcePath {
  double speed_m_per_s = 0.060;
  double duration_s = 2.0;
  double dropped_s = 0.2;  ///< from the beginning, before means and spectra are taken
  double rate_Hz = 1000.0;
  double mean_normal_force_N = 1.0;
  double low_Hz = 5.0;  ///< the band of the RMS, both borders included
  double high_Hz = 500.0;
};

/// RMS of the texture force along the path, within the band.
///
///   D(t) = F(t) − F₀(t)
///   RMS² = RMS²_band(D_x) + RMS²_band(D_y) + RMS²_band(D_z)
///
/// F is the force of the stimulus, F₀ that of the same model without texture and friction
/// (`without_texture`) along the same path. The friction that is left in F is constant but for what
/// the texture makes of it. Equal RMS is not equal perceived intensity.
///
/// Errors: std::invalid_argument for a path that makes no sense, inputs that the model refuses, and
/// a mean normal force that no height gives, naming the model and the force that is reached.
double texture_force_rms_N(const ForceModel& model, const RendererInputs& inputs,
                           const TextureForcePath& path = {});

/// The answer of `solve_amplitude`, to be stored with the stimulus.
struct SolvedAmplitude {
  std::string parameter{};  ///< ModelDeclaration::amplitude_parameter
  double value = 0.0;       ///< in that parameter's unit
  double texture_force_rms_N = 0.0;
};

/// The value of the model's amplitude parameter at which the texture force has the given RMS, to
/// 1e-9 of it: the smallest on the way up by doubling from the given or default value. Everything
/// else in `inputs` stays.
///
/// Errors: as texture_force_rms_N; and std::invalid_argument for a target that is not positive, a
/// model without amplitude parameter, and a target out of reach within the parameter's declared
/// range, naming model, range and the RMS at both ends.
SolvedAmplitude solve_amplitude(const ForceModel& model, const RendererInputs& inputs,
                                double target_rms_N, const TextureForcePath& path = {});

}  // namespace asperity
