// Implements the preparation of a body's surface.

#include "renderers/proxy/body_surface.h"

#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "stimuli/meshes/displaced_facets.h"
#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/texture_atlas.h"

namespace asperity {
namespace {

TriangleMesh checked(TriangleMesh mesh) {
  for (const glm::dvec3& vertex_m : mesh.vertices_m) {
    if (std::isfinite(vertex_m.x + vertex_m.y + vertex_m.z)) continue;
    throw std::invalid_argument("a vertex of the body is not finite; repair the mesh");
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner < mesh.vertices_m.size()) continue;
      throw std::invalid_argument("a triangle of the body refers to vertex " +
                                  std::to_string(corner) +
                                  "; it must be less than the number of vertices, " +
                                  std::to_string(mesh.vertices_m.size()));
    }
  }
  return mesh;
}

}  // namespace

BodySurface::BodySurface(const TexturedMesh& mesh)
    : BodySurface(displaced_facets(mesh, FacetLimits{})) {}

BodySurface::BodySurface(TriangleMesh facets)
    : mesh_(checked(std::move(facets))),
      normals_(vertex_normals(mesh_.vertices_m, mesh_.triangles)),
      opposite_(opposite_half_edges(mesh_.triangles)),
      first_around_(mesh_.vertices_m.size() + 1, 0),
      around_(3 * mesh_.triangles.size()),
      search_(mesh_) {
  for (const auto& triangle : mesh_.triangles) {
    for (const std::uint32_t corner : triangle) ++first_around_[corner + 1];
  }
  std::partial_sum(first_around_.begin(), first_around_.end(), first_around_.begin());
  std::vector<std::uint32_t> next(first_around_.begin(), std::prev(first_around_.end()));
  for (std::uint32_t facet = 0; facet < mesh_.triangles.size(); ++facet) {
    for (const std::uint32_t corner : mesh_.triangles[facet]) around_[next[corner]++] = facet;
  }
}

std::uint32_t BodySurface::beyond(std::uint32_t facet, std::size_t corner) const noexcept {
  const std::uint32_t half = opposite_[3 * facet + (corner + 1) % 3];
  return half == kNoHalfEdge ? kNoHalfEdge : half / 3;
}

}  // namespace asperity
