// Declares the Delaunay triangulation of points in a plane.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace asperity {

/// Triangles between points, none of which has a point within its circumscribed circle [Lawson 1977].
struct Triangulation {
  struct Triangle {
    /// Of the points, anticlockwise.
    std::array<std::size_t, 3> points{};
    /// Element i is the triangle across the side that does not contain points[i]; kNone at the hull.
    std::array<std::size_t, 3> neighbours{};
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::vector<Triangle> triangles{};
  /// The sides of the convex hull, anticlockwise; without triangles the pieces of the line on which all points lie, from one
  /// end to the other.
  std::vector<std::array<std::size_t, 2>> hull{};
};

/// Triangulates points whose coordinates are comparable in size, near 1: triangles with less than 10⁻¹² of double their area
/// count as a line. Points are added from left to right, each joined to the sides of the hull that it sees; sides are then
/// flipped until every circle is empty. Where four points lie on a circle, either diagonal serves.
///
/// One point has neither triangles nor a hull.
///
/// Errors: std::invalid_argument for two points that are closer than 10⁻⁴.
///
/// [Lawson 1977] Lawson: Software for C¹ surface interpolation.
Triangulation delaunay(std::span<const Eigen::Vector2d> points);

}  // namespace asperity
