#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/number_text.h"
#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity::mesh_repair {
namespace {

constexpr double kShortestDiagonal_m = 1e-4;
constexpr double kLongestDiagonal_m = 10.0;

// Refuses a mesh that lies in the plane of its largest face.
void refuse_flat(const MeshInRepair& repair) {
  glm::dvec3 largest{0.0};
  glm::dvec3 in_plane_m{0.0};
  for (const Triangle& triangle : repair.mesh.triangles) {
    const glm::dvec3& a_m = repair.mesh.vertices_m[triangle[0]];
    const glm::dvec3 doubled = glm::cross(repair.mesh.vertices_m[triangle[1]] - a_m,
                                          repair.mesh.vertices_m[triangle[2]] - a_m);
    if (glm::dot(doubled, doubled) > glm::dot(largest, largest)) {
      largest = doubled;
      in_plane_m = a_m;
    }
  }
  if (glm::dot(largest, largest) > 0.0) {
    const glm::dvec3 normal = glm::normalize(largest);
    for (const Triangle& triangle : repair.mesh.triangles) {
      for (const std::uint32_t vertex : triangle) {
        const double above_m = glm::dot(repair.mesh.vertices_m[vertex] - in_plane_m, normal);
        if (std::abs(above_m) > kFlat * repair.found.diagonal_m) return;
      }
    }
  }
  repair.refuse_nothing_inside();
}

}  // namespace

void refuse_not_finite(const MeshInRepair& repair) {
  for (const Triangle& triangle : repair.mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      const glm::dvec3& point_m = repair.mesh.vertices_m[vertex];
      if (!std::isfinite(point_m.x + point_m.y + point_m.z)) {
        repair.refuse(
            "has a vertex, number " + std::to_string(vertex + 1ULL) +
            ", with a coordinate that is not a finite number; its place cannot be determined. "
            "Correct it in the program that made the mesh.");
      }
    }
  }
}

// Vertices with the same coordinates become the first of them.
void weld(MeshInRepair& repair) {
  std::vector<std::uint32_t> order(repair.mesh.vertices_m.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  const std::vector<glm::dvec3>& points_m = repair.mesh.vertices_m;
  // Vertices without a face may be NaN, which cannot be ordered.
  std::vector<char> used(points_m.size(), 0);
  for (const Triangle& triangle : repair.mesh.triangles) {
    for (const std::uint32_t vertex : triangle) used[vertex] = 1;
  }
  std::erase_if(order, [&](std::uint32_t vertex) { return used[vertex] == 0; });
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const glm::dvec3& p = points_m[a];
    const glm::dvec3& q = points_m[b];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    if (p.z != q.z) return p.z < q.z;
    return a < b;
  });
  std::vector<std::uint32_t> representative(points_m.size(), kNone);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && points_m[order[i]] == points_m[order[i - 1]];
    representative[order[i]] = same ? representative[order[i - 1]] : order[i];
    if (same) ++repair.found.vertices_welded;
  }
  for (Triangle& triangle : repair.mesh.triangles) {
    for (std::uint32_t& vertex : triangle) vertex = representative[vertex];
  }
}

// Leaves out faces with two equal corners, and all but the first with the same three.
void leave_out_bad_faces(MeshInRepair& repair) {
  std::vector<Triangle>& triangles = repair.mesh.triangles;
  repair.found.degenerate_faces = std::erase_if(
      triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  std::vector<std::pair<Triangle, std::uint32_t>> corners(triangles.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    corners[i] = {triangles[i], i};
    std::sort(corners[i].first.begin(), corners[i].first.end());
  }
  std::sort(corners.begin(), corners.end());
  std::vector<char> again(triangles.size(), 0);
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].first == corners[i - 1].first) again[corners[i].second] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (again[i] == 0) triangles[kept++] = triangles[i];
  }
  repair.found.duplicate_faces = triangles.size() - kept;
  triangles.resize(kept);
  if (kept == 0)
    repair.refuse("has no face whose three vertices differ in position. Export the mesh again.");
}

// Measures the bounding box, and refuses a mesh that is too small, too large or flat.
void measure(MeshInRepair& repair) {
  Box box{};
  for (const Triangle& triangle : repair.mesh.triangles) {
    for (const std::uint32_t vertex : triangle) box.add(repair.mesh.vertices_m[vertex]);
  }
  repair.found.diagonal_m = box.diagonal_m();
  if (repair.found.diagonal_m < kShortestDiagonal_m ||
      repair.found.diagonal_m > kLongestDiagonal_m) {
    repair.refuse(
        "has a bounding box with a diagonal of " + number_text(repair.found.diagonal_m) +
        " m; an object to be explored measures "
        "between 0.0001 m and 10 m. Mesh files do not state their unit: enter the length of "
        "one unit in metres.");
  }
  refuse_flat(repair);
}

}  // namespace asperity::mesh_repair
