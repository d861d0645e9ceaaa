// Pairs half-edges at edges of two or more faces, and turns faces to agree with their neighbours.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "stimuli/meshes/repair/mesh_in_repair.h"

namespace asperity::mesh_repair {
namespace {

void join_faces(MeshInRepair& repair, std::uint32_t one, std::uint32_t other) {
  repair.partner[one] = other;
  repair.partner[other] = one;
}

}  // namespace

// Pairs the half-edges of each edge of two faces; those of three or more form a crowd.
void pair_at_edges(MeshInRepair& repair) {
  const auto halves = static_cast<std::uint32_t>(3 * repair.mesh.triangles.size());
  repair.partner.assign(halves, kNone);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> edges(halves);
  for (std::uint32_t half = 0; half < halves; ++half) {
    edges[half] = {edge_key(repair.from(half), repair.to(half)), half};
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t begin = 0; begin < edges.size();) {
    std::size_t end = begin + 1;
    while (end < edges.size() && edges[end].first == edges[begin].first) ++end;
    if (end - begin == 2) {
      repair.partner[edges[begin].second] = edges[begin + 1].second;
      repair.partner[edges[begin + 1].second] = edges[begin].second;
    } else if (end - begin > 2) {
      ++repair.found.non_manifold_edges;
      std::vector<std::uint32_t> crowd{};
      for (std::size_t i = begin; i < end; ++i) crowd.push_back(edges[i].second);
      repair.crowds.push_back(std::move(crowd));
    }
    begin = end;
  }
}

// Turns faces so that neighbours run through their common edge in opposite directions, from face to face. Of a sheet of
// connected faces the smaller part counts as turned.
void turn_to_agree(MeshInRepair& repair) {
  const auto faces = static_cast<std::uint32_t>(repair.mesh.triangles.size());
  std::vector<signed char> turned(faces, -1);
  std::vector<std::uint32_t> sheet{};
  for (std::uint32_t seed = 0; seed < faces; ++seed) {
    if (turned[seed] >= 0) continue;
    sheet.assign(1, seed);
    turned[seed] = 0;
    std::size_t count = 0;
    for (std::size_t next = 0; next < sheet.size(); ++next) {
      const std::uint32_t face = sheet[next];
      for (std::uint32_t half = 3 * face; half < 3 * face + 3; ++half) {
        if (repair.partner[half] == kNone) continue;
        const std::uint32_t other = repair.partner[half] / 3;
        const bool agree = repair.from(half) != repair.from(repair.partner[half]);
        const auto wanted = static_cast<signed char>(agree ? turned[face] : 1 - turned[face]);
        if (turned[other] < 0) {
          turned[other] = wanted;
          count += wanted == 1 ? 1 : 0;
          sheet.push_back(other);
        } else if (turned[other] != wanted) {
          repair.refuse(
              "has a non-orientable surface (with one side only, like a Möbius strip) near "
              "triangle " +
              std::to_string(other + 1ULL) + ". Correct the mesh there.");
        }
      }
    }
    const bool other_way = 2 * count > sheet.size();
    repair.found.faces_turned += other_way ? sheet.size() - count : count;
    if (!other_way) continue;
    for (const std::uint32_t face : sheet)
      turned[face] = static_cast<signed char>(1 - turned[face]);
  }
  // Turning exchanges the last two corners: half-edge 0 ↔ 2, and 1 stays.
  const auto moved = [&](std::uint32_t half) {
    return turned[half / 3] == 1 ? half / 3 * 3 + 2 - half % 3 : half;
  };
  std::vector<std::uint32_t> partner(repair.partner.size(), kNone);
  for (std::uint32_t half = 0; half < repair.partner.size(); ++half) {
    if (repair.partner[half] != kNone) partner[moved(half)] = moved(repair.partner[half]);
  }
  repair.partner = std::move(partner);
  for (std::vector<std::uint32_t>& crowd : repair.crowds) {
    for (std::uint32_t& half : crowd) half = moved(half);
  }
  for (std::uint32_t face = 0; face < faces; ++face) {
    // (a, b, c) → (a, c, b): the edges ab, bc, ca become ac, cb, ba.
    if (turned[face] == 1)
      std::swap(repair.mesh.triangles[face][1], repair.mesh.triangles[face][2]);
  }
}

// Pairs the faces around an edge a → b by their angles. A face that runs b → a has the body on the side of increasing
// angles, one that runs a → b on the other side; so the body is between the first and the next that runs a → b.
void pair_at_crowded_edges(MeshInRepair& repair) {
  for (const std::vector<std::uint32_t>& crowd : repair.crowds) {
    const std::uint32_t low = std::min(repair.from(crowd[0]), repair.to(crowd[0]));
    const std::uint32_t high = std::max(repair.from(crowd[0]), repair.to(crowd[0]));
    const glm::dvec3 a_m = repair.mesh.vertices_m[low];
    const glm::dvec3 axis = glm::normalize(repair.mesh.vertices_m[high] - a_m);
    const glm::dvec3 aside = std::abs(axis.x) < 0.6 ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(axis, aside));
    const glm::dvec3 v = glm::cross(axis, u);
    std::vector<std::pair<double, std::uint32_t>> around{};
    for (const std::uint32_t half : crowd) {
      const glm::dvec3 apex_m = repair.mesh.vertices_m[repair.opposite_corner(half)] - a_m;
      around.emplace_back(std::atan2(glm::dot(apex_m, v), glm::dot(apex_m, u)), half);
    }
    const auto runs_up = [&](std::uint32_t half) { return repair.from(half) == low; };
    // Of two faces at the same angle, where two solids touch, the body is not between them.
    std::sort(around.begin(), around.end(), [&](const auto& one, const auto& other) {
      if (one.first != other.first) return one.first < other.first;
      if (runs_up(one.second) != runs_up(other.second)) return runs_up(one.second);
      return one.second < other.second;
    });
    const auto pair_neighbours = [&] {
      for (std::size_t i = 0; i < around.size() && around.size() > 1; ++i) {
        const std::size_t next = (i + 1) % around.size();
        const std::uint32_t first = around[i].second;
        const std::uint32_t second = around[next].second;
        if (runs_up(first) || !runs_up(second)) continue;
        join_faces(repair, first, second);
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
        around.erase(around.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
        return true;
      }
      return false;
    };
    while (pair_neighbours()) {
    }
  }
}

}  // namespace asperity::mesh_repair
