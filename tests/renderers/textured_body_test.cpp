// A mesh prepared for contact: its hull, its triangles in a window, its thickness.

#include "renderers/pd_gradient/contact/textured_body.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/meshes/textured_point.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

constexpr Grating kBodyGrating{.amplitude_m = 0.05e-3, .wavelength_m = 1e-3};

TEST(TexturedBody, HasAHullAroundItsTextureAsFarAwayEverywhere) {
  // Texels and waves do not line up: margins in the atlas go further than the amplitude.
  for (const double wavelength_m : {1e-3, 1.13e-3}) {
    const Grating wave{.amplitude_m = 0.05e-3, .wavelength_m = wavelength_m};
    const TexturedMesh plate = grated_plate(wave);
    const auto highest = *std::max_element(plate.atlas.values.begin(), plate.atlas.values.end());
    EXPECT_GT(highest * plate.atlas.step_m, 1.08 * wave.amplitude_m);
    const TexturedBody body(plate, 2.0);
    const double outward_m =
        glm::distance(body.hull().vertices_m.front(), plate.vertices_m.front());
    EXPECT_NEAR(body.furthest_displacement_m(), outward_m, 1e-15);
    EXPECT_GT(outward_m, 2.0 * 0.99 * wave.amplitude_m);
    EXPECT_LT(outward_m, 2.0 * 1.0001 * wave.amplitude_m);
    for (std::size_t i = 0; i < plate.vertices_m.size(); ++i) {
      const glm::dvec3 moved_m = body.hull().vertices_m[i] - plate.vertices_m[i];
      EXPECT_LT(glm::length(moved_m - outward_m * plate.normals[i]), 1e-12);
    }
    // And nothing of the texture is outside: the upper side lies in z = 0.
    double highest_m = 0.0;
    for (std::size_t triangle = 0; triangle < plate.triangles.size(); ++triangle) {
      for (int i = 0; i <= 40; ++i) {
        for (int j = 0; i + j <= 40; ++j) {
          const glm::dvec3 share = glm::dvec3{40.0 - i - j, i, j} / 40.0;
          highest_m = std::max(highest_m, textured_point_m(plate, triangle, share).z);
        }
      }
    }
    EXPECT_LE(2.0 * highest_m, outward_m + 1e-12);
  }
}

// A saddle, x + y − 2xy in a cell, is highest on an edge between two of its lines of texels.
TEST(TexturedBody, HasAHullAroundAnEdgeThatBulgesBetweenTexels) {
  TexturedMesh plate = formed_plate({.size_m = {1e-3, 1e-3}}, [](double, double) { return 0.0; });
  plate.atlas = {.rows = 2, .columns = 2, .step_m = 1e-6, .values = {0, 100, 100, 0}};
  for (auto& places : plate.places) {
    places = {glm::dvec2{0.1, 0.3}, glm::dvec2{0.7, 0.9}, glm::dvec2{0.5, 0.5}};
  }
  EXPECT_NEAR(TexturedBody(plate, 1.0).furthest_displacement_m(), 52e-6, 1e-12);
}

TEST(TexturedBody, HasAFlatHullWhereItsTextureIsHollow) {
  TexturedMesh plate = textured_plate(4e-3, 0.1e-3, [](double, double) { return -0.1e-3; });
  EXPECT_EQ(TexturedBody(plate, 1.0).hull().vertices_m.front(), plate.vertices_m.front());
  EXPECT_NEAR(TexturedBody(plate, 1.0).furthest_displacement_m(), 0.1e-3, 1e-8);
}

TEST(TexturedBody, KnowsTheWavelengthOfAGrating) {
  for (const double wavelength_m : {0.8e-3, 1.3e-3}) {
    const TexturedBody body(grated_plate({.amplitude_m = 1e-5, .wavelength_m = wavelength_m}), 1.0);
    EXPECT_NEAR(body.finest_wave_m(), wavelength_m, 0.1 * wavelength_m);
  }
}

