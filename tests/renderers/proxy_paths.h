// Bodies and paths of a probe that the tests of the proxy share.

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "renderers/proxy/body_surface.h"
#include "stimuli/meshes/solid_body.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

inline constexpr double kProxyTick_s = 0.001;
inline constexpr double kFast_m_per_s = 0.2;

inline std::shared_ptr<const BodySurface> proxy_surface_of(const Shape& shape) {
  return std::make_shared<const BodySurface>(placed(body_mesh(shape, nullptr), BodyRole::surface));
}

/// The extrusion along y of a closed polygon in the x-z plane, counter-clockwise as seen from −y, in facets of about a
/// millimetre along the polygon. Its ends are open.
inline TriangleMesh extruded(const std::vector<glm::dvec2>& polygon_m, double length_m) {
  constexpr double kFacet_m = 0.001;
  std::vector<glm::dvec2> outline_m{};
  for (std::size_t i = 0; i < polygon_m.size(); ++i) {
    const glm::dvec2 from_m = polygon_m[i];
    const glm::dvec2 along_m = polygon_m[(i + 1) % polygon_m.size()] - from_m;
    const int parts = static_cast<int>(std::ceil(glm::length(along_m) / kFacet_m));
    for (int part = 0; part < parts; ++part) {
      outline_m.push_back(from_m + along_m * (static_cast<double>(part) / parts));
    }
  }
  const auto around = static_cast<std::uint32_t>(outline_m.size());
  const auto rows = static_cast<std::uint32_t>(std::ceil(length_m / kFacet_m));
  TriangleMesh mesh{};
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (const glm::dvec2& place_m : outline_m) {
      mesh.vertices_m.push_back(
          {place_m.x, length_m * (static_cast<double>(row) / rows - 0.5), place_m.y});
    }
  }
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = row * around + i;
      const std::uint32_t b = row * around + (i + 1) % around;
      mesh.triangles.push_back({a, b + around, b});
      mesh.triangles.push_back({a, a + around, b + around});
    }
  }
  return mesh;
}

/// A block of 40 mm by 20 mm with a groove of 90° along the middle of its upper side, 5 mm deep.
inline std::shared_ptr<const BodySurface> grooved_block() {
  return std::make_shared<const BodySurface>(extruded({{-0.02, -0.02},
                                                       {0.02, -0.02},
                                                       {0.02, 0.0},
                                                       {0.005, 0.0},
                                                       {0.0, -0.005},
                                                       {-0.005, 0.0},
                                                       {-0.02, 0.0}},
                                                      0.02));
}

/// Places between corners, at most as far apart as a fast hand moves in a tick.
inline std::vector<glm::dvec3> path_m(const std::vector<glm::dvec3>& corners_m,
                                      double speed_m_per_s = kFast_m_per_s) {
  std::vector<glm::dvec3> places_m{corners_m.front()};
  for (std::size_t i = 1; i < corners_m.size(); ++i) {
    const glm::dvec3 along_m = corners_m[i] - corners_m[i - 1];
    const int ticks =
        static_cast<int>(std::ceil(glm::length(along_m) / (speed_m_per_s * kProxyTick_s)));
    for (int tick = 1; tick <= ticks; ++tick) {
      places_m.push_back(corners_m[i - 1] + along_m * (static_cast<double>(tick) / ticks));
    }
  }
  return places_m;
}

/// A stroke on the tube of `bumpy_torus`, below its surface. Neither angle moves by more than `step_m` along the surface.
inline std::vector<glm::dvec3> stroke_in_torus_m(double depth_m, double step_m, std::size_t count,
                                                 double from_rad = 0.0) {
  std::vector<glm::dvec3> probes_m{};
  double a = from_rad;
  for (std::size_t i = 0; i < count; ++i) {
    const double b = 2.0 * std::numbers::pi * std::sin(0.7 * a);
    const double tube_m =
        0.012 * (1.0 + 0.15 * std::sin(5.0 * a + 0.3) * std::cos(3.0 * b)) - depth_m;
    const double radius_m = 0.03 + tube_m * std::cos(b);
    probes_m.push_back({radius_m * std::cos(a), radius_m * std::sin(a), tube_m * std::sin(b)});
    a += step_m / std::hypot(0.042, 4.4 * 0.0138);
  }
  return probes_m;
}

}  // namespace asperity
