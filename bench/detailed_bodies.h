// Bodies of fine detail by formula, closed, several hundred thousand triangles each.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "analysis/random.h"
#include "stimuli/meshes/triangle_mesh.h"

namespace asperity {

/// A relief in space: waves of one to four times the shortest length in all directions.
class Waves final {
 public:
  Waves(double shortest_m, double rms_m, std::uint64_t seed) {
    constexpr std::size_t kWaves = 24;
    Random random(seed);
    double variance_m2 = 0.0;
    for (std::size_t i = 0; i < kWaves; ++i) {
      const double length_m = shortest_m * std::pow(4.0, random.uniform());
      const glm::dvec3 way = glm::normalize(
          glm::dvec3(random.normal(), random.normal(), random.normal()) + glm::dvec3(1e-9));
      waves_.push_back({.per_m = 2.0 * std::numbers::pi / length_m * way,
                        .height_m = std::pow(length_m, 0.8),
                        .phase_rad = 2.0 * std::numbers::pi * random.uniform()});
      variance_m2 += 0.5 * waves_.back().height_m * waves_.back().height_m;
    }
    for (Wave& wave : waves_) wave.height_m *= rms_m / std::sqrt(variance_m2);
  }

  double operator()(const glm::dvec3& place_m) const {
    double sum_m = 0.0;
    for (const Wave& wave : waves_) {
      sum_m += wave.height_m * std::cos(glm::dot(wave.per_m, place_m) + wave.phase_rad);
    }
    return sum_m;
  }

 private:
  struct Wave {
    glm::dvec3 per_m{0.0};
    double height_m = 0.0;
    double phase_rad = 0.0;
  };
  std::vector<Wave> waves_{};
};

/// A body around the z axis, from pole to pole: point(s, φ), s in [0, 1] from the lower pole.
template <typename Point>
TriangleMesh turned_body(std::size_t rows, std::size_t around, const Point& point) {
  TriangleMesh mesh;
  mesh.vertices_m.push_back(point(0.0, 0.0));
  for (std::size_t row = 1; row < rows; ++row) {
    for (std::size_t i = 0; i < around; ++i) {
      mesh.vertices_m.push_back(
          point(static_cast<double>(row) / static_cast<double>(rows),
                2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around)));
    }
  }
  mesh.vertices_m.push_back(point(1.0, 0.0));
  const auto top = static_cast<std::uint32_t>(mesh.vertices_m.size() - 1);
  const auto at = [around](std::size_t row, std::size_t i) {
    return static_cast<std::uint32_t>(1 + (row - 1) * around + i % around);
  };
  for (std::size_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(1, i + 1), at(1, i)});
    for (std::size_t row = 1; row + 1 < rows; ++row) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
    mesh.triangles.push_back({at(rows - 1, i), at(rows - 1, i + 1), top});
  }
  return mesh;
}

/// About the origin.
inline TriangleMesh rough_ball(double radius_m, const Waves& relief, std::size_t triangles) {
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  return turned_body(rows, 2 * rows, [&](double s, double angle_rad) {
    const double latitude_rad = std::numbers::pi * (s - 0.5);
    const glm::dvec3 out{std::cos(latitude_rad) * std::cos(angle_rad),
                         std::cos(latitude_rad) * std::sin(angle_rad), std::sin(latitude_rad)};
    return (radius_m + relief(radius_m * out)) * out;
  });
}

/// With the z axis through its middle and superellipses across: half as wide as width_m(z) and
/// depth_m(z) say, with rounded ends.
template <typename Widths, typename Relief>
TriangleMesh long_body(double length_m, const Widths& half_widths_m, const Relief& relief,
                       std::size_t triangles) {
  constexpr double kRoundness = 4.0;  // 2: an ellipse
  const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 2.0));
  return turned_body(rows, rows, [&](double s, double angle_rad) {
    // Equal steps along the sides, and over the ends.
    const double z_m = length_m * (s - 0.5);
    const double from_end = 1.0 - std::pow(std::abs(2.0 * s - 1.0), 24.0);
    const auto [x_half_m, y_half_m] = half_widths_m(z_m);
    const double cosine = std::cos(angle_rad);
    const double sine = std::sin(angle_rad);
    const double round =
        std::pow(std::pow(std::abs(cosine), kRoundness) + std::pow(std::abs(sine), kRoundness),
                 -1.0 / kRoundness);
    const glm::dvec3 plain{x_half_m * round * cosine * from_end, y_half_m * round * sine * from_end,
                           z_m};
    const glm::dvec3 out{cosine / x_half_m, sine / y_half_m, 0.0};
    return plain + relief(plain) * from_end * glm::normalize(out);
  });
}

/// Looks up, its upper side about z = 0; as many triangles below, in a plane.
template <typename Relief>
TriangleMesh rough_block(double size_m, const Relief& relief, std::size_t triangles) {
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4.0));
  const std::size_t side = cells + 1;
  TriangleMesh mesh;
  for (const bool upper : {true, false}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
    const auto at = [&](std::size_t row, std::size_t column) {
      return static_cast<std::uint32_t>(first + row * side + column);
    };
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto place = [&](std::size_t k) {
        return size_m * (static_cast<double>(k) / static_cast<double>(cells) - 0.5);
      };
      const glm::dvec3 plain{place(i % side), place(i / side), 0.0};
      mesh.vertices_m.push_back({plain.x, plain.y, upper ? relief(plain) : -0.2 * size_m});
    }
    for (std::size_t row = 0; row < cells; ++row) {
      for (std::size_t column = 0; column < cells; ++column) {
        const std::array corners{at(row, column), at(row, column + 1), at(row + 1, column + 1),
                                 at(row + 1, column)};
        if (upper) {
          mesh.triangles.push_back({corners[0], corners[1], corners[2]});
          mesh.triangles.push_back({corners[0], corners[2], corners[3]});
        } else {
          mesh.triangles.push_back({corners[0], corners[2], corners[1]});
          mesh.triangles.push_back({corners[0], corners[3], corners[2]});
        }
      }
    }
  }
  // Once around the upper rim, counter-clockwise from above.
  std::vector<std::uint32_t> rim;
  const auto last = static_cast<std::uint32_t>(cells);
  const auto across = static_cast<std::uint32_t>(side);
  for (std::uint32_t i = 0; i < last; ++i) rim.push_back(i);
  for (std::uint32_t i = 0; i < last; ++i) rim.push_back(i * across + last);
  for (std::uint32_t i = last; i > 0; --i) rim.push_back(last * across + i);
  for (std::uint32_t i = last; i > 0; --i) rim.push_back(i * across);
  const std::uint32_t below = across * across;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::uint32_t next = rim[(i + 1) % rim.size()];
    mesh.triangles.push_back({rim[i], rim[i] + below, next + below});
    mesh.triangles.push_back({rim[i], next + below, next});
  }
  return mesh;
}

inline void append(TriangleMesh& mesh, const TriangleMesh& more, const glm::dvec3& at_m) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (const glm::dvec3& vertex_m : more.vertices_m) mesh.vertices_m.push_back(vertex_m + at_m);
  for (const auto& [a, b, c] : more.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
}

}  // namespace asperity
