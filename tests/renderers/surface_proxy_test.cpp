// The proxy of a probe on the surface of a body.

#include "renderers/proxy/surface_proxy.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/proxy_paths.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

constexpr double kSphereRadius_m = 0.02;

/// 600 000 facets take a second to make.
const std::shared_ptr<const BodySurface>& sphere_surface() {
  static const auto kSurface = proxy_surface_of(SphereShape{2.0 * kSphereRadius_m});
  return kSurface;
}
const std::shared_ptr<const BodySurface>& box_surface() {
  static const auto kSurface = proxy_surface_of(BoxShape{{0.03, 0.03, 0.03}});
  return kSurface;
}

TEST(SurfaceProxy, HeightAboveASphereIsTheDistanceFromIt) {
  const glm::dvec3 centre_m{0.0, 0.0, -kSphereRadius_m};
  SurfaceProxy proxy(sphere_surface());
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 out =
        glm::normalize(glm::dvec3(random.normal(), random.normal(), random.normal()));
    const double height_m = 0.006 * (random.uniform() - 0.5);
    proxy.reset();
    const auto place = proxy.follow(centre_m + (kSphereRadius_m + height_m) * out);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->height_m, height_m, 1e-6);
    EXPECT_GT(glm::dot(place->normal, out), 1.0 - 1e-6);
    EXPECT_NEAR(glm::distance(place->point_m, centre_m + kSphereRadius_m * out), 0.0, 1e-5);
  }
}

TEST(SurfaceProxy, IsTheSameAlongAPathAsFromASearch) {
  SurfaceProxy following(sphere_surface());
  for (int i = 0; i < 3000; ++i) {
    const double angle_rad = kFast_m_per_s * kProxyTick_s * i / kSphereRadius_m;
    const glm::dvec3 probe_m =
        glm::dvec3(0.0, 0.0, -kSphereRadius_m) +
        (kSphereRadius_m - 0.001) *
            glm::dvec3(std::sin(angle_rad), 0.3 * std::sin(0.1 * angle_rad), std::cos(angle_rad));
    SurfaceProxy fresh(sphere_surface());
    const auto place = following.follow(probe_m);
    const auto searched = fresh.follow(probe_m);
    ASSERT_TRUE(place && searched);
    EXPECT_NEAR(place->height_m, searched->height_m, 1e-12);
    EXPECT_NEAR(glm::distance(place->point_m, searched->point_m), 0.0, 1e-9);
  }
}

TEST(SurfaceProxy, PointAndNormalHaveNoStepsAtTheEdgesOfFacets) {
  // Coarse facets: neighbours are inclined to each other by up to 7°.
  const auto surface = std::make_shared<const BodySurface>(ball(0.02, 25, 50));
  SurfaceProxy proxy(surface);
  std::optional<ProxyPlace> last{};
  constexpr double kStep_m = 1e-6;
  constexpr double kHeight_m = -0.001;
  for (int i = 0; i < 20'000; ++i) {
    const double angle_rad = 0.3 + kStep_m * i / 0.019;
    const auto place =
        proxy.follow((0.02 + kHeight_m) * glm::dvec3(std::cos(angle_rad), 0.6 * std::sin(angle_rad),
                                                     0.8 * std::sin(angle_rad)));
    ASSERT_TRUE(place.has_value());
    if (last) {
      EXPECT_LT(glm::distance(place->point_m, last->point_m), 1.5 * kStep_m);
      EXPECT_LT(glm::distance(place->normal, last->normal), 1.5 * kStep_m / 0.02);
      EXPECT_LT(std::abs(place->height_m - last->height_m), 1.5 * kStep_m);
    }
    last = place;
  }
}

TEST(SurfaceProxy, ForceIsContinuousOverTheEdgeOfABox) {
  // Around the edge at a height of 0.5 mm outside and, less deep than the rounding of the edge, inside.
  for (const double height_m : {0.0005, -5e-6}) {
    SurfaceProxy proxy(box_surface());
    std::optional<ProxyPlace> last{};
    const glm::dvec3 corner_m{0.015 + height_m, 0.0, height_m};
    for (const glm::dvec3& probe_m :
         path_m({{0.01, 0.001, height_m}, corner_m, {0.015 + height_m, 0.001, -0.005}}, 0.002)) {
      const auto place = proxy.follow(probe_m);
      ASSERT_TRUE(place.has_value());
      // k = 1 N/mm: 20 mN at most in 2 µm.
      if (last) {
        EXPECT_LT(glm::distance(1000.0 * place->height_m * place->normal,
                                1000.0 * last->height_m * last->normal),
                  0.02)
            << probe_m.x << ' ' << probe_m.z;
      }
      last = place;
    }
  }
}

