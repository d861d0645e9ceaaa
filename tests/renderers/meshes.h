// Small meshes for tests, closed and turned outward.

#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/vec3.hpp>

#include "stimuli/meshes/detailed_bodies.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// Rings of latitude between two poles on the z axis.
inline TriangleMesh ball(double radius_m, std::uint32_t rings, std::uint32_t around) {
  TriangleMesh mesh{};
  mesh.vertices_m.push_back({0.0, 0.0, -radius_m});
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const double latitude = std::numbers::pi * (static_cast<double>(ring) / rings - 0.5);
    for (std::uint32_t i = 0; i < around; ++i) {
      const double longitude = 2.0 * std::numbers::pi * i / around;
      mesh.vertices_m.push_back(radius_m * glm::dvec3(std::cos(latitude) * std::cos(longitude),
                                                      std::cos(latitude) * std::sin(longitude),
                                                      std::sin(latitude)));
    }
  }
  mesh.vertices_m.push_back({0.0, 0.0, radius_m});
  const auto top = static_cast<std::uint32_t>(mesh.vertices_m.size() - 1);
  const auto at = [=](std::uint32_t ring, std::uint32_t i) {
    return 1 + (ring - 1) * around + i % around;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
    for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
    mesh.triangles.push_back({at(rings - 1, i), at(rings - 1, i + 1), top});
  }
  return mesh;
}

/// A box about the origin.
inline TriangleMesh box(const glm::dvec3& size_m) {
  TriangleMesh mesh{};
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices_m.push_back(0.5 * size_m *
                              glm::dvec3((corner & 1) != 0 ? 1.0 : -1.0,
                                         (corner & 2) != 0 ? 1.0 : -1.0,
                                         (corner & 4) != 0 ? 1.0 : -1.0));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace asperity
