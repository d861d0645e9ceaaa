// Declares the amplitude and the wavelength of a texture as a device meets it.

#pragma once

#include <optional>

#include "renderers/force/force_model.h"

namespace asperity {

/// A texture as one sinusoid, in metres on the device.
struct TextureWaves {
  std::optional<double> amplitude_m{};   ///< √2 times the RMS of the heights
  std::optional<double> wavelength_m{};  ///< divided by the patch's motion scale
};

/// The sinusoid of a stimulus: that of its parameters, or the one that its height field suggests (the model "sinusoid"
/// in `models`), times the model's `height_scale`. A texture of parameters with several wavelengths has the shortest one
/// and no amplitude. Empty for a texture at amplitude 0 and noise in time.
///
/// `inputs` has complete parameters.
TextureWaves texture_waves(const ForceModel& model, const RendererInputs& inputs,
                           const ModelRegistry& models);

}  // namespace asperity
