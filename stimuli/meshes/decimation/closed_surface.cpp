// Implements the adjacency of a closed mesh and its changes.

#include "stimuli/meshes/decimation/closed_surface.h"

#include <algorithm>
#include <array>

#include <OpenMesh/Core/System/omstream.hh>

namespace asperity::decimation {

ClosedSurface::ClosedSurface(const TriangleMesh& mesh)
    : points_(mesh.vertices_m), triangles_left_(mesh.triangles.size()) {
  using OpenMesh::VertexHandle;
  omerr().disable();  // first_fault replaces its output
  adjacency_.request_vertex_status();
  adjacency_.request_edge_status();
  adjacency_.request_halfedge_status();
  adjacency_.request_face_status();
  adjacency_.reserve(points_.size(), 3 * triangles_left_ / 2, triangles_left_);
  for (std::size_t i = 0; i < points_.size(); ++i) adjacency_.new_vertex();
  for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
    std::array<VertexHandle, 3> corners;
    std::transform(triangle.begin(), triangle.end(), corners.begin(),
                   [](std::uint32_t vertex) { return VertexHandle(static_cast<int>(vertex)); });
    if (adjacency_.add_face(corners.data(), corners.size()).is_valid()) continue;
    // At one of its vertices the other faces are a closed fan already, or they have its edge in the same direction.
    const auto full = std::find_if(corners.begin(), corners.end(), [this](VertexHandle vertex) {
      return !adjacency_.is_isolated(vertex) && !adjacency_.is_boundary(vertex);
    });
    first_fault_ = number_of(full != corners.end() ? *full : corners.front());
    return;
  }
  for (const auto half : adjacency_.halfedges()) {
    if (!adjacency_.is_boundary(half)) continue;
    first_fault_ = number_of(adjacency_.from_vertex_handle(half));
    return;
  }
}

bool ClosedSurface::can_collapse(std::uint32_t half,
                                 std::span<const std::uint32_t> neighbours) const {
  const std::uint32_t back = opposite(half);
  std::size_t common = 0;
  std::size_t others = 1;  // of the end: the start
  for (std::uint32_t spoke = turned(back); spoke != back; spoke = turned(spoke)) {
    ++others;
    if (std::find(neighbours.begin(), neighbours.end(), to(spoke)) != neighbours.end()) ++common;
  }
  const bool is_tetrahedron = neighbours.size() == 3 && others == 3;
  return common == 2 && !is_tetrahedron;
}

void ClosedSurface::collapse(std::uint32_t half) {
  adjacency_.collapse(half_edge(half));
  triangles_left_ -= 2;
}

ClosedSurface::Remaining ClosedSurface::remaining() const {
  Remaining result{};
  std::vector<std::uint32_t> moved(vertices(), 0);
  for (std::uint32_t vertex = 0; vertex < vertices(); ++vertex) {
    if (!exists(vertex)) continue;
    moved[vertex] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(vertex);
    result.mesh.vertices_m.push_back(point(vertex));
  }
  for (const auto face : adjacency_.faces()) {
    const auto first = adjacency_.halfedge_handle(face);
    const auto second = adjacency_.next_halfedge_handle(first);
    const auto corner = [&](OpenMesh::HalfedgeHandle side) {
      return moved[number_of(adjacency_.from_vertex_handle(side))];
    };
    result.mesh.triangles.push_back(
        {corner(first), corner(second), corner(adjacency_.next_halfedge_handle(second))});
  }
  return result;
}

}  // namespace asperity::decimation
