// The steps from brightness to heights one by one, for callers that keep intermediate results.

#pragma once

#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/photographs/texture_recipe.h"
#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/picture_filter.h"

namespace asperity {

// Formulas and symbols are those of texture_from_photograph.h. The results do not depend on the number of
// `threads`.

/// ε: one step of an 8-bit picture.
inline constexpr double kBlackLevel = 1.0 / 255.0;

/// Errors: those of texture_from_photograph, except for missing contrast.
void check_recipe(const GreyImage& photograph, const TextureRecipe& recipe,
                  const std::string& name);
void refuse_unless_positive(double value, const char* field);

GreyImage with_histogram(const GreyImage& photograph, HistogramTransformation transformation);

/// The cut-off wavelengths of H_h and H_g in the form of RadialFilter, in pixels.
double homomorphic_cutoff(const TextureRecipe& recipe, const GreyImage& photograph) noexcept;
double gaussian_cutoff(const TextureRecipe& recipe, const GreyImage& photograph) noexcept;

/// ℱ ln(b + ε), with a border for a filter with that cut-off.
PictureSpectrum logarithm_spectrum(const GreyImage& grey, double homomorphic_cutoff, int threads);
/// f
GreyImage evened_light(const PictureSpectrum& logarithm, const TextureRecipe& recipe, int threads);
/// g
GreyImage low_passed(const GreyImage& picture, double gaussian_cutoff, int threads);

GreyImage difference(const GreyImage& from, const GreyImage& what);

/// f − g after the spectral tilt, with its mean and standard deviation.
struct Residual {
  GreyImage values{};
  double mean = 0.0;
  double deviation = 0.0;
};
/// Errors: std::invalid_argument if the residual is no more than rounding.
Residual residual_of(const GreyImage& evened, const GreyImage& low_pass,
                     const TextureRecipe& recipe, const std::string& name, int threads);

/// d
HeightField heights_of(Residual residual, const TextureRecipe& recipe);

}  // namespace asperity
