// Implements the Delaunay triangulation by a sweep and flips.

#include "analysis/numbers/delaunay.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

namespace asperity {
namespace {

constexpr double kLine = 1e-12;
constexpr double kClosest = 1e-4;

using Points = std::span<const Eigen::Vector2d>;
using Side = std::array<std::size_t, 2>;
using Corners = std::array<std::size_t, 3>;

/// Twice the area of the triangle; positive if anticlockwise.
double twice_area(Points points, std::size_t a, std::size_t b, std::size_t c) {
  const Eigen::Vector2d u = points[b] - points[a];
  const Eigen::Vector2d v = points[c] - points[a];
  return u.x() * v.y() - u.y() * v.x();
}

/// Positive if d is within the circle through the corners of an anticlockwise triangle.
double within_circle(Points points, const Corners& corners, std::size_t d) {
  const Eigen::Vector2d a = points[corners[0]] - points[d];
  const Eigen::Vector2d b = points[corners[1]] - points[d];
  const Eigen::Vector2d c = points[corners[2]] - points[d];
  return a.squaredNorm() * (b.x() * c.y() - b.y() * c.x()) -
         b.squaredNorm() * (a.x() * c.y() - a.y() * c.x()) +
         c.squaredNorm() * (a.x() * b.y() - a.y() * b.x());
}

void require_apart(Points points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((points[i] - points[j]).norm() > kClosest) continue;
      throw std::invalid_argument("points: the points " + std::to_string(j + 1) + " and " +
                                  std::to_string(i + 1) + " are the same; remove one of them");
    }
  }
}

/// Joins a point to every side of the hull that it sees, and replaces these sides by two.
void add_point(Points points, std::size_t point, std::vector<Side>& hull,
               std::vector<Corners>& triangles) {
  const auto sees = [&](const Side& side) {
    return twice_area(points, side[0], side[1], point) < -kLine;
  };
  // The seen sides follow each other: the hull is turned so that they are its first ones.
  std::size_t first = 0;
  while (first < hull.size() &&
         !(sees(hull[first]) && !sees(hull[(first + hull.size() - 1) % hull.size()]))) {
    ++first;
  }
  if (first == hull.size()) {
    throw std::invalid_argument("points: point " + std::to_string(point + 1) +
                                " is too close to a line between others; remove or move it");
  }
  std::rotate(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(first), hull.end());
  std::size_t seen = 0;
  while (seen < hull.size() && sees(hull[seen])) {
    triangles.push_back({hull[seen][1], hull[seen][0], point});
    ++seen;
  }
  const Side before{hull[0][0], point};
  const Side after{point, hull[seen - 1][1]};
  hull.erase(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(seen));
  hull.insert(hull.begin(), {before, after});
}

/// For each side of each triangle in its direction, the triangle and the corner across from it.
std::map<Side, std::array<std::size_t, 2>> sides_of(const std::vector<Corners>& triangles) {
  std::map<Side, std::array<std::size_t, 2>> sides{};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      sides[{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]}] = {t, i};
    }
  }
  return sides;
}

/// Replaces the diagonal of one pair of triangles, if there is one to replace.
bool flip_one(Points points, std::vector<Corners>& triangles) {
  const auto sides = sides_of(triangles);
  for (const auto& [side, place] : sides) {
    const auto across = sides.find({side[1], side[0]});
    if (across == sides.end()) continue;
    const std::size_t apex = triangles[place[0]][place[1]];
    const std::size_t other = triangles[across->second[0]][across->second[1]];
    if (!(within_circle(points, triangles[place[0]], other) > kLine)) continue;
    const Corners left{apex, side[0], other};
    const Corners right{apex, other, side[1]};
    if (!(twice_area(points, left[0], left[1], left[2]) > kLine) ||
        !(twice_area(points, right[0], right[1], right[2]) > kLine)) {
      continue;
    }
    triangles[place[0]] = left;
    triangles[across->second[0]] = right;
    return true;
  }
  return false;
}

}  // namespace

Triangulation delaunay(std::span<const Eigen::Vector2d> points) {
  require_apart(points);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(points[a].x(), points[a].y()) < std::pair(points[b].x(), points[b].y());
  });
  Triangulation result{};
  // The first points, as long as they are on a line.
  std::size_t on_line = std::min<std::size_t>(2, order.size());
  while (on_line < order.size() &&
         !(std::abs(twice_area(points, order[0], order[1], order[on_line])) > kLine)) {
    ++on_line;
  }
  for (std::size_t i = 0; i + 1 < on_line; ++i) result.hull.push_back({order[i], order[i + 1]});
  if (on_line == order.size()) return result;
  // There and back, so that the first point aside sees one of both directions.
  std::vector<Side> hull = result.hull;
  for (std::size_t i = on_line; i-- > 1;) hull.push_back({order[i], order[i - 1]});
  std::vector<Corners> triangles{};
  for (std::size_t i = on_line; i < order.size(); ++i) add_point(points, order[i], hull, triangles);
  // Each flip lowers the triangulation on the paraboloid x² + y², so that none returns.
  while (flip_one(points, triangles)) {
  }
  const auto sides = sides_of(triangles);
  for (const Corners& corners : triangles) {
    Triangulation::Triangle triangle{.points = corners};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto across = sides.find({corners[(i + 2) % 3], corners[(i + 1) % 3]});
      triangle.neighbours[i] = across == sides.end() ? Triangulation::kNone : across->second[0];
    }
    result.triangles.push_back(triangle);
  }
  result.hull = hull;
  return result;
}

}  // namespace asperity
