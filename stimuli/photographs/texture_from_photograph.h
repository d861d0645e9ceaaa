// From a photograph of a surface to heights: homomorphic filter, Gaussian low-pass, residual.

#pragma once

#include <string>
#include <vector>

#include "stimuli/heights/height_field.h"
#include "stimuli/pictures/grey_image.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

enum class HistogramTransformation {
  none,
  equalize,  ///< every brightness equally frequent
};

/// Which end of the brightness scale lies high. One photograph cannot tell; the person who took it
/// can.
enum class HeightSign { bright_is_high, dark_is_high };

/// What a photograph's heights depend on besides the photograph. The chapter gives no values; these
/// defaults are ours.
struct TextureRecipe {
  double width_m = 0.10;  ///< of what the picture shows, from its left to its right edge
  HistogramTransformation histogram = HistogramTransformation::none;
  double homomorphic_wavelength_m = 0.020;  ///< λ_h
  double gamma_low = 0.5;                ///< γ_L, what the longest wavelengths are multiplied by
  double gamma_high = 2.0;               ///< γ_H, what the shortest are
  double gaussian_wavelength_m = 0.005;  ///< λ_g
  double rms_m = 1e-4;                   ///< root mean square of the heights
  HeightSign sign = HeightSign::bright_is_high;
};

/// The recipe under the names that the command line and the sidecar of a height field use; `sign`
/// is 1 or −1.
ParameterValues parameter_values(const TextureRecipe& recipe);

/// What a form may offer of each: unit, range, default and meaning, in the order of the steps. The
/// ranges are those of photographs of surfaces that a hand feels; but for the width the pipeline refuses less.
std::vector<Parameter> texture_recipe_parameters();

/// The reverse of `parameter_values`; what is not given keeps its default.
///
/// Errors: std::invalid_argument for a value of the wrong kind or a histogram that is not there.
TextureRecipe texture_recipe(const ParameterValues& values);

/// A texture and how it came about; all four have the rows and columns of the photograph.
struct PhotographTexture {
  HeightField field;
  GreyImage grey{};      ///< what went in, after the histogram transformation
  GreyImage evened{};    ///< f: the lighting evened out, local contrast raised
  GreyImage low_pass{};  ///< g
};

/// Brightness to heights, as in [Wu 2009].
///
/// With b the brightness in [0, 1], wavenumber ν = 1/wavelength in 1/m, ε = 1/255 (so that black
/// has a logarithm) and ℱ the Fourier transform over the picture:
///
///     f = exp(ℱ⁻¹[H_h ℱ ln(b + ε)]) − ε,   H_h(ν) = γ_L + (γ_H − γ_L)(1 − exp(−ν² λ_h²))
///     g = ℱ⁻¹[H_g ℱ f],                    H_g(ν) = exp(−½ ν² λ_g²)
///     d = ±(f − g), mean removed, scaled to an RMS of rms_m
///
/// So at the cut-off wavelength λ_g the low-pass keeps e^−½ = 61 % and the heights 39 % of f; half
/// of f is kept at 0.85 λ_g, a tenth at 2.2 λ_g. With γ_L = γ_H = 1 the first line does nothing.
/// The picture is continued by reflection, by three standard deviations of a filter's impulse
/// response (√2 λ_h/2π and λ_g/2π) on each side, at most by its own size, and further to a size
/// that transforms quickly.
///
/// Limits: heights follow brightness only where brightness followed height. Light from one side
/// gives the slope towards it, and paint gives paint (docs/photographs.md). H_h halves a slow
/// change of lighting (in the logarithm) and does not remove it.
///
/// Errors: std::invalid_argument, a sentence that begins with `name` or names the field of the
/// recipe: a picture of less than 16 pixels a side, one without contrast, a width outside the declared
/// range, pixels of more than 1 mm of the surface, a cut-off wavelength shorter than two pixels, a length, RMS or γ that
/// is not positive.
///
/// The same picture and recipe give the same heights, bit for bit, on the same machine.
///
/// [Wu 2009] Wu, Song, Zou: A Novel Haptic Texture Display Based on Image Processing.
PhotographTexture texture_from_photograph(const GreyImage& photograph, const TextureRecipe& recipe,
                                          const std::string& name);

/// b − ℱ⁻¹[H_g ℱ b]: what is left of the brightness without evening out. Errors: as above.
GreyImage brightness_residual(const GreyImage& photograph, const TextureRecipe& recipe,
                              const std::string& name);

/// d = f − g of anything on a grid: what the Gaussian high-pass 1 − H_g leaves of it, with the same
/// continuation. Lengths in metres; for comparing heights in the band that a photograph can keep.
HeightField without_long_wavelengths(const HeightField& field, double gaussian_wavelength_m);

}  // namespace asperity