TEST(SurfaceProxy, SlidesOffTheEdgeOfABox) {
  SurfaceProxy proxy(box_surface());
  for (const glm::dvec3& probe_m : path_m({{0.0, 0.001, 0.002}, {0.01, 0.001, -0.002}})) {
    proxy.follow(probe_m);
  }
  for (const glm::dvec3& probe_m : path_m({{0.01, 0.001, -0.002}, {0.02, 0.001, -0.002}})) {
    const auto place = proxy.follow(probe_m);
    ASSERT_TRUE(place.has_value());
    // Pushed upwards as long as the upper side is above it, then to the side or not at all.
    EXPECT_GT(place->height_m, -0.00201);
    if (probe_m.x < 0.0149) {
      EXPECT_NEAR(place->height_m, -0.002, 1e-9);
      EXPECT_GT(place->normal.z, 0.9999);
    }
    if (probe_m.x > 0.0151) {
      EXPECT_GT(place->height_m, 0.0);
    }
  }
}

TEST(SurfaceProxy, DoesNotStickInAConcaveCorner) {
  const auto surface = grooved_block();
  const glm::dvec3 in_m{0.0, 0.0003, -0.0065};      // 1.5 mm below the bottom of the groove
  const glm::dvec3 wall_m{0.003, 0.0003, -0.0035};  // 1.06 mm below the wall, at 45°
  SurfaceProxy proxy(surface);
  for (const glm::dvec3& probe_m : path_m({{0.0, 0.0003, 0.0}, in_m})) proxy.follow(probe_m);
  const auto corner = proxy.follow(in_m);
  ASSERT_TRUE(corner.has_value());
  EXPECT_NEAR(corner->height_m, -0.0015, 1e-5);
  EXPECT_GT(corner->normal.z, 0.99);
  for (const glm::dvec3& probe_m : path_m({in_m, wall_m})) {
    const auto place = proxy.follow(probe_m);
    SurfaceProxy fresh(surface);
    const auto searched = fresh.follow(probe_m);
    ASSERT_TRUE(place && searched);
    // No memory of the corner, and no tangential pull back to it.
    EXPECT_NEAR(place->height_m, searched->height_m, 1e-5);
    EXPECT_NEAR(glm::distance(place->normal, searched->normal), 0.0, 1e-3);
  }
  const auto wall = proxy.follow(wall_m);
  ASSERT_TRUE(wall.has_value());
  EXPECT_NEAR(wall->height_m, -std::numbers::sqrt2 * 0.00075, 1e-9);
  EXPECT_NEAR(glm::dot(wall->normal, glm::dvec3(-1.0, 0.0, 1.0)), std::numbers::sqrt2, 1e-9);
}

TEST(SurfaceProxy, StaysOnTheSideOfAThinPlateFromWhichItCame) {
  SurfaceProxy proxy(proxy_surface_of(PlateShape{{0.03, 0.03, 0.002}}));
  for (const glm::dvec3& probe_m : path_m({{0.001, 0.002, 0.001}, {0.001, 0.002, -0.003}})) {
    const auto place = proxy.follow(probe_m);
    ASSERT_TRUE(place.has_value());
    EXPECT_NEAR(place->height_m, probe_m.z, 1e-9);
    EXPECT_NEAR(place->normal.z, 1.0, 1e-9);
  }
}

TEST(SurfaceProxy, HasNoPlaceBeyondItsReachAndIsFoundAgain) {
  SurfaceProxy proxy(sphere_surface());
  EXPECT_FALSE(proxy.follow({0.0, 0.0, 0.05}).has_value());
  for (const glm::dvec3& probe_m : path_m({{0.0, 0.0, 0.05}, {0.0, 0.0, -0.001}})) {
    const auto place = proxy.follow(probe_m);
    EXPECT_EQ(place.has_value(), probe_m.z <= SurfaceProxy::kReach_m) << probe_m.z;
    if (place) {
      EXPECT_NEAR(place->height_m, probe_m.z, 1e-6);
    }
  }
  for (const glm::dvec3& probe_m : path_m({{0.0, 0.0, -0.001}, {0.0, 0.0, 0.05}})) {
    EXPECT_EQ(proxy.follow(probe_m).has_value(), probe_m.z <= SurfaceProxy::kReach_m);
  }
}

TEST(SurfaceProxy, BeginsInsideABodyWithAHeightBelowZero) {
  SurfaceProxy proxy(box_surface());
  const auto place = proxy.follow({0.001, 0.002, -0.012});
  ASSERT_TRUE(place.has_value());
  EXPECT_NEAR(place->height_m, -0.012, 1e-9);
}

