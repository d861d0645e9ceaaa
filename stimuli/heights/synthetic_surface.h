// Surfaces with known heights, from formulas.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stimuli/heights/height_field.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// A kind of synthetic surface as the command line and a sidecar know it.
struct SurfaceDeclaration {
  std::string kind{};
  std::string summary{};
  std::vector<Parameter> parameters{};
};

/// Every kind there is: regular patterns (sinusoid, grating, cones), noise, and five materials
/// (metal, stone, wood, brick, sandpaper) that are composed of both and differ in the wavelengths
/// and the direction of their relief, so that each is recognised by a stroke along x.
std::vector<SurfaceDeclaration> synthetic_surfaces();

/// The square that is covered with the surface. The pitch is width_m/pixels.
struct SurfaceCanvas {
  double width_m = 0.10;
  std::size_t pixels = 1024;  ///< a side
  std::uint64_t seed = 1;     ///< of everything random in the surface
};

/// The surface of that kind; `values` may leave parameters to their defaults.
///
/// Every surface repeats without a seam under Tiling::repeat, those with a regular spacing where
/// the width is a whole number of spacings (brick: an even number of courses); the defaults are.
/// Another width is not stretched to fit: the seam then shows.
///
/// Errors: std::invalid_argument for a kind that is not there, values that their declarations
/// refuse, parameters that contradict each other, a width outside 1 mm to 1 m, fewer than 16 or
/// more than 8192 pixels, and a detail that is too fine for the pixels (under two of them).
HeightField make_surface(std::string_view kind, const ParameterValues& values,
                         const SurfaceCanvas& canvas);

/// Where a surface that is repeated would show a seam: a sentence with the width, how many of the
/// regular spacings it holds and the widths that hold whole ones. Nothing for a surface without a
/// regular spacing, and for a kind or values that `make_surface` refuses.
std::optional<std::string> seam_of(std::string_view kind, const ParameterValues& values,
                                   const SurfaceCanvas& canvas);

/// Fewer than eight samples for a regular spacing (`spacing_m`), where what lies between the samples
/// is no longer the surface that was asked for: of a wave of four the crests may be 0.71 of the
/// amplitude, of two they may be anything from nothing to 1. A sentence with the samples that there
/// are and the pixels that would be right; nothing as above.
std::optional<std::string> coarse_samples_of(std::string_view kind, const ParameterValues& values,
                                             const SurfaceCanvas& canvas);

}  // namespace asperity
