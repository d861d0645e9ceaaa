// Declares the triangles of a body in the form of the sample loops: in the cells of a window.

#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "renderers/pd_gradient/geometry/contact_geometry.h"
#include "renderers/pd_gradient/loops/sample_loops.h"
#include "renderers/pd_gradient/sampling/packed_surface.h"

namespace asperity {

/// The transformation from a mesh to a window: x and y in cells from its first sample, z outwards in metres.
struct ToWindow {
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0};
  glm::dvec3 outwards{0.0};  ///< in the mesh's axes
  double cells_per_m = 0.0;
  double middle = 0.0;      ///< of the window, in cells
  double handedness = 1.0;  ///< −1 for A: with z against n the axes are left-handed
};

/// `outwards`: 1 for B, −1 for A.
ToWindow to_window(const Pose& pose, const ContactFrame& frame, const SamplingGrid& grid,
                   double outwards) noexcept;

/// The ends of a field, including its apron.
struct FieldEnds {
  int first = 0;
  int end = 0;
};

/// The inclination from which faces sink (sunk_m).
struct LeaningFaces {
  double cosine = 0.0;
  double window_m = 0.0;
};

/// nullopt for a face that faces away, is a wall, is not finite, or is far from the window. `texture_step_m` is that of
/// the surface's atlas.
std::optional<SampledTriangle> sampled_triangle(const PackedSurface::Triangle& triangle,
                                                const ToWindow& window, const FieldEnds& ends,
                                                const LeaningFaces& leaning,
                                                double texture_step_m) noexcept;

/// The number of floats from one row of samples to the next: odd multiples of 16, because rows at a distance of a power
/// of two would map to the same cache sets.
int stride_of_samples(int across) noexcept;

}  // namespace asperity
