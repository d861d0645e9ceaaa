// Surfaces with known heights that formulas make.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/heights/height_field.h"
#include "stimuli/heights/surface_declaration.h"

namespace asperity {

/// All kinds: regular patterns (sinusoid, grating, cones), noise, and five materials
/// (metal, stone, wood, brick, sandpaper) that are composed of both and differ in the wavelengths
/// and the direction of their relief, so that each is recognised by a stroke along x.
std::vector<SurfaceDeclaration> synthetic_surfaces();

/// The width, the samples and the seed of a canvas as parameters, with the values of a new one as defaults.
std::vector<Parameter> canvas_parameters();
/// The canvas with these values; what they leave out has its default. Errors: as `complete_values`.
SurfaceCanvas canvas_with(const ParameterValues& values);

/// The surface of that kind; `values` may leave parameters to their defaults.
///
/// Every surface repeats without a seam under Tiling::repeat, those with a regular spacing if
/// the width is a whole number of spacings (brick: an even number of courses), as with the defaults.
/// Other widths are not stretched and have a seam.
///
/// Errors: std::invalid_argument for an unknown kind, values that their declarations
/// refuse, parameters that contradict each other, a width outside 1 mm to 1 m, fewer than 16 or
/// more than 8192 pixels, and a detail that is too fine for the pixels (under two of them).
HeightField make_surface(std::string_view kind, const ParameterValues& values,
                         const SurfaceCanvas& canvas);

/// A structure that repeats at equal distances.
enum class RegularPart {
  spacing,           ///< spacing_m
  spacing_at_angle,  ///< spacing_m along an axis at angle_rad
  brick,             ///< brick_length_m
  pair_of_courses,   ///< 2 · course_height_m
};

/// The seam of a repeated surface: its width is not a whole number of regular parts.
struct SurfaceSeam {
  double width_m = 0.0;
  char axis = 'x';
  RegularPart part = RegularPart::spacing;
  double part_m = 0.0;
  double count = 0.0;  ///< of parts in the width
  std::optional<double>
      narrower_m{};      ///< the next smaller width with a whole number, if there is one
  double wider_m = 0.0;  ///< the next greater one
};
/// None for a surface without a regular part, and for a kind or values that `make_surface` refuses.
std::optional<SurfaceSeam> seam_of(std::string_view kind, const ParameterValues& values,
                                   const SurfaceCanvas& canvas);
/// With the names of the parameters.
Phrase text_of(const SurfaceSeam& seam);

/// A regular spacing (`spacing_m`) with fewer than eight samples, so that the interpolated surface differs from
/// the requested one: samples that lie symmetrically about a crest of a wave with n samples reach cos(π/n) of the
/// amplitude, 0.71 for four and 0 for two.
struct CoarseSamples {
  double spacing_m = 0.0;
  double pitch_m = 0.0;
  double samples = 0.0;  ///< per spacing
  double pixels = 0.0;   ///< that would suffice, per side
};
/// None as for `seam_of`.
std::optional<CoarseSamples> coarse_samples_of(std::string_view kind, const ParameterValues& values,
                                               const SurfaceCanvas& canvas);
/// With the names of the parameters.
Phrase text_of(const CoarseSamples& coarse);

}  // namespace asperity
