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

/// States that a repeated surface would have a seam: a sentence with the width, the number of
/// regular spacings in it and the widths with whole numbers. Empty for a surface without a seam or without a
/// regular spacing, and for a kind or values that `make_surface` refuses.
std::optional<std::string> seam_of(std::string_view kind, const ParameterValues& values,
                                   const SurfaceCanvas& canvas);

/// States that a regular spacing (`spacing_m`) has fewer than eight samples, so that the interpolated surface differs from
/// the requested one: samples that lie symmetrically about a crest of a wave with n samples reach cos(π/n) of the
/// amplitude, 0.71 for four and 0 for two. A sentence with the number of samples and the pixels that would suffice;
/// empty as for `seam_of`.
std::optional<std::string> coarse_samples_of(std::string_view kind, const ParameterValues& values,
                                             const SurfaceCanvas& canvas);

}  // namespace asperity
