// Evens the light by the method of the recipe, then subtracts the low-pass and scales to heights.

#include "stimuli/photographs/texture_from_photograph.h"

#include <utility>

#include "stimuli/photographs/texture_method.h"
#include "stimuli/photographs/texture_steps.h"
#include "stimuli/pictures/bands.h"

namespace asperity {

PhotographTexture texture_from_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                          const std::string& name) {
  check_recipe(photograph, recipe, name);
  GreyImage grey = with_histogram(photograph, recipe.histogram);
  GreyImage evened = texture_method(recipe.method).relief(grey, recipe, usual_threads());
  GreyImage low_pass = low_passed(evened, gaussian_cutoff(recipe, grey), usual_threads());
  HeightField field =
      heights_of(residual_of(evened, low_pass, recipe, name, usual_threads()), recipe);
  return {std::move(field), std::move(grey), std::move(evened), std::move(low_pass)};
}

GreyImage brightness_residual(const GreyImage& photograph, const TextureRecipe& recipe,
                              const std::string& name) {
  check_recipe(photograph, recipe, name);
  const GreyImage low_pass =
      low_passed(photograph, gaussian_cutoff(recipe, photograph), usual_threads());
  return residual_of(photograph, low_pass, recipe, name, usual_threads()).values;
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
