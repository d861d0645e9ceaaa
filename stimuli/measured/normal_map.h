// Declares the relief of a material scan: a displacement map and a normal map of the same surface.

#pragma once

#include <cstddef>
#include <string>

#include "stimuli/heights/height_field.h"
#include "stimuli/pictures/grey_image.h"
#include "stimuli/pictures/reflected_filter.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// The direction in which the y component of the normal, stored as green, increases: upwards in the picture (OpenGL) or
/// downwards (DirectX). The file does not state it.
enum class NormalConvention { opengl, directx };

/// The name: "opengl" or "directx".
const char* name_of(NormalConvention convention) noexcept;

/// The slopes ∂h/∂x (to the right) and ∂h/∂y (upwards) as real and imaginary parts, from colours of 0 to 1.
///
/// With n = 2 (R, G, B) − 1, the slopes are −n_x/n_z and −n_y/n_z. A normal that is less than 6° above the surface
/// (n_z < 0.1) counts as 0.1: a relief cannot contain overhangs.
ComplexPicture slopes_of_normal_map(const ColorPlanes& map, NormalConvention convention);

/// The heights, in units of the distance between pixels and with mean 0, whose slopes have the least squared difference
/// from the given ones [Frankot 1988].
///
/// With u = ∂h/∂x + i ∂h/∂y = (∂_x + i ∂_y) h and ∇² = (∂_x − i ∂_y)(∂_x + i ∂_y), the transform is
/// ĥ = −i (ν_x − i ν_y) û / (2π |ν|²). Its real part is the solution for the divergence of the slopes, the least-squares one; the
/// imaginary part is that of their curl, which no relief has, and is dropped. The mean slopes are subtracted first. The
/// picture is continued by reflection: ∂h/∂x is odd across, ∂h/∂y odd down.
GreyImage integrated_slopes(ComplexPicture slopes);

/// What the files of a material scan do not contain.
struct ScanRecipe {
  double width_m = 0.10;  ///< of the surface, from the left to the right edge of the pictures
  double height_range_m = 1e-3;           ///< from black to white in the displacement map
  double crossover_wavelength_m = 0.005;  ///< λ_c
  NormalConvention convention = NormalConvention::opengl;
};

inline constexpr double kDefaultCrossover_m = ScanRecipe{}.crossover_wavelength_m;

/// A relief from two maps, and how well they agree.
struct FusedRelief {
  HeightField field;
  /// Correlation of the heights from both maps between half and twice the crossover wavelength.
  double agreement = 0.0;
  double agreement_of_other_convention = 0.0;  ///< with the other convention of the normal map
  double amplitude_ratio =
      0.0;  ///< RMS of the heights from the normals over RMS of the displacements, in the same band
};

/// Merges the long waves of the displacement map with the short waves of the normal map:
///
///     ĥ = H ĥ_displacement + (1 − H) ĥ_normals,    H(ν) = exp(−½ ν² λ_c²)
///
/// The displacement map usually has few levels or little detail, and integrated normals accumulate errors in long waves.
/// The two filters add up to 1: a relief on which both maps agree is not changed. Mean 0.
///
/// Errors: std::invalid_argument that begins with a name or the name of a value: maps of different sizes or of fewer than
/// 16 pixels a side, a width, height range or crossover that is not positive, a pixel of more than 1 mm, a crossover
/// shorter than two pixels or longer than the width.
FusedRelief fused_relief(const GreyImage& displacement, const ColorPlanes& normals,
                         const ScanRecipe& recipe, const std::string& displacement_name,
                         const std::string& normals_name);

/// The parameters of the provenance of such a height field (docs/formats/height_field.md).
ParameterValues parameter_values(const ScanRecipe& recipe);

}  // namespace asperity
