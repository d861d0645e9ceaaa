// The proxy at walls: opposite ones, and thin ones.

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/proxy/surface_proxy.h"
#include "tests/renderers/proxy_paths.h"

namespace asperity {
namespace {

/// A block of 40 mm by 20 mm with a channel along the middle of its upper side, 6 mm wide and 8 mm deep.
std::shared_ptr<const BodySurface> channelled_block() {
  return std::make_shared<const BodySurface>(extruded({{-0.02, -0.02},
                                                       {0.02, -0.02},
                                                       {0.02, 0.0},
                                                       {0.003, 0.0},
                                                       {0.003, -0.008},
                                                       {-0.003, -0.008},
                                                       {-0.003, 0.0},
                                                       {-0.02, 0.0}},
                                                      0.02));
}

TEST(SurfaceProxyWalls, AProbeThatCrossesAChannelIsPushedBackByTheOtherWall) {
  SurfaceProxy proxy(channelled_block());
  const glm::dvec3 over_m{-0.001, 0.0003, 0.003};
  const glm::dvec3 in_m{-0.001, 0.0003, -0.0042};
  const glm::dvec3 in_left_m{-0.0035, 0.0003, -0.0042};
  const glm::dvec3 in_right_m{0.0035, 0.0003, -0.0042};
  for (const glm::dvec3& probe_m : path_m({over_m, in_m, in_left_m})) proxy.follow(probe_m);
  const auto left = proxy.follow(in_left_m);
  ASSERT_TRUE(left.has_value());
  EXPECT_NEAR(left->height_m, -0.0005, 1e-9);
  EXPECT_NEAR(left->normal.x, 1.0, 1e-9);
  for (const glm::dvec3& probe_m : path_m({in_left_m, in_right_m})) {
    const auto place = proxy.follow(probe_m);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->height_m, 0.003 - std::abs(probe_m.x), 1e-9) << probe_m.x;
  }
  const auto right = proxy.follow(in_right_m);
  ASSERT_TRUE(right.has_value());
  EXPECT_NEAR(right->normal.x, -1.0, 1e-9);
}

TEST(SurfaceProxyWalls, AProbeDeeperThanAThinPlateStaysOnItsSideInEveryMotion) {
  // 1.5 mm of 2 mm deep, and below the plate: the other side is nearer.
  const auto surface = proxy_surface_of(PlateShape{{0.06, 0.03, 0.002}});
  ASSERT_GT(surface->facets(), 50'000U);
  for (const double depth_m : {0.0015, 0.003}) {
    for (const double move_m : {0.0002, 0.001, 0.0025, 0.0049}) {
      SurfaceProxy proxy(surface);
      const glm::dvec3 above_m{-0.012, 0.0021, 0.001};
      const glm::dvec3 in_m{-0.012, 0.0021, -depth_m};
      for (const glm::dvec3& probe_m : path_m({above_m, in_m})) proxy.follow(probe_m);
      for (double x_m = in_m.x; x_m < 0.012; x_m += move_m) {
        const auto place = proxy.follow({x_m, in_m.y, in_m.z});
        ASSERT_TRUE(place.has_value());
        ASSERT_NEAR(place->height_m, -depth_m, 1e-9) << move_m << " at " << x_m;
        ASSERT_NEAR(place->normal.z, 1.0, 1e-9);
      }
    }
  }
}

TEST(SurfaceProxyWalls, AProbeUnderARoofStaysOnTheSlopeFromWhichItCame) {
  // Slopes of 45°, 1 mm thick; the probe moves 2 mm below the upper side of the left one towards the ridge.
  constexpr double kThick_m = 0.001 * std::numbers::sqrt2;
  SurfaceProxy proxy(std::make_shared<const BodySurface>(extruded({{-0.02, -0.02 - kThick_m},
                                                                   {0.0, -kThick_m},
                                                                   {0.02, -0.02 - kThick_m},
                                                                   {0.02, -0.02},
                                                                   {0.0, 0.0},
                                                                   {-0.02, -0.02}},
                                                                  0.02)));
  const glm::dvec3 on_m{-0.01, 0.0003, -0.01};
  const glm::dvec3 down_m = 0.002 * glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  const glm::dvec3 under_m = on_m + down_m;
  for (const glm::dvec3& probe_m : path_m({on_m - down_m, under_m})) proxy.follow(probe_m);
  for (const glm::dvec3& probe_m : path_m({under_m, under_m + glm::dvec3(0.006, 0.0, 0.006)})) {
    const auto place = proxy.follow(probe_m);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->height_m, -0.002, 1e-9) << probe_m.x;
    EXPECT_GT(place->normal.z, 0.7);
  }
}

}  // namespace
}  // namespace asperity
