// Converts a recipe to parameter values and back, with the declaration of each parameter.

#include "stimuli/photographs/texture_recipe.h"

#include <stdexcept>
#include <string>

#include "stimuli/photographs/shape_from_shading.h"
#include "stimuli/photographs/texture_method.h"

namespace asperity {

ParameterValues parameter_values(const TextureRecipe& recipe) {
  ParameterValues values = complete_parameter_values(recipe);
  if (recipe.method == kPublishedMethod) values.erase("method");
  if (!texture_method(recipe.method).uses_light) {
    values.erase("light_azimuth_deg");
    values.erase("light_elevation_deg");
  }
  return values;
}

ParameterValues complete_parameter_values(const TextureRecipe& recipe) {
  return {
      {"width_m", recipe.width_m},
      {"histogram",
       std::string(recipe.histogram == HistogramTransformation::none ? "none" : "equalize")},
      {"homomorphic_wavelength_m", recipe.homomorphic_wavelength_m},
      {"gamma_low", recipe.gamma_low},
      {"gamma_high", recipe.gamma_high},
      {"gaussian_wavelength_m", recipe.gaussian_wavelength_m},
      {"spectral_tilt", recipe.spectral_tilt},
      {"rms_m", recipe.rms_m},
      {"sign", recipe.sign == HeightSign::bright_is_high ? 1.0 : -1.0},
      {"method", recipe.method},
      {"light_azimuth_deg", recipe.light_azimuth_deg},
      {"light_elevation_deg", recipe.light_elevation_deg},
  };
}

std::vector<Parameter> texture_recipe_parameters() {
  const TextureRecipe defaults{};
  std::vector<std::string> methods{};
  Phrase meaning_of_method{};
  for (const TextureMethod& method : texture_methods()) {
    methods.push_back(method.id);
    const Phrase one = Phrase("%1: %2").with(method.id, method.summary);
    meaning_of_method =
        meaning_of_method.empty() ? one : Phrase("%1; %2").with(meaning_of_method, one);
  }
  return {
      {.name = "method",
       .kind = ParameterKind::choice,
       .unit = "1",
       .choices = methods,
       .default_value = defaults.method,
       .meaning = meaning_of_method},
      number_parameter("light_azimuth_deg", "°", -360.0, 360.0, defaults.light_azimuth_deg,
                       phrase("Stimuli",
                              "Direction of the light source for pentland and tsai_shah, "
                              "counterclockwise: 0 is the "
                              "right of the picture, 90 the top")),
      number_parameter(
          "light_elevation_deg", "°", kLowestLight_deg, kHighestLight_deg,
          defaults.light_elevation_deg,
          phrase("Stimuli",
                 "Height of the light source above the surface for pentland and tsai_shah")),
      number_parameter(
          "width_m", "m", 0.001, 1.0, defaults.width_m,
          phrase("Stimuli",
                 "Width of the surface in the photograph, from its left to its right edge")),
      choice_parameter("histogram", {"none", "equalize"},
                       phrase("Stimuli",
                              "none: brightness as stored; equalize: histogram equalisation, which "
                              "removes the relation of brightness to height")),
      number_parameter(
          "homomorphic_wavelength_m", "m", 0.0005, 0.5, defaults.homomorphic_wavelength_m,
          phrase("Stimuli",
                 "Variations in brightness with wavelengths longer than this count as lighting, "
                 "shorter ones as the surface")),
      number_parameter(
          "gamma_low", "1", 0.05, 2.0, defaults.gamma_low,
          phrase("Stimuli",
                 "Factor applied to gradual changes in lighting; below 1 attenuates them")),
      number_parameter(
          "gamma_high", "1", 0.2, 5.0, defaults.gamma_high,
          phrase("Stimuli", "Factor applied to fine detail; above 1 raises its contrast")),
      number_parameter(
          "gaussian_wavelength_m", "m", 0.0002, 0.2, defaults.gaussian_wavelength_m,
          phrase(
              "Stimuli",
              "Wavelengths longer than about this are left out of the heights: they are shape, not "
              "texture")),
      number_parameter(
          "spectral_tilt", "1", 0.0, kLargestTilt, defaults.spectral_tilt,
          phrase(
              "Stimuli",
              "Exponent p by which wavelengths shorter than the longest one kept are attenuated: "
              "amplitudes are multiplied by (wavelength/longest)^p. 0: as published; the heights "
              "of most surfaces have less short-wave detail than their brightness")),
      number_parameter(
          "rms_m", "m", 1e-6, 2e-3, defaults.rms_m,
          phrase("Stimuli",
                 "Roughness of the relief: the RMS of its heights. A photograph does not show it")),
  };
}

TextureRecipe texture_recipe(const ParameterValues& values) {
  ParameterValues complete = complete_parameter_values(TextureRecipe{});
  for (const auto& [name, value] : values) complete[name] = value;
  const std::string& histogram = choice_of(complete, "histogram");
  if (histogram != "none" && histogram != "equalize") {
    throw std::invalid_argument("histogram is \"" + histogram + "\"; it must be none or equalize.");
  }
  return {.width_m = number_of(complete, "width_m"),
          .histogram = histogram == "none" ? HistogramTransformation::none
                                           : HistogramTransformation::equalize,
          .homomorphic_wavelength_m = number_of(complete, "homomorphic_wavelength_m"),
          .gamma_low = number_of(complete, "gamma_low"),
          .gamma_high = number_of(complete, "gamma_high"),
          .gaussian_wavelength_m = number_of(complete, "gaussian_wavelength_m"),
          .spectral_tilt = number_of(complete, "spectral_tilt"),
          .rms_m = number_of(complete, "rms_m"),
          .sign = number_of(complete, "sign") > 0.0 ? HeightSign::bright_is_high
                                                    : HeightSign::dark_is_high,
          .method = texture_method(choice_of(complete, "method")).id,
          .light_azimuth_deg = number_of(complete, "light_azimuth_deg"),
          .light_elevation_deg = number_of(complete, "light_elevation_deg")};
}

}  // namespace asperity
