// Bodies of shapes: which way they lie, where their frame begins.

#include "stimuli/meshes/solid_body.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "stimuli/meshes/textured_point.h"
#include "tests/stimuli/made_mesh.h"

namespace asperity::test {
namespace {

struct Bounds {
  glm::dvec3 low_m{1e9};
  glm::dvec3 high_m{-1e9};
};

Bounds bounds_of(const TexturedMesh& mesh) {
  Bounds bounds{};
  for (const glm::dvec3& vertex : mesh.vertices_m) {
    bounds.low_m = glm::min(bounds.low_m, vertex);
    bounds.high_m = glm::max(bounds.high_m, vertex);
  }
  return bounds;
}

constexpr CylinderShape kRod{.diameter_m = 0.008, .length_m = 0.012};

TEST(SolidBody, OfACylinderLiesAlongTheAxisThatIsAskedFor) {
  const TexturedMesh rod = body_mesh(kRod, nullptr);
  const auto sizes_m = [&rod](BodyAxis axis) {
    const TexturedMesh lying = turned(rod, axis);
    EXPECT_GT(volume_m3({lying.vertices_m, lying.triangles}), 0.0) << "turned, not mirrored";
    const Bounds bounds = bounds_of(lying);
    return bounds.high_m - bounds.low_m;
  };
  // Facets of the round side lie within it by at most R(1 − cos(π/32)), 0.02 mm.
  constexpr double kFacet_m = 4e-5;
  const glm::dvec3 x = sizes_m(BodyAxis::x);
  EXPECT_DOUBLE_EQ(x.x, 0.012);
  EXPECT_NEAR(x.z, 0.008, kFacet_m);
  const glm::dvec3 y = sizes_m(BodyAxis::y);
  EXPECT_DOUBLE_EQ(y.y, 0.012);
  EXPECT_NEAR(y.z, 0.008, kFacet_m);
  EXPECT_DOUBLE_EQ(sizes_m(BodyAxis::z).z, 0.012);
}

TEST(SolidBody, TurnsItsNormalsWithIt) {
  const TexturedMesh lying = turned(body_mesh(kRod, nullptr), BodyAxis::x);
  for (const auto& [a, b, c] : lying.triangles) {
    const glm::dvec3 front = glm::cross(lying.vertices_m[b] - lying.vertices_m[a],
                                        lying.vertices_m[c] - lying.vertices_m[a]);
    for (const std::uint32_t corner : {a, b, c}) {
      ASSERT_GT(glm::dot(front, lying.normals[corner]), 0.0);
    }
  }
}

TEST(SolidBody, IsFeltFromItsHighestPointAndHeldAtItsLowest) {
  const TexturedMesh ball = body_mesh(SphereShape{.diameter_m = 0.01}, nullptr);
  const Bounds surface = bounds_of(placed(ball, BodyRole::surface));
  EXPECT_DOUBLE_EQ(surface.high_m.z, 0.0);
  EXPECT_DOUBLE_EQ(surface.low_m.z, -0.01);
  const Bounds tool = bounds_of(placed(ball, BodyRole::tool));
  EXPECT_DOUBLE_EQ(tool.low_m.z, 0.0);
  EXPECT_DOUBLE_EQ(tool.high_m.z, 0.01);
  EXPECT_DOUBLE_EQ(tool.high_m.x, 0.005) << "only along z";
}

TEST(SolidBody, OfADiscIsATenthAsLongAsWide) {
  const Bounds disc = bounds_of(body_mesh(disc_of(0.02), nullptr));
  EXPECT_NEAR(disc.high_m.z - disc.low_m.z, 0.002, 1e-12);
}

TEST(SolidBody, CarriesTheReliefThatItIsGivenAndIsSmoothWithout) {
  const HeightField raised({.rows = 4, .columns = 4, .pitch_m = 0.002},
                           std::vector<float>(16, 1e-4F));
  const auto highest_m = [](const TexturedMesh& mesh) {
    double highest = -1.0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      highest = std::max(highest, textured_point_m(mesh, triangle, glm::dvec3{1.0 / 3.0}).z);
    }
    return highest;
  };
  const Shape plate = PlateShape{{0.03, 0.02, 0.01}};
  EXPECT_NEAR(highest_m(body_mesh(plate, &raised)), 1e-4, 1e-8);
  EXPECT_NEAR(highest_m(body_mesh(plate, nullptr)), 0.0, 1e-12);
}

TEST(SolidBody, RefusesASizeThatIsNotPositive) {
  EXPECT_THROW(body_mesh(SphereShape{.diameter_m = -1.0}, nullptr), std::invalid_argument);
  EXPECT_THROW(require_body_mesh(disc_of(0.0), nullptr), std::invalid_argument);
  EXPECT_NO_THROW(require_body_mesh(disc_of(0.001), nullptr));
}

}  // namespace
}  // namespace asperity::test
