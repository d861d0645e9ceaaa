// Declares the composed relief: two textured bodies as one relief under a point.

#pragma once

#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// A body whose displacements are multiplied by `gain`.
struct GainedBody {
  const TexturedMesh& mesh;
  double gain = 1.0;
};

/// The path of the tool's tip: a straight stroke, centred in the surface's own frame.
struct TipStroke {
  double length_m = 0.0;
  double direction_rad = 0.0;  ///< from +x towards +y
  double cell_m = 1e-4;        ///< sample spacing of the bodies
  double pitch_m = 0.0;        ///< of the relief: rounded to a whole number of cells, at least one
};

/// Computes the height of the tip of a non-rotating tool that just touches the surface:
///
///   H(x) = max over D of ( h_S(x + r) − h_T(r) )
///
/// r is perpendicular to z, from the tip [m]; h_S is the height of the surface's upper side and h_T that of the tool's
/// lower side above its tip, both with their textures; D is the region where both exist. The depth along z of a tool
/// with its tip at (x, z) equals the depth of a point at (x, z) in the relief, δ = H(x) − z: the depth of pd_gradient
/// for n = z, with the same gradient perpendicular to n. H is the dilation of the surface by the inverted tool, the
/// transformation of a profile by a stylus.
///
/// A point as the tool leaves the surface unchanged. Two long gratings a·cos κx and b·cos κx give
/// √(a² + b² + 2ab·cos κx); two whose wavelengths have no common multiple give a constant, the sum of the amplitudes.
///
/// Between samples the first contact point is found by parabolas along and across the stroke. The result's x is along
/// the stroke, with its origin in the middle; its rows have the same spacing as its columns. A long stroke is reduced
/// to the middle `kMostColumns` samples; a wide tool is sampled at `kMostAcross` points across and a long stroke at
/// `kMostAlong` points along, with a larger spacing than requested.
///
/// Limits: contacts with an inclined n, of a surface that is not level or a tool that is tilted, differ.
///
/// Errors: std::invalid_argument for a length or cell that is not positive, a gain that is negative or not a number, an
/// invalid mesh (contact_geometry.h), and if there is no surface under the tool in the middle. If the surface ends
/// before the stroke does, the relief ends there.
HeightField composed_relief(const GainedBody& tool, const GainedBody& surface,
                            const TipStroke& stroke);

inline constexpr int kMostColumns = 1000;
inline constexpr int kMostAcross = 400;
inline constexpr int kMostAlong = 4000;

}  // namespace asperity
