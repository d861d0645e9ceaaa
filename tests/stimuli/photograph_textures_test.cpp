// A texture under recipes that change: the same as from the beginning, and no more work than needed.

#include "stimuli/photographs/photograph_textures.h"

#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "stimuli/photographs/texture_from_photograph.h"

namespace asperity {
namespace {

constexpr const char* kName = "wall.png";

GreyImage wall() {
  return synthetic_photograph(
      make_surface("brick", {}, {.width_m = 0.10, .pixels = 150, .seed = 4}), {});
}

/// Every field of a recipe, changed.
std::vector<std::function<void(TextureRecipe&)>> changes() {
  return {
      [](TextureRecipe& recipe) { recipe.rms_m = 2e-4; },
      [](TextureRecipe& recipe) { recipe.sign = HeightSign::dark_is_high; },
      [](TextureRecipe& recipe) { recipe.gaussian_wavelength_m = 0.007; },
      [](TextureRecipe& recipe) { recipe.spectral_tilt = 0.5; },
      [](TextureRecipe& recipe) { recipe.gamma_high = 3.0; },
      [](TextureRecipe& recipe) { recipe.gaussian_wavelength_m = 0.0071; },
      [](TextureRecipe& recipe) { recipe.gamma_low = 0.8; },
      [](TextureRecipe& recipe) { recipe.homomorphic_wavelength_m = 0.015; },
      [](TextureRecipe& recipe) { recipe.histogram = HistogramTransformation::equalize; },
      [](TextureRecipe& recipe) { recipe.width_m = 0.12; },
      [](TextureRecipe& recipe) { recipe.histogram = HistogramTransformation::none; },
      [](TextureRecipe& recipe) { recipe.sign = HeightSign::bright_is_high; },
      [](TextureRecipe& recipe) { recipe.method = "pentland"; },
      [](TextureRecipe& recipe) { recipe.gaussian_wavelength_m = 0.006; },
      [](TextureRecipe& recipe) { recipe.light_azimuth_deg = 90.0; },
      [](TextureRecipe& recipe) { recipe.light_elevation_deg = 30.0; },
      [](TextureRecipe& recipe) { recipe.homomorphic_wavelength_m = 0.02; },
      [](TextureRecipe& recipe) { recipe.method = "tsai_shah"; },
      [](TextureRecipe& recipe) { recipe.method = "brightness"; },
      [](TextureRecipe& recipe) { recipe.method = kPublishedMethod; },
      [](TextureRecipe& recipe) { recipe = {}; },
  };
}

void expect_same(const PhotographTextures::Steps& steps, const PhotographTexture& whole) {
  EXPECT_EQ(steps.field->heights_m(), whole.field.heights_m());
  EXPECT_EQ(steps.field->grid().pitch_m, whole.field.grid().pitch_m);
  EXPECT_EQ(steps.grey->values, whole.grey.values);
  EXPECT_EQ(steps.evened->values, whole.evened.values);
  EXPECT_EQ(steps.low_pass->values, whole.low_pass.values);
}

TEST(PhotographTextures, AreThoseOfTheWholePipelineWhateverWasAskedBefore) {
  const GreyImage photograph = wall();
  for (const int threads : {1, 2, 5}) {
    PhotographTextures textures(photograph, kName, threads);
    TextureRecipe recipe{};
    expect_same(textures.texture(recipe), texture_from_photograph(photograph, recipe, kName));
    for (const auto& change : changes()) {
      change(recipe);
      expect_same(textures.texture(recipe), texture_from_photograph(photograph, recipe, kName));
    }
  }
}

TEST(PhotographTextures, KeepWhatANewRecipeDoesNotTouch) {
  PhotographTextures textures(wall(), kName);
  TextureRecipe recipe{};
  const PhotographTextures::Steps first = textures.texture(recipe);
  recipe.rms_m = 3e-4;
  recipe.sign = HeightSign::dark_is_high;
  const PhotographTextures::Steps higher = textures.texture(recipe);
  EXPECT_EQ(higher.evened, first.evened);
  EXPECT_EQ(higher.low_pass, first.low_pass);
  EXPECT_NE(higher.field, first.field);
  recipe.gaussian_wavelength_m = 0.006;
  const PhotographTextures::Steps longer = textures.texture(recipe);
  EXPECT_EQ(longer.evened, first.evened);
  EXPECT_NE(longer.low_pass, first.low_pass);
  recipe.gamma_low = 0.7;
  const PhotographTextures::Steps evener = textures.texture(recipe);
  EXPECT_EQ(evener.grey, first.grey);
  EXPECT_NE(evener.evened, first.evened);
}

TEST(PhotographTextures, GoOnAfterARecipeThatIsRefused) {
  const GreyImage photograph = wall();
  PhotographTextures textures(photograph, kName);
  TextureRecipe recipe{};
  textures.texture(recipe);
  recipe.gaussian_wavelength_m = 1e-5;
  EXPECT_THROW(textures.texture(recipe), std::invalid_argument);
  recipe.gaussian_wavelength_m = 0.004;
  expect_same(textures.texture(recipe), texture_from_photograph(photograph, recipe, kName));
}

// γ so small that nothing is left to feel: refused after the light was evened out.
TEST(PhotographTextures, GoOnAfterARecipeThatLeavesNoContrast) {
  const GreyImage photograph = wall();
  PhotographTextures textures(photograph, kName);
  TextureRecipe recipe{};
  textures.texture(recipe);
  recipe.gamma_low = 1e-9;
  recipe.gamma_high = 1e-9;
  EXPECT_THROW(textures.texture(recipe), std::invalid_argument);
  EXPECT_THROW(textures.texture(recipe), std::invalid_argument);
  recipe = {};
  expect_same(textures.texture(recipe), texture_from_photograph(photograph, recipe, kName));
}

}  // namespace
}  // namespace asperity
