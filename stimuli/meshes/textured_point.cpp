// Implements the interpolation of displacements and points.

#include "stimuli/meshes/textured_point.h"

#include <algorithm>

namespace asperity {

double displacement_m(const DisplacementAtlas& atlas, const glm::dvec2& place) noexcept {
  // The last cell includes its upper limits: a position on the outermost centres accesses no texel outside.
  const auto column = std::min(static_cast<std::size_t>(place.x), atlas.columns - 2);
  const auto row = std::min(static_cast<std::size_t>(place.y), atlas.rows - 2);
  const double x = place.x - static_cast<double>(column);
  const double y = place.y - static_cast<double>(row);
  const std::int16_t* above = atlas.values.data() + row * atlas.columns + column;
  const std::int16_t* below = above + atlas.columns;
  return atlas.step_m * ((1.0 - y) * ((1.0 - x) * above[0] + x * above[1]) +
                         y * ((1.0 - x) * below[0] + x * below[1]));
}

glm::dvec3 textured_point_m(const TexturedMesh& mesh, std::size_t triangle,
                            const glm::dvec3& barycentric) noexcept {
  glm::dvec3 point_m{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec2 place{0.0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = barycentric[static_cast<int>(i)];
    const std::uint32_t corner = mesh.triangles[triangle][i];
    point_m += weight * mesh.vertices_m[corner];
    normal += weight * mesh.normals[corner];
    place += weight * mesh.places[triangle][i];
  }
  return point_m + displacement_m(mesh.atlas, place) * normal;
}

}  // namespace asperity
