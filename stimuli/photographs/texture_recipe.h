// The parameters by which a photograph becomes heights.

#pragma once

#include <string>
#include <vector>

#include "stimuli/properties/parameter.h"

namespace asperity {

enum class HistogramTransformation {
  none,
  equalize,  ///< histogram equalisation
};

/// Which end of the brightness scale is high. A photograph alone does not determine this; its photographer does.
enum class HeightSign { bright_is_high, dark_is_high };

/// The id of the published method [Wu 2009], the default (texture_method.h).
inline constexpr const char* kPublishedMethod = "wu";

/// The parameters of the pipeline (texture_from_photograph.h). [Wu 2009] states no values; the defaults are ours.
struct TextureRecipe {
  double width_m = 0.10;  ///< of the surface, from the left to the right edge of the picture
  HistogramTransformation histogram = HistogramTransformation::none;
  double homomorphic_wavelength_m = 0.020;  ///< λ_h
  double gamma_low = 0.5;                   ///< γ_L, the factor of the longest wavelengths
  double gamma_high = 2.0;                  ///< γ_H, the factor of the shortest
  double gaussian_wavelength_m = 0.005;     ///< λ_g
  double spectral_tilt = 0.0;               ///< p, from 0 (as published) to 1
  double rms_m = 1e-4;                      ///< root mean square of the heights
  HeightSign sign = HeightSign::bright_is_high;
  std::string method = kPublishedMethod;  ///< an id of texture_methods()
  double light_azimuth_deg =
      0.0;  ///< of the light source, counterclockwise from the right of the picture
  double light_elevation_deg = 45.0;  ///< of the light source, above the surface
};

inline constexpr double kLargestTilt = 1.0;

/// The recipe with the names of the command line and of the sidecar of a height field; `sign` is 1 or −1. `method` is left
/// out for the published method, and the direction of the light for a method that does not use it.
ParameterValues parameter_values(const TextureRecipe& recipe);

/// The recipe with all values, for a form.
ParameterValues complete_parameter_values(const TextureRecipe& recipe);

/// The declarations for a form: unit, range, default and meaning, in the order of the steps. The
/// ranges are those of surfaces that a hand can feel; except for the width the pipeline accepts more.
std::vector<Parameter> texture_recipe_parameters();

/// The inverse of both; missing values have their defaults.
///
/// Errors: std::invalid_argument for a value of the wrong kind, or an unknown histogram or method.
TextureRecipe texture_recipe(const ParameterValues& values);

}  // namespace asperity
