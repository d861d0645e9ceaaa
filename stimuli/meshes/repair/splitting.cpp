// Gives each fan around a vertex a separate vertex, and divides edges with the same ends.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity::mesh_repair {
namespace {

// Divides a triangle with vertices in the middle of some of its sides.
void divide(Triangle corners, Triangle middles, std::vector<Triangle>& into) {
  const auto count = std::count_if(middles.begin(), middles.end(),
                                   [](std::uint32_t middle) { return middle != kNone; });
  // After that one is on the first side, two are on the first two.
  while ((count == 1 && middles[0] == kNone) || (count == 2 && middles[2] != kNone)) {
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    std::rotate(middles.begin(), middles.begin() + 1, middles.end());
  }
  const auto [a, b, c] = corners;
  const auto [ab, bc, ca] = middles;
  if (count == 0) {
    into.push_back(corners);
  } else if (count == 1) {
    into.insert(into.end(), {{a, ab, c}, {ab, b, c}});
  } else if (count == 2) {
    into.insert(into.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
  } else {
    into.insert(into.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
  }
}

}  // namespace

// Gives each fan of connected faces around a vertex a separate vertex.
void split_vertices(MeshInRepair& repair) {
  const auto corners = static_cast<std::uint32_t>(repair.partner.size());
  Sets fans(corners);
  for (std::uint32_t half = 0; half < corners; ++half) {
    const std::uint32_t other = repair.partner[half];
    if (other == kNone || other < half) continue;
    fans.join(half, next_half_edge(other));  // paired half-edges run in opposite directions
    fans.join(next_half_edge(half), other);
  }
  std::vector<glm::dvec3> vertices_m{};
  std::vector<std::uint32_t> name_of_fan(corners, kNone);
  std::vector<char> seen(repair.mesh.vertices_m.size(), 0);
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    std::uint32_t& vertex = repair.mesh.triangles[corner / 3][corner % 3];
    std::uint32_t& name = name_of_fan[fans.of(corner)];
    if (name == kNone) {
      name = static_cast<std::uint32_t>(vertices_m.size());
      vertices_m.push_back(repair.mesh.vertices_m[vertex]);
      repair.found.vertices_split += static_cast<std::size_t>(seen[vertex]);
      seen[vertex] = 1;
    }
    vertex = name;
  }
  repair.mesh.vertices_m = std::move(vertices_m);
}

// Where bodies touch along an edge and are connected at both its ends, two edges still have the same ends. All but one of
// them get a vertex in the middle.
void divide_double_edges(MeshInRepair& repair) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges(repair.partner.size());
  for (std::uint32_t half = 0; half < edges.size(); ++half) {
    edges[half] = {edge_key(repair.from(half), repair.to(half)), half};
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::uint32_t> middles(repair.partner.size(), kNone);
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
    const std::uint32_t first = edges[begin].second;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const std::uint32_t half = edges[i].second;
      if (half == repair.partner[first] || middles[half] != kNone) continue;
      middles[half] = static_cast<std::uint32_t>(repair.mesh.vertices_m.size());
      if (repair.partner[half] != kNone) middles[repair.partner[half]] = middles[half];
      repair.mesh.vertices_m.push_back(0.5 * (repair.mesh.vertices_m[repair.from(half)] +
                                              repair.mesh.vertices_m[repair.to(half)]));
      ++repair.found.edges_divided;
    }
  }
  if (repair.found.edges_divided == 0) return;
  std::vector<Triangle> divided{};
  for (std::size_t face = 0; face < repair.mesh.triangles.size(); ++face) {
    divide(repair.mesh.triangles[face],
           {middles[3 * face], middles[3 * face + 1], middles[3 * face + 2]}, divided);
  }
  repair.mesh.triangles = std::move(divided);
  repair.partner = opposite_half_edges(repair.mesh.triangles);
}

}  // namespace asperity::mesh_repair
