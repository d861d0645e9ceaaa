// Declares the distance of a simplified mesh from the original, with and without its texture.

#pragma once

#include <cstddef>
#include <vector>

#include "stimuli/meshes/side_by_side.h"
#include "stimuli/meshes/surface_search.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Statistics of the distances of points of the original.
struct GeometricError {
  double rms_m = 0.0;
  double max_m = 0.0;
};

/// Returns `count` points, evenly distributed over the surface and the same at every call.
std::vector<glm::dvec3> surface_samples(const TriangleMesh& mesh, std::size_t count);

/// The distances of the points from the mesh of `search`.
GeometricError plain_error(const std::vector<glm::dvec3>& samples_m, const SurfaceSearch& search,
                           const Workers& workers);

/// The distances of the points from the displaced surface.
///
/// The surface consists of triangles between texels. For each point, two neighbourhoods are searched: that of the
/// nearest point on the surface with each face displaced in at most 32 rows of triangles, and that of the position
/// under the point along the interpolated normals from there. The smaller distance is used; a distance is therefore
/// never underestimated.
GeometricError textured_error(const std::vector<glm::dvec3>& samples_m, const TexturedMesh& mesh,
                              const Workers& workers);

}  // namespace asperity
