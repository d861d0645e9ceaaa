// The triangulation of points: empty circles, a convex whole, lines.

#include "analysis/numbers/delaunay.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

using Points = std::vector<Eigen::Vector2d>;

double area_of_triangle(const Points& points, const Triangulation::Triangle& triangle) {
  const Eigen::Vector2d u = points[triangle.points[1]] - points[triangle.points[0]];
  const Eigen::Vector2d v = points[triangle.points[2]] - points[triangle.points[0]];
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

Eigen::Vector2d centre_of_circle(const Points& points, const Triangulation::Triangle& triangle) {
  const Eigen::Vector2d a = points[triangle.points[0]];
  const Eigen::Vector2d u = points[triangle.points[1]] - a;
  const Eigen::Vector2d v = points[triangle.points[2]] - a;
  const double twice = 2.0 * (u.x() * v.y() - u.y() * v.x());
  return a + Eigen::Vector2d(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                             u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                 twice;
}

void expect_delaunay(const Points& points, double hull_area) {
  const Triangulation made = delaunay(points);
  double area = 0.0;
  for (const Triangulation::Triangle& triangle : made.triangles) {
    const double its_area = area_of_triangle(points, triangle);
    EXPECT_GT(its_area, 0.0);
    area += its_area;
    const Eigen::Vector2d centre = centre_of_circle(points, triangle);
    const double radius = (points[triangle.points[0]] - centre).norm();
    for (const Eigen::Vector2d& point : points) {
      EXPECT_GT((point - centre).norm(), radius * (1.0 - 1e-6));
    }
    for (int i = 0; i < 3; ++i) {
      if (triangle.neighbours[i] == Triangulation::kNone) continue;
      int shared = 0;
      for (const std::size_t own : triangle.points) {
        for (const std::size_t other : made.triangles.at(triangle.neighbours[i]).points) {
          if (own != other) continue;
          ++shared;
          EXPECT_NE(own, triangle.points[i]);
        }
      }
      EXPECT_EQ(shared, 2);
    }
  }
  EXPECT_NEAR(area, hull_area, 1e-9);
  // Euler: 2·n − 2 − h triangles.
  EXPECT_EQ(made.triangles.size(), 2 * points.size() - 2 - made.hull.size());
}

// With the corners of the square, so that the hull is known.
TEST(Delaunay, HasEmptyCirclesAndCoversTheHull) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Points points{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}};
    for (int i = 0; i < 30; ++i) points.emplace_back(random.uniform(), random.uniform());
    expect_delaunay(points, 1.0);
  }
}

// Four points on every circle, and five on each side of the hull.
TEST(Delaunay, TriangulatesARegularGrid) {
  Points points{};
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 5; ++j) points.emplace_back(0.25 * i, 0.25 * j);
  }
  expect_delaunay(points, 1.0);
}

TEST(Delaunay, OfPointsOnALineIsTheLine) {
  const Triangulation made = delaunay(Points{{0.5, 1.0}, {0.0, 0.0}, {1.0, 2.0}, {0.25, 0.5}});
  EXPECT_TRUE(made.triangles.empty());
  const std::vector<std::array<std::size_t, 2>> pieces{{1, 3}, {3, 0}, {0, 2}};
  EXPECT_EQ(made.hull, pieces);
  EXPECT_TRUE(delaunay(Points{{0.5, 1.0}}).hull.empty());
}

TEST(Delaunay, RefusesTheSamePointTwice) {
  EXPECT_THROW(delaunay(Points{{0.5, 1.0}, {0.0, 0.0}, {0.5, 1.0}}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
