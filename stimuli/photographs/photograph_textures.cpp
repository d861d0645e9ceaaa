// Implements the cache of the pipeline's intermediate results and its invalidation.

#include "stimuli/photographs/photograph_textures.h"

#include <utility>

#include "stimuli/photographs/texture_method.h"
#include "stimuli/pictures/bands.h"

namespace asperity {

PhotographTextures::PhotographTextures(GreyImage photograph, std::string name)
    : PhotographTextures(std::move(photograph), std::move(name), usual_threads()) {}

PhotographTextures::PhotographTextures(GreyImage photograph, std::string name, int threads)
    : photograph_(std::make_shared<const GreyImage>(std::move(photograph))),
      name_(std::move(name)),
      threads_(threads) {}

PhotographTextures::Steps PhotographTextures::texture(const TextureRecipe& recipe) {
  check_recipe(*photograph_, recipe, name_);
  const double homomorphic = homomorphic_cutoff(recipe, *photograph_);
  const double gaussian = gaussian_cutoff(recipe, *photograph_);
  // Invalidates the results from the first changed step onwards; the code below recomputes what is missing.
  const bool grey_holds = grey_ != nullptr && recipe.histogram == last_.histogram;
  const bool logarithm_holds =
      grey_holds && logarithm_ && homomorphic == logarithm_->cutoff_wavelength();
  const bool evened_holds = grey_holds && evened_ != nullptr && recipe.method == last_.method &&
                            homomorphic == homomorphic_cutoff(last_, *photograph_) &&
                            recipe.gamma_low == last_.gamma_low &&
                            recipe.gamma_high == last_.gamma_high &&
                            recipe.light_azimuth_deg == last_.light_azimuth_deg &&
                            recipe.light_elevation_deg == last_.light_elevation_deg;
  const bool low_pass_holds =
      evened_holds && low_pass_ != nullptr && gaussian == gaussian_cutoff(last_, *photograph_);
  const bool residual_holds =
      low_pass_holds && residual_ && recipe.spectral_tilt == last_.spectral_tilt;
  if (!residual_holds) residual_.reset();
  if (!low_pass_holds) low_pass_.reset();
  if (!evened_holds) evened_.reset();
  if (!logarithm_holds) logarithm_.reset();
  if (!grey_holds) grey_.reset();
  last_ = recipe;

  if (grey_ == nullptr) {
    grey_ = recipe.histogram == HistogramTransformation::none
                ? photograph_
                : std::make_shared<const GreyImage>(with_histogram(*photograph_, recipe.histogram));
  }
  if (evened_ == nullptr && recipe.method == kPublishedMethod) {
    // The only method of which a part is kept: γ changes without the spectrum.
    if (!logarithm_) logarithm_ = logarithm_spectrum(*grey_, homomorphic, threads_);
    evened_ = std::make_shared<const GreyImage>(evened_light(*logarithm_, recipe, threads_));
  }
  if (evened_ == nullptr) {
    evened_ = std::make_shared<const GreyImage>(
        texture_method(recipe.method).relief(*grey_, recipe, threads_));
  }
  if (!residual_) {
    if (low_pass_ == nullptr) {
      low_pass_ = std::make_shared<const GreyImage>(low_passed(*evened_, gaussian, threads_));
    }
    residual_ = residual_of(*evened_, *low_pass_, recipe, name_, threads_);
  }
  return {std::make_shared<const HeightField>(heights_of(*residual_, recipe)), grey_, evened_,
          low_pass_};
}

}  // namespace asperity
