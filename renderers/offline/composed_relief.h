// What a tool meets of a surface: two textured bodies as one relief under a point.

#pragma once

#include <glm/vec3.hpp>

#include "stimuli/heights/height_field.h"
#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// A body, its displacements `gain` times as large.
struct GainedBody {
  const TexturedMesh& mesh;
  double gain = 1.0;
};

/// Where the tool's tip goes: a straight stroke about the middle of the surface's own frame.
struct TipStroke {
  double length_m = 0.0;
  double direction_rad = 0.0;  ///< from +x towards +y
  double cell_m = 1e-4;        ///< distance of the samples of the bodies
  double pitch_m = 0.0;  ///< of the relief's: as many whole cells as come near to it, one at least
};

/// How high the tip of a tool stands that never turns and just touches the surface:
///
///   H(x) = max over D of ( h_S(x + r) − h_T(r) )
///
/// with r across z from the tip [m], h_S the height of the surface's upper side, h_T that of the tool's lower side
/// above its tip, both with their textures, D where both are. A tool whose tip is at (x, z) is as deep along z as a
/// point at (x, z) is in the relief, δ = H(x) − z: the depth of pd_gradient where n is z, and its gradient across n.
/// It is the dilation of the surface by the tool turned upside down, what a stylus does to a profile.
///
/// A point as a tool leaves the surface as it is. Two gratings a·cos κx and b·cos κx become
/// √(a² + b² + 2ab·cos κx), where they are long; of two whose lengths have no common multiple nothing is left but
/// their sum.
///
/// Between samples the place where they meet first is found by parabolas along and across the stroke. The answer's x
/// is along the stroke, its origin in the middle; its few rows are as far apart as its columns. Of a long stroke it
/// is the middle `kMostColumns` samples; a wide tool is sampled `kMostAcross` times across and a
/// long stroke `kMostAlong` times along, further apart than asked.
///
/// Limits: contacts whose n leans, of a surface that is not level or a tool that is led askew, are others.
///
/// Errors: std::invalid_argument for a length or cell that is not positive, a gain that is negative or no number, a
/// mesh that is none (contact_geometry.h), and where the tool finds no surface under it in the middle. Where the
/// surface ends before the stroke does, so does the relief.
HeightField composed_relief(const GainedBody& tool, const GainedBody& surface,
                            const TipStroke& stroke);

inline constexpr int kMostColumns = 1000;
inline constexpr int kMostAcross = 400;
inline constexpr int kMostAlong = 4000;

}  // namespace asperity