TEST(TexturedBody, TakesNoRoundingOfItsShapeForDetail) {
  const TexturedMesh sphere = textured_shape(SphereShape{0.006}, *level(0.0F), {.rim_m = 0.001});
  EXPECT_GT(TexturedBody(sphere, 1.0).finest_wave_m(), 1.5e-3);
  const TexturedMesh plain = bare(ball(0.005, 8, 12));
  EXPECT_EQ(TexturedBody(plain, 1.0).finest_wave_m(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(TexturedBody(grated_plate(kBodyGrating), 0.0).finest_wave_m(),
            std::numeric_limits<double>::infinity());
}

TEST(TexturedBody, KeepsNoTexelsForAGainOfZero) {
  const TexturedMesh plate = grated_plate(kBodyGrating);
  const TexturedBody smooth(plate, 0.0);
  EXPECT_LT(smooth.bytes() + 2 * plate.atlas.rows * plate.atlas.columns,
            TexturedBody(plate, 1.0).bytes());
  EXPECT_EQ(smooth.hull().vertices_m, plate.vertices_m);
  EXPECT_EQ(smooth.furthest_displacement_m(), 0.0);
  EXPECT_EQ(smooth.crest_per_m(), 0.0);
}

// Against the definition, triangle by triangle.
TEST(TexturedBody, FindsTheTrianglesThatTouchTheWindowAndLookTheRightWay) {
  const TexturedMesh torus = bare(bumpy_torus(40, 24));
  const TexturedBody body(torus, 1.0);
  const glm::dmat3 turn = turn_about({1.0, -2.0, 0.7}, 0.8);
  const ContactFrame frame{
      .origin_m = {0.03, 0.004, 0.011}, .u = turn[0], .v = turn[1], .n = turn[2]};
  const WindowBox box{.half_width_m = 0.004, .half_height_m = 0.003};
  std::set<std::uint32_t> expected;
  for (std::uint32_t i = 0; i < torus.triangles.size(); ++i) {
    glm::dvec3 low(1.0);
    glm::dvec3 high(-1.0);
    const auto& [a, b, c] = torus.triangles[i];
    for (const std::uint32_t corner : {a, b, c}) {
      const glm::dvec3 place_m = frame.to_frame(torus.vertices_m[corner] - frame.origin_m);
      low = glm::min(low, place_m);
      high = glm::max(high, place_m);
    }
    const glm::dvec3 normal = glm::cross(torus.vertices_m[b] - torus.vertices_m[a],
                                         torus.vertices_m[c] - torus.vertices_m[a]);
    const bool is_in = std::max(low.x, low.y) <= box.half_width_m &&
                       std::min(high.x, high.y) >= -box.half_width_m &&
                       low.z <= box.half_height_m && high.z >= -box.half_height_m;
    if (is_in && glm::dot(normal, frame.n) > 0.0) expected.insert(i);
  }
  ASSERT_GT(expected.size(), 5U);
  std::vector<std::uint32_t> room(torus.triangles.size());
  const std::size_t found = body.find_triangles(frame, frame.n, box, room);
  EXPECT_EQ(std::set(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(found)), expected);
  EXPECT_EQ(found, expected.size());
  std::vector<std::uint32_t> narrow(3);
  EXPECT_EQ(body.find_triangles(frame, frame.n, box, narrow), expected.size());
  EXPECT_TRUE(std::equal(narrow.begin(), narrow.end(), room.begin()));
}

// A short line meets only the boxes near it.
TEST(TexturedBody, FindsTheWayOutWhateverTheLengthOfTheLine) {
  const TriangleMesh torus = bumpy_torus(24, 15);
  const TexturedBody body(bare(torus), 1.0);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle_rad = 0.4 * i;
    const glm::dvec3 from_m = 0.03 * glm::dvec3{std::cos(angle_rad), std::sin(angle_rad), 0.0} +
                              1e-3 * glm::dvec3{std::sin(2.0 * i), std::cos(3.0 * i), 0.0};
    const glm::dvec3 along =
        glm::normalize(glm::dvec3{std::sin(1.3 * i), std::cos(0.7 * i), std::sin(0.2 * i)});
    const WayOut whole = body.way_out(from_m, along, 1.0);
    if (!whole.is_inside) continue;
    ++found;
    for (const double share : {0.5, 0.999}) {
      const WayOut shorter = body.way_out(from_m, along, share * whole.way_m);
      EXPECT_FALSE(shorter.is_inside) << i;
      EXPECT_EQ(shorter.way_m, share * whole.way_m) << i;
    }
    for (const double share : {1.001, 1.5}) {
      const WayOut longer = body.way_out(from_m, along, share * whole.way_m);
      EXPECT_TRUE(longer.is_inside) << i;
      EXPECT_EQ(longer.way_m, whole.way_m) << i;
    }
    EXPECT_FALSE(body.whereabouts(from_m + 1.001 * whole.way_m * along).is_inside) << i;
  }
  EXPECT_GT(found, 150);
}

TEST(TexturedBody, KnowsWhatIsInside) {
  const TexturedBody torus(bare(bumpy_torus(24, 15)), 1.0);
  EXPECT_TRUE(torus.whereabouts({0.03, 0.0, 0.0}).is_inside);
  EXPECT_TRUE(torus.whereabouts({0.0, -0.028, 0.003}).is_inside);
  EXPECT_FALSE(torus.whereabouts({0.0, 0.0, 0.0}).is_inside);  // in the ring's hole
  EXPECT_FALSE(torus.whereabouts({0.03, 0.0, 0.02}).is_inside);
}

TEST(TexturedBody, IsAsThickAsItsPlateHoweverThatIsTurned) {
  for (const double angle_rad : {0.0, 0.6, 1.3}) {
    TexturedMesh plate = bare(box({0.02, 0.03, 0.5e-3}));
    const glm::dmat3 turn = turn_about({1.0, -2.0, 0.7}, angle_rad);
    for (glm::dvec3& vertex_m : plate.vertices_m) vertex_m = turn * vertex_m;
    EXPECT_NEAR(TexturedBody(plate, 1.0).thickness_m(), 0.5e-3, 1e-9);
  }
  EXPECT_NEAR(TexturedBody(bare(ball(0.01, 24, 32)), 1.0).thickness_m(), 0.02, 0.0005);
}

TEST(TexturedBody, RefusesAGainThatIsNoFactor) {
  const TexturedMesh mesh = bare(ball(0.01, 6, 8));
  EXPECT_THROW(TexturedBody(mesh, -1.0), std::invalid_argument);
  EXPECT_THROW(TexturedBody(mesh, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
