// Holds the list of methods, and computes the relative light of each.

#include "stimuli/photographs/texture_method.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "analysis/words/phrased_error.h"
#include "stimuli/photographs/shape_from_shading.h"
#include "stimuli/photographs/texture_steps.h"

namespace asperity {

namespace {

LightDirection light_of(const TextureRecipe& recipe) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return {.azimuth_rad = recipe.light_azimuth_deg * kDegree,
          .elevation_rad = recipe.light_elevation_deg * kDegree};
}

std::vector<TextureMethod> make_methods() {
  return {
      {.id = kPublishedMethod,
       .summary = phrase("Stimuli",
                         "brightness as height, after a homomorphic filter; the published method"),
       .source = "Wu 2009",
       .relief =
           [](const GreyImage& grey, const TextureRecipe& recipe, int threads) {
             return evened_light(
                 logarithm_spectrum(grey, homomorphic_cutoff(recipe, grey), threads), recipe,
                 threads);
           }},
      {.id = "brightness",
       .summary = phrase("Stimuli", "brightness as height, without a homomorphic filter"),
       .relief = [](const GreyImage& grey, const TextureRecipe&, int) { return grey; }},
      {.id = "pentland",
       .summary = phrase(
           "Stimuli",
           "shape from shading in light from one side, linear solution in the Fourier domain"),
       .source = "Pentland 1990",
       .uses_light = true,
       .relief =
           [](const GreyImage& grey, const TextureRecipe& recipe, int threads) {
             return relief_by_pentland(relative_light(grey, recipe, threads), light_of(recipe));
           }},
      {.id = "tsai_shah",
       .summary =
           phrase("Stimuli",
                  "shape from shading in light from one side, linear approximation by iteration"),
       .source = "Tsai 1994",
       .uses_light = true,
       .relief =
           [](const GreyImage& grey, const TextureRecipe& recipe, int threads) {
             return relief_by_tsai_shah(relative_light(grey, recipe, threads), light_of(recipe));
           }},
  };
}

}  // namespace

const std::vector<TextureMethod>& texture_methods() {
  static const std::vector<TextureMethod> methods = make_methods();
  return methods;
}

const TextureMethod& texture_method(std::string_view id) {
  const std::vector<TextureMethod>& methods = texture_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [id](const TextureMethod& method) { return method.id == id; });
  if (found != methods.end()) return *found;
  std::string sentence = "method is \"" + std::string(id) + "\"; it must be one of:";
  for (const TextureMethod& method : methods) sentence += ' ' + method.id;
  throw std::invalid_argument(sentence + '.');
}

void check_method(const TextureRecipe& recipe) {
  const TextureMethod& method = texture_method(recipe.method);
  if (!method.uses_light) return;
  check_light(recipe.light_azimuth_deg, recipe.light_elevation_deg, method.id);
  if (recipe.sign != HeightSign::bright_is_high) {
    throw std::invalid_argument(
        "sign is -1; with the method " + method.id +
        ", the direction of the light determines which parts are high. Use sign 1. If the relief "
        "is inverted, add 180 to light_azimuth_deg.");
  }
  if (recipe.histogram != HistogramTransformation::none) {
    throw PhrasedRefusal(phrase("Stimuli",
                                "histogram is equalize; the method %1 needs brightness that is "
                                "proportional to light. Use none.")
                             .with(method.id));
  }
}

GreyImage relative_light(const GreyImage& grey, const TextureRecipe& recipe, int threads) {
  const GreyImage level =
      PictureSpectrum(grey, homomorphic_cutoff(recipe, grey), threads).filtered({});
  GreyImage relative = grey;
  for (std::size_t i = 0; i < relative.values.size(); ++i) {
    relative.values[i] = (relative.values[i] + static_cast<float>(kBlackLevel)) /
                         (std::max(level.values[i], 0.0F) + static_cast<float>(kBlackLevel));
  }
  return relative;
}

}  // namespace asperity
