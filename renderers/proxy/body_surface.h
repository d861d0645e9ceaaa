// Declares the surface of a body as a point that touches it needs it.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/meshes/surface_search.h"
#include "stimuli/meshes/textured_mesh.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Stores the facets of a body's displaced surface with the normals of its vertices, the neighbours of each facet and a
/// search tree: what SurfaceProxy reads in a tick. One surface serves any number of proxies.
///
/// The normals are those of the displaced surface, weighted by the angles of the facets. Between the corners of a facet
/// they are interpolated, so that they have no steps at its edges; a sharp edge is as round as the facets beside it are
/// wide.
///
/// Units and frame: metres, in the body's own frame.
///
/// Errors: std::invalid_argument for a mesh without triangles, with a corner that is not a vertex, or with a coordinate that
/// is not finite.
///
/// Threads: any number at a time after construction.
class BodySurface final {
 public:
  /// The displaced surface in facets (displaced_facets.h): at most 600 000, or the triangles of a mesh that has more.
  explicit BodySurface(const TexturedMesh& mesh);
  explicit BodySurface(TriangleMesh facets);
  BodySurface(const BodySurface&) = delete;
  BodySurface& operator=(const BodySurface&) = delete;

  std::size_t facets() const noexcept { return mesh_.triangles.size(); }
  const std::array<std::uint32_t, 3>& corners(std::uint32_t facet) const noexcept {
    return mesh_.triangles[facet];
  }
  const glm::dvec3& vertex_m(std::uint32_t vertex) const noexcept {
    return mesh_.vertices_m[vertex];
  }
  const glm::dvec3& normal(std::uint32_t vertex) const noexcept { return normals_[vertex]; }
  /// The facet beyond the side opposite to a corner; kNoHalfEdge (mesh_edges.h) at the end of an open surface.
  std::uint32_t beyond(std::uint32_t facet, std::size_t corner) const noexcept;
  /// The facets that have a vertex as a corner.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const noexcept {
    return std::span(around_).subspan(first_around_[vertex],
                                      first_around_[vertex + 1] - first_around_[vertex]);
  }
  const SurfaceSearch& search() const noexcept { return search_; }

 private:
  TriangleMesh mesh_{};
  std::vector<glm::dvec3> normals_{};
  std::vector<std::uint32_t> opposite_{};      ///< by half-edge
  std::vector<std::uint32_t> first_around_{};  ///< by vertex: its first place in `around_`
  std::vector<std::uint32_t> around_{};        ///< facets
  SurfaceSearch search_;                       ///< keeps a reference to `mesh_`
};

}  // namespace asperity
