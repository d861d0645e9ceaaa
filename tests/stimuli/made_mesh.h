// Meshes for tests, from formulas.

#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "stimuli/meshes/triangle_mesh.h"

namespace asperity::test {

/// A ball: an octahedron divided `levels` times, each vertex as far from the origin as `radius_m`
/// says for its direction. 8·4^levels triangles.
inline TriangleMesh ball(int levels, const std::function<double(const glm::dvec3&)>& radius_m) {
  TriangleMesh mesh{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles{};
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] = middles.try_emplace(
          {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.vertices_m.size()));
      if (is_new) {
        mesh.vertices_m.push_back(glm::normalize(mesh.vertices_m[a] + mesh.vertices_m[b]));
      }
      return place->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer{};
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (glm::dvec3& vertex : mesh.vertices_m) vertex *= radius_m(vertex);
  return mesh;
}

inline TriangleMesh smooth_ball(int levels, double radius_m) {
  return ball(levels, [radius_m](const glm::dvec3&) { return radius_m; });
}

/// Bumps all around, `waves` to the circumference.
inline TriangleMesh bumpy_ball(int levels, double radius_m, double amplitude_m, double waves) {
  return ball(levels, [=](const glm::dvec3& n) {
    return radius_m +
           amplitude_m * std::sin(waves * n.x) * std::sin(waves * n.y) * std::sin(waves * n.z);
  });
}

/// A box about `centre_m`, twelve triangles.
inline TriangleMesh box(const glm::dvec3& half_m, const glm::dvec3& centre_m = glm::dvec3{0.0}) {
  TriangleMesh mesh{};
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices_m.push_back(centre_m + half_m * glm::dvec3{corner & 1 ? 1 : -1,
                                                             corner & 2 ? 1 : -1,
                                                             corner & 4 ? 1 : -1});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A ring with a relief that runs around it: `around` × `across` × 2 triangles.
inline TriangleMesh ring(std::uint32_t around, std::uint32_t across, double relief_m) {
  TriangleMesh mesh{};
  const auto angle = [](std::uint32_t i, std::uint32_t of) {
    return 2.0 * std::numbers::pi * i / of;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const double u = angle(i, around);
      const double v = angle(j, across);
      const double tube_m = 0.008 + relief_m * std::sin(24.0 * u) * std::cos(8.0 * v);
      const double from_axis_m = 0.025 + tube_m * std::cos(v);
      mesh.vertices_m.emplace_back(from_axis_m * std::cos(u), from_axis_m * std::sin(u),
                                   tube_m * std::sin(v));
    }
  }
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < across; ++j) {
      const std::uint32_t next_i = (i + 1) % around * across;
      const std::uint32_t next_j = (j + 1) % across;
      const std::uint32_t a = i * across + j;
      const std::uint32_t b = next_i + j;
      const std::uint32_t c = next_i + next_j;
      const std::uint32_t d = i * across + next_j;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// Cubes of 10 mm with a corner at the given places of a grid; only faces without a neighbour.
inline TriangleMesh cubes(const std::set<std::array<int, 3>>& cells) {
  TriangleMesh mesh{};
  std::map<std::array<int, 3>, std::uint32_t> vertices{};
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [found, is_new] =
        vertices.try_emplace(place, static_cast<std::uint32_t>(mesh.vertices_m.size()));
    if (is_new) mesh.vertices_m.push_back(0.01 * glm::dvec3{place[0], place[1], place[2]});
    return found->second;
  };
  for (const std::array<int, 3>& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beyond = cell;
        beyond[axis] += side == 1 ? 1 : -1;
        if (cells.contains(beyond)) continue;
        std::array<std::uint32_t, 4> corners{};
        for (std::size_t i = 0; i < 4; ++i) {
          constexpr int kAround[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
          std::array<int, 3> place = cell;
          place[axis] += side;
          place[(axis + 1) % 3] += kAround[i][side == 1 ? 0 : 1];
          place[(axis + 2) % 3] += kAround[i][side == 1 ? 1 : 0];
          corners[i] = vertex(place);
        }
        mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        mesh.triangles.push_back({corners[0], corners[2], corners[3]});
      }
    }
  }
  return mesh;
}

/// Both, as one mesh.
inline TriangleMesh together(TriangleMesh one, const TriangleMesh& other) {
  const auto offset = static_cast<std::uint32_t>(one.vertices_m.size());
  one.vertices_m.insert(one.vertices_m.end(), other.vertices_m.begin(), other.vertices_m.end());
  for (const auto& [a, b, c] : other.triangles) {
    one.triangles.push_back({a + offset, b + offset, c + offset});
  }
  return one;
}

inline double volume_m3(const TriangleMesh& mesh) {
  double sum_m3 = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum_m3 +=
        glm::dot(mesh.vertices_m[a], glm::cross(mesh.vertices_m[b], mesh.vertices_m[c])) / 6.0;
  }
  return sum_m3;
}

/// Every edge is run through once in each direction.
inline bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> runs{};
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++runs[{triangle[i], triangle[(i + 1) % 3]}];
  }
  for (const auto& [edge, count] : runs) {
    const auto back = runs.find({edge.second, edge.first});
    if (count != 1 || back == runs.end() || back->second != 1) return false;
  }
  return true;
}

}  // namespace asperity::test
