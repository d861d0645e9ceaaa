// Inside the making of textured meshes: patches of right triangles, two to a block, in one atlas.

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The displacement of a triangle at texel (i, j): at corner 1 for (n, 0), at corner 2 for (0, n).
using TexelSource = std::function<double(std::uint32_t triangle, int i, int j)>;

/// How many texels an atlas takes for patches with so many texels along a side, about.
std::size_t atlas_texels(const std::vector<int>& sides);

/// Places the triangles of `mesh` in an atlas and fills it: texels within from `source`, margins
/// continued. `sides` are the texels along the sides of each triangle's patch, at least 1.
void fill_atlas(TexturedMesh& mesh, const std::vector<int>& sides, const TexelSource& source);

/// The unit normal of each vertex, weighted by the angles of its faces; where a face would be seen
/// from behind along it, turned until it is not, if it can be.
std::vector<glm::dvec3> vertex_normals(const std::vector<glm::dvec3>& vertices_m,
                                       const std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace asperity
