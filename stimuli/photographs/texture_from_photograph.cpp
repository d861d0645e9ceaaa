// The recipe, and the chapter's pipeline from beginning to end.

#include "stimuli/photographs/texture_from_photograph.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "stimuli/photographs/texture_steps.h"
#include "stimuli/pictures/bands.h"

namespace asperity {

ParameterValues parameter_values(const TextureRecipe& recipe) {
  return {
      {"width_m", recipe.width_m},
      {"histogram",
       std::string(recipe.histogram == HistogramTransformation::none ? "none" : "equalize")},
      {"homomorphic_wavelength_m", recipe.homomorphic_wavelength_m},
      {"gamma_low", recipe.gamma_low},
      {"gamma_high", recipe.gamma_high},
      {"gaussian_wavelength_m", recipe.gaussian_wavelength_m},
      {"rms_m", recipe.rms_m},
      {"sign", recipe.sign == HeightSign::bright_is_high ? 1.0 : -1.0},
  };
}

std::vector<Parameter> texture_recipe_parameters() {
  const TextureRecipe usual{};
  const auto number = [](const char* name, const char* unit, double minimum, double maximum,
                         double usual_value, const char* meaning) {
    return Parameter{.name = name,
                     .kind = ParameterKind::number,
                     .unit = unit,
                     .minimum = minimum,
                     .maximum = maximum,
                     .choices = {},
                     .default_value = usual_value,
                     .meaning = meaning};
  };
  return {
      number("width_m", "m", 0.001, 1.0, usual.width_m,
             "Width of the surface in the photograph, from its left to its right edge"),
      {.name = "histogram",
       .kind = ParameterKind::choice,
       .unit = "1",
       .choices = {"none", "equalize"},
       .default_value = std::string("none"),
       .meaning = "none: brightness as stored; equalize: every brightness is made equally "
                  "frequent, which removes the relation of brightness to height"},
      number("homomorphic_wavelength_m", "m", 0.0005, 0.5, usual.homomorphic_wavelength_m,
             "Changes of brightness that are longer than this count as lighting, shorter ones as "
             "the surface"),
      number("gamma_low", "1", 0.05, 2.0, usual.gamma_low,
             "Factor applied to slow changes of the lighting; below 1 evens them out"),
      number("gamma_high", "1", 0.2, 5.0, usual.gamma_high,
             "Factor applied to fine detail; above 1 raises its contrast"),
      number("gaussian_wavelength_m", "m", 0.0002, 0.2, usual.gaussian_wavelength_m,
             "Waves longer than about this are left out of the heights: they are shape, not "
             "texture"),
      number("rms_m", "m", 1e-6, 2e-3, usual.rms_m,
             "Roughness of the relief: the root mean square of its heights. A photograph does not "
             "show it"),
  };
}

TextureRecipe texture_recipe(const ParameterValues& values) {
  ParameterValues complete = parameter_values(TextureRecipe{});
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
          .rms_m = number_of(complete, "rms_m"),
          .sign = number_of(complete, "sign") > 0.0 ? HeightSign::bright_is_high
                                                    : HeightSign::dark_is_high};
}

PhotographTexture texture_from_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                          const std::string& name) {
  check_recipe(photograph, recipe, name);
  GreyImage grey = with_histogram(photograph, recipe.histogram);
  GreyImage evened =
      evened_light(logarithm_spectrum(grey, homomorphic_cutoff(recipe, grey), usual_threads()),
                   recipe, usual_threads());
  GreyImage low_pass = low_passed(evened, gaussian_cutoff(recipe, grey), usual_threads());
  HeightField field = heights_of(residual_of(evened, low_pass, recipe, name), recipe);
  return {std::move(field), std::move(grey), std::move(evened), std::move(low_pass)};
}

GreyImage brightness_residual(const GreyImage& photograph, const TextureRecipe& recipe,
                              const std::string& name) {
  check_recipe(photograph, recipe, name);
  const GreyImage low_pass =
      low_passed(photograph, gaussian_cutoff(recipe, photograph), usual_threads());
  return residual_of(photograph, low_pass, recipe, name).values;
}

HeightField without_long_wavelengths(const HeightField& field, double gaussian_wavelength_m) {
  refuse_unless_positive(gaussian_wavelength_m, "gaussian_wavelength_m");
  const HeightField::Grid& grid = field.grid();
  const GreyImage heights_m{grid.rows, grid.columns, field.heights_m()};
  const GreyImage low_m =
      low_passed(heights_m, gaussian_wavelength_m / grid.pitch_m, usual_threads());
  return {grid, difference(heights_m, low_m).values};
}

}  // namespace asperity
