// Joins equal vertices, leaves out degenerate and double faces, and refuses unsuitable sizes.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "analysis/numbers/number_text.h"
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

/// Keeps faces that were left out as the backs of others where their edges need them: each edge of two solids that touch in
/// a face has as many faces that run one way as the other, and with one of the two faces alone it has not. A surface whose
/// every face is doubled by its back is balanced without the backs. A face that is kept changes the balance of its edges, so
/// that others can be needed in turn.
void keep_needed_backs(const std::vector<Triangle>& triangles, std::vector<std::uint32_t> backs,
                       std::vector<char>& again) {
  if (backs.empty()) return;
  // How many faces run from the edge's lower vertex to its higher one, less those that run the other way.
  struct Balance {
    int of_all = 0;  ///< of the kept faces and all backs
    int of_kept = 0;
  };
  std::unordered_map<std::uint64_t, Balance> balances{};  // of the edges of backs
  const auto add = [&](std::uint32_t face, int Balance::*count) {
    const Triangle& t = triangles[face];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t from = t[corner];
      const std::uint32_t to = t[(corner + 1) % 3];
      const auto edge = balances.find(edge_key(from, to));
      if (edge != balances.end()) edge->second.*count += from < to ? 1 : -1;
    }
  };
  for (const std::uint32_t back : backs) {
    const Triangle& t = triangles[back];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      balances.try_emplace(edge_key(t[corner], t[(corner + 1) % 3]));
    }
  }
  for (const std::uint32_t back : backs) add(back, &Balance::of_all);
  for (std::uint32_t face = 0; face < triangles.size(); ++face) {
    if (again[face] != 0) continue;
    add(face, &Balance::of_all);
    add(face, &Balance::of_kept);
  }
  const auto is_needed = [&](std::uint32_t back) {
    const Triangle& t = triangles[back];
    bool is_unbalanced_without = false;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Balance& balance = balances.at(edge_key(t[corner], t[(corner + 1) % 3]));
      if (balance.of_all != 0) return false;
      is_unbalanced_without = is_unbalanced_without || balance.of_kept != 0;
    }
    return is_unbalanced_without;
  };
  for (;;) {
    const auto needed = std::stable_partition(backs.begin(), backs.end(), std::not_fn(is_needed));
    if (needed == backs.end()) return;
    for (auto back = needed; back != backs.end(); ++back) {
      again[*back] = 0;
      add(*back, &Balance::of_kept);
    }
    backs.erase(needed, backs.end());
  }
}

/// Whether two faces with the same corners run around them in the same order.
bool run_alike(const Triangle& one, const Triangle& other) {
  const auto first = std::find(other.begin(), other.end(), one[0]) - other.begin();
  return other[static_cast<std::size_t>(first + 1) % 3] == one[1];
}

// Leaves out faces with two equal corners, and all but the first with the same three; the first that runs the other way
// remains where two solids touch in it.
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
  std::vector<std::uint32_t> backs{};
  std::size_t first = 0;
  bool has_back = false;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (corners[i].first != corners[first].first) {
      first = i;
      has_back = false;
      continue;
    }
    const std::uint32_t face = corners[i].second;
    again[face] = 1;
    if (!has_back && !run_alike(triangles[face], triangles[corners[first].second])) {
      backs.push_back(face);
      has_back = true;
    }
  }
  keep_needed_backs(triangles, std::move(backs), again);
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
