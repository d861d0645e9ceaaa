// Declares the atlas of textured meshes: patches of right triangles, two to a block.

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The displacement of a triangle at texel (i, j): at corner 1 for (n, 0), at corner 2 for (0, n).
using TexelSource = std::function<double(std::uint32_t triangle, int i, int j)>;

/// The approximate number of texels of an atlas for patches with these texels along a side.
std::size_t atlas_texels(const std::vector<int>& sides);

/// Places the triangles of `mesh` in an atlas and fills it: interior texels from `source`, margins by continuation.
/// `sides` are the texels along the sides of each triangle's patch, at least 1.
void fill_atlas(TexturedMesh& mesh, const std::vector<int>& sides, const TexelSource& source);

/// The unit normal of each vertex, weighted by the angles of its faces; if it lies behind a face, it is rotated until
/// it is in front of all faces, if possible.
std::vector<glm::dvec3> vertex_normals(const std::vector<glm::dvec3>& vertices_m,
                                       const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace asperity
