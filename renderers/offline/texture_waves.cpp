// Implements the amplitude and the wavelength of a texture.

#include "renderers/offline/texture_waves.h"

#include "stimuli/properties/optional_number.h"

namespace asperity {

TextureWaves texture_waves(const ForceModel& model, const RendererInputs& inputs,
                           const ModelRegistry& models) {
  const ModelDeclaration& declaration = model.declaration;
  const ParameterValues& own = inputs.parameters;
  if (declaration.amplitude_parameter &&
      optional_number(own, *declaration.amplitude_parameter) == 0.0) {
    return {};
  }
  ParameterValues suggested{};
  if (optional_number(own, "amplitude_m") && optional_number(own, "wavelength_m")) {
    suggested = own;
  } else if (declaration.needs_height_field && inputs.height_field) {
    const ForceModel* const sinusoid = models.find("sinusoid");
    if (sinusoid == nullptr || !sinusoid->suggested_by) return {};
    suggested = sinusoid->suggested_by(*inputs.height_field, inputs.material);
  } else if (!declaration.needs_bodies && model.band) {
    const double waves_per_m = model.band(inputs).per_m;
    if (waves_per_m > 0.0) return {.wavelength_m = 1.0 / waves_per_m};
  }
  TextureWaves waves{optional_number(suggested, "amplitude_m"),
                     optional_number(suggested, "wavelength_m")};
  if (waves.amplitude_m && inputs.height_field) {
    *waves.amplitude_m *= optional_number(own, "height_scale").value_or(1.0);
  }
  if (waves.wavelength_m) *waves.wavelength_m /= inputs.patch.motion_scale;
  return waves;
}

}  // namespace asperity
