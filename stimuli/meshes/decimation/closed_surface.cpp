// Implements the adjacency of a closed mesh and its changes.

#include "stimuli/meshes/decimation/closed_surface.h"

#include <algorithm>

namespace asperity::decimation {

ClosedSurface::ClosedSurface(const TriangleMesh& mesh)
    : faces_(mesh.triangles.size()),
      points_(mesh.vertices_m),
      half_of_(mesh.vertices_m.size(), kNoHalfEdge),
      triangles_left_(mesh.triangles.size()) {
  const std::vector<std::uint32_t> opposite = opposite_half_edges(mesh.triangles);
  for (std::uint32_t half = 0; half < opposite.size(); ++half) {
    Face& face = faces_[half / 3];
    face.corners[half % 3] = mesh.triangles[half / 3][half % 3];
    face.opposite[half % 3] = opposite[half];
    half_of_[face.corners[half % 3]] = half;
  }
}

std::optional<std::uint32_t> ClosedSurface::first_fault() const {
  std::vector<std::uint32_t> faces_at(vertices(), 0);
  for (std::uint32_t half = 0; half < 3 * faces_.size(); ++half) {
    ++faces_at[from(half)];
    const std::uint32_t across = opposite(half);
    if (across == kNoHalfEdge || from(across) != to(half)) return from(half);
  }
  for (std::uint32_t vertex = 0; vertex < vertices(); ++vertex) {
    if (!exists(vertex)) continue;
    std::uint32_t half = half_of(vertex);
    do {
      half = turned(half);
      --faces_at[vertex];
    } while (half != half_of(vertex));
    if (faces_at[vertex] != 0) return vertex;
  }
  return std::nullopt;
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
  const std::uint32_t removed = from(half);
  const std::uint32_t kept = to(half);
  const std::uint32_t back = opposite(half);
  for (std::uint32_t spoke = turned(half); spoke != half; spoke = turned(spoke)) {
    faces_[spoke / 3].corners[spoke % 3] = kept;
  }
  // The two faces at the edge disappear: their other sides fall on one another.
  const std::uint32_t left_out = opposite(next_half_edge(half));
  const std::uint32_t left_in = turned(half);
  const std::uint32_t right_in = opposite(next_half_edge(back));
  const std::uint32_t right_out = turned(back);
  set_opposite(left_out, left_in);
  set_opposite(right_in, right_out);
  half_of_[from(left_out)] = left_out;
  half_of_[from(right_in)] = right_in;
  half_of_[kept] = left_in;
  half_of_[removed] = kNoHalfEdge;
  faces_[half / 3].opposite.fill(kNoHalfEdge);
  faces_[back / 3].opposite.fill(kNoHalfEdge);
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
  for (const Face& face : faces_) {
    if (face.opposite[0] == kNoHalfEdge) continue;
    result.mesh.triangles.push_back(
        {moved[face.corners[0]], moved[face.corners[1]], moved[face.corners[2]]});
  }
  return result;
}

}  // namespace asperity::decimation
