// Rays against a mesh, and its nearest points.

#include "stimuli/meshes/surface_search.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/stimuli/made_mesh.h"

namespace asperity::test {
namespace {

TEST(SurfaceSearch, MeetsTheFrontThatLooksAlongTheRay) {
  const TriangleMesh mesh = box({0.01, 0.02, 0.03});
  const SurfaceSearch search(mesh);
  // From outside towards the box: the side at −x looks the other way and is passed through.
  const auto through = search.first_front({{-0.05, 0.001, 0.002}, {1, 0, 0}, {1, 0, 0}, 1.0});
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->distance, 0.06, 1e-8);
  EXPECT_GE(through->triangle, 10U);  // one of the two at +x
  const auto into = search.first_front({{-0.05, 0.001, 0.002}, {2, 0, 0}, {-1, 0, 0}, 1.0});
  ASSERT_TRUE(into);
  EXPECT_NEAR(into->distance, 0.02, 1e-8);  // in lengths of the direction
  EXPECT_FALSE(search.first_front({{-0.05, 0.001, 0.002}, {1, 0, 0}, {1, 0, 0}, 0.059}));
  EXPECT_FALSE(search.first_front({{-0.05, 0.1, 0.0}, {1, 0, 0}, {1, 0, 0}, 1.0}));
}

TEST(SurfaceSearch, FindsTheNearestPlace) {
  const TriangleMesh mesh = box({0.01, 0.02, 0.03}, {1.0, 2.0, 3.0});
  const SurfaceSearch search(mesh);
  const auto face = search.nearest({1.013, 2.001, 3.002});
  EXPECT_NEAR(face.distance_m, 0.003, 1e-15);
  EXPECT_GE(face.triangle, 10U);
  const auto corner = search.nearest({1.013, 2.024, 3.042});
  EXPECT_NEAR(corner.distance_m, 0.013, 1e-12);  // 3, 4 and 12 mm from the corner
  EXPECT_NEAR(std::max({corner.barycentric.x, corner.barycentric.y, corner.barycentric.z}), 1.0,
              1e-12);
}

// Every triangle by itself is the measure of the tree.
TEST(SurfaceSearch, FindsWhatALookAtEveryTriangleFinds) {
  const TriangleMesh mesh = bumpy_ball(3, 0.02, 0.002, 5.0);
  const SurfaceSearch search(mesh);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 point_m{0.03 * std::sin(1.0 * i), 0.03 * std::sin(2.3 * i),
                             0.03 * std::sin(3.7 * i)};
    double nearest_m = 1.0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::array<glm::dvec3, 3> corners_m{mesh.vertices_m[a], mesh.vertices_m[b],
                                                mesh.vertices_m[c]};
      const glm::dvec3 w = nearest_in_triangle(corners_m, point_m);
      nearest_m = std::min(nearest_m, glm::length(w.x * corners_m[0] + w.y * corners_m[1] +
                                                  w.z * corners_m[2] - point_m));
    }
    EXPECT_DOUBLE_EQ(search.nearest(point_m).distance_m, nearest_m) << i;
  }
}

TEST(SurfaceSearch, KnowsTheNearestPointOfATriangleWithoutArea) {
  const glm::dvec3 w =
      nearest_in_triangle({glm::dvec3{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {2.0, 1.0, 0.0});
  EXPECT_NEAR(w.y * 1.0 + w.z * 3.0, 2.0, 1e-12);
  EXPECT_NEAR(w.x + w.y + w.z, 1.0, 1e-12);
}

}  // namespace
}  // namespace asperity::test
