// Declares a closed triangle mesh whose edges can be collapsed.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <glm/vec3.hpp>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity::decimation {

/// A closed mesh with the adjacency of its half-edges (OpenMesh), which remains up to date while edges are collapsed.
///
/// A collapse removes one vertex and two triangles; the numbers of the others do not change, and vertices do not move.
/// kNoHalfEdge of mesh_edges.h stands for none.
///
/// Threads: the const functions can be called from any number of threads at a time.
class ClosedSurface final {
 public:
  /// Takes a mesh in which the faces at each vertex form one closed fan, see `first_fault`.
  explicit ClosedSurface(const TriangleMesh& mesh);

  /// A vertex whose faces do not form one closed fan: the mesh was not closed, and nothing else may be called.
  std::optional<std::uint32_t> first_fault() const { return first_fault_; }

  std::size_t triangles() const { return triangles_left_; }
  std::size_t vertices() const { return points_.size(); }  ///< including the removed ones
  /// Whether a vertex has faces: it was not removed.
  bool exists(std::uint32_t vertex) const { return half_of(vertex) != kNoHalfEdge; }
  const glm::dvec3& point(std::uint32_t vertex) const { return points_[vertex]; }

  std::uint32_t from(std::uint32_t half) const {
    return number_of(adjacency_.from_vertex_handle(half_edge(half)));
  }
  std::uint32_t to(std::uint32_t half) const {
    return number_of(adjacency_.to_vertex_handle(half_edge(half)));
  }
  std::uint32_t opposite(std::uint32_t half) const {
    return number_of(adjacency_.opposite_halfedge_handle(half_edge(half)));
  }
  /// One of the half-edges that begin at a vertex.
  std::uint32_t half_of(std::uint32_t vertex) const {
    return number_of(adjacency_.halfedge_handle(OpenMesh::VertexHandle(static_cast<int>(vertex))));
  }
  /// The next half-edge that begins at the same vertex, counter-clockwise.
  std::uint32_t turned(std::uint32_t half) const {
    return number_of(adjacency_.ccw_rotated_halfedge_handle(half_edge(half)));
  }

  /// Whether the surface remains closed without new contacts if the start of a half-edge is moved to its end: both have
  /// exactly two common neighbours, and the part is not a tetrahedron. `neighbours` are those of the start.
  bool can_collapse(std::uint32_t half, std::span<const std::uint32_t> neighbours) const;
  /// Moves the start of a half-edge to its end. Requires can_collapse.
  void collapse(std::uint32_t half);

  /// The remaining mesh in the order of the given one, and for each of its vertices the number here.
  struct Remaining {
    TriangleMesh mesh{};
    std::vector<std::uint32_t> vertices{};
  };
  Remaining remaining() const;

 private:
  static OpenMesh::HalfedgeHandle half_edge(std::uint32_t half) {
    return OpenMesh::HalfedgeHandle(static_cast<int>(half));
  }
  static std::uint32_t number_of(OpenMesh::BaseHandle handle) {
    return static_cast<std::uint32_t>(handle.idx());
  }

  OpenMesh::TriConnectivity adjacency_{};
  std::vector<glm::dvec3> points_{};
  std::size_t triangles_left_ = 0;
  std::optional<std::uint32_t> first_fault_{};
};

}  // namespace asperity::decimation
