// How far a simplified mesh lies from the original, with its texture and without.

#pragma once

#include <cstddef>
#include <vector>

#include "stimuli/meshes/side_by_side.h"
#include "stimuli/meshes/surface_search.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Of the distances of points of the original.
struct GeometricError {
  double rms_m = 0.0;
  double max_m = 0.0;
};

/// `count` points spread evenly over the surface, the same ones every time.
std::vector<glm::dvec3> surface_samples(const TriangleMesh& mesh, std::size_t count);

/// How far each point lies from the nearest place of the mesh that `search` is on.
GeometricError plain_error(const std::vector<glm::dvec3>& samples_m, const SurfaceSearch& search,
                           const Workers& workers);

/// How far each point lies from the displaced surface.
///
/// The surface is taken as triangles between texels. Of those near the place that is nearest to the
/// point where every face is displaced in at most 32 rows of triangles, and near the one that the point lies
/// over along the interpolated normals from there, the nearest one counts; so a distance is never told
/// too small.
GeometricError textured_error(const std::vector<glm::dvec3>& samples_m, const TexturedMesh& mesh,
                              const Workers& workers);

}  // namespace asperity
