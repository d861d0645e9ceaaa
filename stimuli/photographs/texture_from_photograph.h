// Computes heights from a photograph of a surface: a relief from the brightness, Gaussian low-pass, residual.

#pragma once

#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/photographs/texture_recipe.h"
#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// A texture with the pictures of its steps; all four have the rows and columns of the photograph.
struct PhotographTexture {
  HeightField field;
  GreyImage grey{};  ///< the input after the histogram transformation
  GreyImage
      evened{};  ///< f: with even lighting and higher local contrast, or the relief from shading
  GreyImage low_pass{};  ///< g
};

/// Converts brightness to heights, as in [Wu 2009].
///
/// With b the brightness in [0, 1], wavenumber ν = 1/wavelength in 1/m, ε = 1/255 (so that black
/// has a logarithm) and ℱ the Fourier transform over the picture:
///
///     f = exp(ℱ⁻¹[H_h ℱ ln(b + ε)]) − ε,   H_h(ν) = γ_L + (γ_H − γ_L)(1 − exp(−ν² λ_h²))
///     g = ℱ⁻¹[H_g ℱ f],                    H_g(ν) = exp(−½ ν² λ_g²)
///     d = ±ℱ⁻¹[H_t ℱ (f − g)],              H_t(ν) = max(1, ν λ_g)⁻ᵖ
///     mean removed, scaled to an RMS of rms_m
///
/// At the cut-off wavelength λ_g the low-pass keeps e^−½ = 61 % and the heights 39 % of f. Heights keep half
/// of f at 0.85 λ_g and a tenth at 2.2 λ_g. With γ_L = γ_H = 1 the first line has no effect.
/// The published method is p = 0 (spectral_tilt). Heights of rough surfaces fall more steeply with wavenumber than their
/// brightness, whose edges are those of shade and material; p > 0 attenuates short waves accordingly.
/// This f is that of the method "wu". The method "brightness" has f = b; "pentland" and "tsai_shah" have as f the heights
/// that explain b as the shading of a matt surface in light from a known side, in pixels (shape_from_shading.h). The other
/// lines are the same for all methods, which texture_method.h lists.
/// The picture is continued by reflection, by three standard deviations of a filter's impulse
/// response (√2 λ_h/2π and λ_g/2π) on each side, at most by its own size, and further to a size
/// that transforms quickly.
///
/// Limits: the heights are those of the surface only where brightness corresponds to height. Light from one side
/// shows the slope towards it, and paint appears as relief (docs/photographs.md). H_h halves a slow
/// change of lighting (in the logarithm) and does not remove it.
///
/// Errors: std::invalid_argument with a sentence that begins with `name` or names the field of the recipe: a picture of
/// fewer than 16 pixels a side, one without contrast, a width outside the declared range, pixels of more than 1 mm of
/// the surface, a cut-off wavelength shorter than two pixels, a length, RMS or γ that is not positive; and those of
/// `check_method`.
///
/// The same picture and recipe give the same heights on the same machine, bit for bit.
///
/// [Wu 2009] Wu, Song, Zou: A Novel Haptic Texture Display Based on Image Processing.
PhotographTexture texture_from_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                          const std::string& name);

/// ℱ⁻¹[H_t (1 − H_g) ℱ b]: the brightness in the same band, without the homomorphic filter. Errors: those of
/// texture_from_photograph.
GreyImage brightness_residual(const GreyImage& photograph, const TextureRecipe& recipe,
                              const std::string& name);

/// d = f − g of any heights: the result of the Gaussian high-pass 1 − H_g, with the same continuation, for comparing
/// heights in the band that a photograph keeps.
HeightField without_long_wavelengths(const HeightField& field, double gaussian_wavelength_m);

}  // namespace asperity
