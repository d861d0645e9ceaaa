// Declares a closed triangle mesh whose edges can be collapsed.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity::decimation {

/// A closed mesh with the adjacency of its half-edges, which remains up to date while edges are collapsed.
///
/// Half-edges are numbered as in mesh_edges.h. A collapse removes one vertex and two triangles; the numbers of the
/// others do not change, and vertices do not move.
///
/// Threads: the const functions can be called from any number of threads at a time.
class ClosedSurface final {
 public:
  /// Takes a mesh in which the faces at each vertex form one closed fan, see `first_fault`.
  explicit ClosedSurface(const TriangleMesh& mesh);

  /// A vertex whose faces do not form one closed fan: the mesh was not closed, and nothing else may be called.
  std::optional<std::uint32_t> first_fault() const;

  std::size_t triangles() const { return triangles_left_; }
  std::size_t vertices() const { return half_of_.size(); }  ///< including the removed ones
  /// Whether a vertex has faces: it was not removed.
  bool exists(std::uint32_t vertex) const { return half_of_[vertex] != kNoHalfEdge; }
  const glm::dvec3& point(std::uint32_t vertex) const { return points_[vertex]; }

  std::uint32_t from(std::uint32_t half) const { return faces_[half / 3].corners[half % 3]; }
  std::uint32_t to(std::uint32_t half) const {
    const std::uint32_t corner = half % 3;
    return faces_[half / 3].corners[corner == 2 ? 0 : corner + 1];
  }
  std::uint32_t opposite(std::uint32_t half) const { return faces_[half / 3].opposite[half % 3]; }
  /// One of the half-edges that begin at a vertex.
  std::uint32_t half_of(std::uint32_t vertex) const { return half_of_[vertex]; }
  /// The next half-edge that begins at the same vertex, counter-clockwise.
  std::uint32_t turned(std::uint32_t half) const {
    const std::uint32_t corner = half % 3;
    return faces_[half / 3].opposite[corner == 0 ? 2 : corner - 1];
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
  /// Together in memory, because both are needed in order to walk around a vertex.
  struct Face {
    std::array<std::uint32_t, 3> corners{};
    std::array<std::uint32_t, 3> opposite{};
  };

  void set_opposite(std::uint32_t one, std::uint32_t other) {
    faces_[one / 3].opposite[one % 3] = other;
    faces_[other / 3].opposite[other % 3] = one;
  }

  std::vector<Face> faces_{};  ///< a removed one has no opposite half-edges
  std::vector<glm::dvec3> points_{};
  std::vector<std::uint32_t> half_of_{};
  std::size_t triangles_left_ = 0;
};

}  // namespace asperity::decimation
