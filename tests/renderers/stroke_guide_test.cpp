// The curves of strokes: arcs and the upper sides of bodies.

#include "renderers/offline/stroke_guide.h"

#include <cmath>
#include <memory>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/meshes/solid_body.h"

namespace asperity {
namespace {

std::shared_ptr<const BodySurface> surface_of_shape(const Shape& shape) {
  return std::make_shared<const BodySurface>(body_mesh(shape, nullptr));
}

const std::shared_ptr<const BodySurface>& long_box() {
  static const auto kSurface = surface_of_shape(BoxShape{{0.3, 0.05, 0.02}});
  return kSurface;
}

TEST(TurningGuide, IsACircleThatTurnsTheTool) {
  constexpr double kRadius_m = 0.02;
  const TurningGuide guide(kRadius_m);
  const glm::dvec3 axis_m{0.0, kRadius_m, 0.0};
  for (const double angle_rad : {-1.0, 0.0, 0.3, 2.0}) {
    const GuidePlace place = guide.at(kRadius_m * angle_rad);
    const glm::dvec3 arm_m = place.origin_m - axis_m;
    EXPECT_NEAR(glm::length(arm_m), kRadius_m, 1e-12);
    // The tip begins at (0, −r) from the axis and moves by the rotation about +z.
    const glm::dvec3 begun_m = glm::conjugate(place.orientation) * arm_m;
    EXPECT_NEAR(glm::distance(begun_m, glm::dvec3{0.0, -kRadius_m, 0.0}), 0.0, 1e-12);
    EXPECT_NEAR(
        glm::distance(place.along, glm::cross(glm::dvec3{0.0, 0.0, 1.0}, arm_m) / kRadius_m), 0.0,
        1e-12);
  }
  EXPECT_DOUBLE_EQ(guide.turn_rad_per_m(), 1.0 / kRadius_m);
  EXPECT_THROW(TurningGuide(0.0), std::invalid_argument);
}

TEST(BodyGuide, IsTheUpperSideOfABoxWithoutItsEdges) {
  const BodyGuide guide(long_box(), 0.0);
  EXPECT_NEAR(guide.body_origin_m().z, -0.01, 1e-9);
  EXPECT_NEAR(guide.to_m() - guide.from_m(), 0.298, 0.004);
  for (const double s_m : {guide.from_m(), -0.0123, 0.0, 0.05, guide.to_m()}) {
    const GuidePlace place = guide.at(s_m);
    EXPECT_NEAR(glm::distance(place.origin_m, glm::dvec3{s_m, 0.0, 0.0}), 0.0, 1e-9) << s_m;
    EXPECT_NEAR(glm::distance(place.normal, glm::dvec3{0.0, 0.0, 1.0}), 0.0, 1e-6) << s_m;
  }
}

TEST(BodyGuide, IsAnArcOfASphereOfSixtyDegrees) {
  constexpr double kRadius_m = 0.03;
  const BodyGuide guide(surface_of_shape(SphereShape{.diameter_m = 2.0 * kRadius_m}), 0.0);
  const double sixth_m = 3.14159265 / 6.0 * kRadius_m;
  EXPECT_NEAR(guide.to_m(), sixth_m - 1e-3, 2e-4);
  EXPECT_NEAR(guide.from_m(), -(sixth_m - 1e-3), 2e-4);
  for (double s_m = guide.from_m(); s_m < guide.to_m(); s_m += 0.0007) {
    const GuidePlace place = guide.at(s_m);
    const double angle_rad = s_m / kRadius_m;
    EXPECT_NEAR(place.origin_m.x, kRadius_m * std::sin(angle_rad), 3e-5) << s_m;
    EXPECT_NEAR(place.origin_m.z, kRadius_m * (std::cos(angle_rad) - 1.0), 3e-5) << s_m;
    EXPECT_NEAR(place.normal.x, std::sin(angle_rad), 0.01) << s_m;
    EXPECT_NEAR(glm::dot(place.normal, place.along), 0.0, 1e-12);
    EXPECT_GT(place.along.x, 0.0);
  }
}

TEST(BodyGuide, RefusesABodyThatTheLineMissesOrThatIsTooShort) {
  EXPECT_THROW(BodyGuide(long_box(), 0.03), std::invalid_argument);
  EXPECT_THROW(BodyGuide(surface_of_shape(SphereShape{.diameter_m = 0.004}), 0.0),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