void expect_bounded_force(std::uint32_t around, std::uint32_t along) {
  constexpr double kProxyStiffness_N_per_m = 1000.0;
  const TriangleMesh mesh = bumpy_torus(around, along);
  const SurfaceSearch truth(mesh);
  SurfaceProxy proxy(std::make_shared<const BodySurface>(mesh));
  double fastest_m = 0.0;
  glm::dvec3 last_m{0.0};
  double greatest_N = 0.0;
  // Neither angle moves by more than 0.2 mm in a tick.
  const std::vector<glm::dvec3> probes_m =
      stroke_in_torus_m(0.001, kFast_m_per_s * kProxyTick_s, 10'000);
  for (std::size_t i = 0; i < probes_m.size(); ++i) {
    if (i > 0) fastest_m = std::max(fastest_m, glm::distance(probes_m[i], last_m));
    last_m = probes_m[i];
    const auto place = proxy.follow(probes_m[i]);
    ASSERT_TRUE(place.has_value());
    ASSERT_LT(place->height_m, 0.0);
    const double force_N = -kProxyStiffness_N_per_m * place->height_m;
    const double true_N = kProxyStiffness_N_per_m * truth.nearest(probes_m[i]).distance_m;
    EXPECT_LE(force_N, 1.05 * true_N + 0.020) << i;
    EXPECT_GE(force_N, true_N - 1e-9);  // no facet is nearer than the nearest one
    greatest_N = std::max(greatest_N, force_N);
  }
  EXPECT_GT(fastest_m, 0.9 * kFast_m_per_s * kProxyTick_s);
  EXPECT_GT(greatest_N, 0.9);
}

TEST(SurfaceProxy, KeepsUpWithAFastHandOnAHundredThousandTriangles) {
  expect_bounded_force(316, 159);
}

TEST(SurfaceProxy, KeepsUpWithAFastHandOnSixHundredThousandTriangles) {
  expect_bounded_force(775, 388);
}

/// A motion past the edge of a box with a part of the way in one tick.
struct Gap {
  const char* name = "";
  double depth_m = 0.0;
  double from_x_m = 0.0;
  double way_m = 0.0;  ///< in one tick
  double speed_m_per_s = kFast_m_per_s;
};

TEST(SurfaceProxy, NoForceInFreeAirAfterAGapPastTheEdgeOfABox) {
  constexpr double kHalfSide_m = 0.015;
  ASSERT_GT(box_surface()->facets(), 500'000U);
  for (const Gap& gap :
       {Gap{.name = "1 m/s",
       .depth_m = 0.003,
       .from_x_m = 0.0,
       .way_m = 0.001,
       .speed_m_per_s = 1.0},
        Gap{.name = "5 ms", .depth_m = 0.003, .from_x_m = 0.0142, .way_m = 0.001},
        Gap{.name = "25 ms", .depth_m = 0.006, .from_x_m = 0.0142, .way_m = 0.005},
        Gap{.name = "50 ms", .depth_m = 0.0105, .from_x_m = 0.0142, .way_m = 0.010},
        Gap{.name = "100 ms", .depth_m = 0.001, .from_x_m = 0.0142, .way_m = 0.020}}) {
    SurfaceProxy proxy(box_surface());
    const glm::dvec3 over_m{0.0, 0.001, 0.001};
    const glm::dvec3 in_m{0.0, 0.001, -gap.depth_m};
    const glm::dvec3 before_m{gap.from_x_m, 0.001, -gap.depth_m};
    for (const glm::dvec3& probe_m : path_m({over_m, in_m, before_m})) proxy.follow(probe_m);
    const glm::dvec3 after_m = before_m + glm::dvec3(gap.way_m, 0.0, 0.0);
    for (const glm::dvec3& probe_m :
         path_m({after_m, after_m + glm::dvec3(0.02, 0.0, 0.0)}, gap.speed_m_per_s)) {
      const auto place = proxy.follow(probe_m);
      if (probe_m.x <= kHalfSide_m || !place) continue;
      EXPECT_NEAR(place->height_m, probe_m.x - kHalfSide_m, 1e-4) << gap.name;
    }
  }
}

TEST(SurfaceProxy, NoForceInFreeAirBehindABodyAfterAGap) {
  SurfaceProxy proxy(box_surface());
  for (const glm::dvec3& probe_m : path_m({{0.001, 0.002, 0.002}, {0.001, 0.002, -0.001}})) {
    proxy.follow(probe_m);
  }
  const auto behind = proxy.follow({0.001, 0.002, -0.032});
  ASSERT_TRUE(behind.has_value());
  EXPECT_NEAR(behind->height_m, 0.002, 1e-9);
  EXPECT_NEAR(behind->normal.z, -1.0, 1e-9);
}

TEST(SurfaceProxy, DoesNotTouchTheHeap) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  SurfaceProxy proxy(grooved_block());
  const std::vector<glm::dvec3> probes_m = path_m({{0.0, 0.0, 0.05},
                                                   {0.0, 0.0, -0.008},
                                                   {0.01, 0.0, -0.002},
                                                   {0.03, 0.0, -0.002},
                                                   {0.03, 0.0, 0.05}});
  const AllocationGuard guard;
  for (const glm::dvec3& probe_m : probes_m) proxy.follow(probe_m);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
