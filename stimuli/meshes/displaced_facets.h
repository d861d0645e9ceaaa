// Declares the displaced surface of a textured mesh as a mesh of plain triangles.

#pragma once

#include <cstddef>

#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

struct FacetLimits {
  double longest_m = 0.3e-3;   ///< the side of a facet where the number of facets allows it
  std::size_t most = 600'000;  ///< facets
};

/// The facets of the displaced surface: every triangle of the mesh in n² facets, with the same n for all, so that
/// neighbours have the same points along their edge. n is the smallest number with which no side of a facet is longer
/// than `longest_m` or two texels, within the limit on the number of facets.
///
/// The corners of the facets lie on the displaced surface. Between them detail finer than two facets is lost.
TriangleMesh displaced_facets(const TexturedMesh& mesh, const FacetLimits& limits);

}  // namespace asperity
