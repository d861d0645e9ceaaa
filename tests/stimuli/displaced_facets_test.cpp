// The facets of a displaced surface.

#include "stimuli/meshes/displaced_facets.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

constexpr double kRadius_m = 0.02;

TriangleMesh facets_of_a_ball(const FacetLimits& limits) {
  return displaced_facets(body_mesh(SphereShape{2.0 * kRadius_m}, nullptr), limits);
}

TEST(DisplacedFacets, HaveTheirCornersOnTheDisplacedSurface) {
  // The mesh of the ball has 512 faces; only its displacements make it round.
  double farthest_m = 0.0;
  for (const glm::dvec3& vertex_m : facets_of_a_ball({.longest_m = 0.001}).vertices_m) {
    farthest_m = std::max(farthest_m, std::abs(glm::length(vertex_m) - kRadius_m));
  }
  EXPECT_LT(farthest_m, 1e-6);
}

TEST(DisplacedFacets, FormAClosedSurface) {
  const TriangleMesh facets = facets_of_a_ball({.longest_m = 0.001});
  const auto opposite = opposite_half_edges(facets.triangles);
  EXPECT_EQ(std::count(opposite.begin(), opposite.end(), kNoHalfEdge), 0);
  // Euler: V − E + F = 2 with 2E = 3F.
  EXPECT_EQ(2 * facets.vertices_m.size(), facets.triangles.size() + 4);
}

TEST(DisplacedFacets, AreAsShortAsTheLimitOnTheirNumberAllows) {
  const auto longest_m = [](const TriangleMesh& facets) {
    double longest = 0.0;
    for (const auto& triangle : facets.triangles) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        longest = std::max(longest, glm::distance(facets.vertices_m[triangle[corner]],
                                                  facets.vertices_m[triangle[(corner + 1) % 3]]));
      }
    }
    return longest;
  };
  EXPECT_LT(longest_m(facets_of_a_ball({.longest_m = 0.001})), 0.00105);
  const TriangleMesh few = facets_of_a_ball({.longest_m = 0.001, .most = 10'000});
  EXPECT_EQ(few.triangles.size(), 512U * 4U * 4U);
}

TEST(DisplacedFacets, AreAsManyWhicheverSideOfATriangleIsTheLongest) {
  TexturedMesh mesh = body_mesh(SphereShape{2.0 * kRadius_m}, nullptr);
  mesh.triangles.resize(1);
  mesh.places.resize(1);
  mesh.places[0].fill(mesh.places[0][0]);
  auto& triangle = mesh.triangles[0];
  mesh.vertices_m[triangle[0]] = {0.0, 0.0, 0.0};
  mesh.vertices_m[triangle[1]] = {0.0095, 0.0, 0.0};
  mesh.vertices_m[triangle[2]] = {0.005, 0.001, 0.0};
  for (int turn = 0; turn < 3; ++turn) {
    EXPECT_EQ(displaced_facets(mesh, {.longest_m = 0.001}).triangles.size(), 10U * 10U) << turn;
    std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
  }
}

}  // namespace
}  // namespace asperity
