// The plain sampling of a surface along n: what stands where, and what is refused.

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/sampling/reference_penetration.h"
#include "tests/renderers/pd_gradient_surfaces.h"

namespace asperity {
namespace {

const auto kFlat = [](double, double) { return 0.0; };

// Over the displaced plate z = d, tilted by α about v, the point over (x, 0) is that whose
// undisplaced point is there: x/cos α along the plate. It stands at −x·tan α + d·cos α.
TEST(SurfaceSampling, PutsTheDisplacedPointAtItsUndisplacedPlace) {
  const double kSlope = 0.02;
  const TexturedMesh plate =
      textured_plate(0.010, 0.001, [&](double x_m, double) { return kSlope * x_m; });
  const std::vector<std::uint32_t> triangles = all_triangles(plate);
  const double kTilt_rad = 0.3;
  const ContactPatch patch{
      .mesh = plate, .triangles = triangles, .pose = {turn_about({0, 1, 0}, kTilt_rad), {}}};
  const SamplingGrid grid{.width_m = 0.006, .samples = 7};
  const SampledSurface surface = sample_surface(patch, {}, grid, Facing::along_n);
  for (int column = 0; column < 7; ++column) {
    const double x_m = grid.place_m(column);
    const double expected_m = -x_m * std::tan(kTilt_rad) + kSlope * x_m;  // d·cos α = slope·x
    EXPECT_NEAR(surface.height_m[static_cast<std::size_t>(3 * 7 + column)], expected_m, 1e-8);
  }
}

TEST(SurfaceSampling, LeavesNoCrackBetweenFaces) {
  const TexturedMesh plate = formed_plate({.size_m = {0.02, 0.02}, .cells = {40, 40}}, kFlat);
  const std::vector<std::uint32_t> triangles = all_triangles(plate);
  const SamplingGrid grid{.width_m = 0.013, .samples = 61};
  for (int i = 0; i < 8; ++i) {  // at 0 and 45° samples lie on edges and on vertices
    const Pose pose{.rotation = turn_about({0, 0, 1}, i * std::numbers::pi / 16.0)};
    const SampledSurface surface = sample_surface(
        {.mesh = plate, .triangles = triangles, .pose = pose}, {}, grid, Facing::along_n);
    EXPECT_EQ(std::count(surface.covered.begin(), surface.covered.end(), 1), 61 * 61);
    EXPECT_EQ(surface.folded, 0);
  }
}

TEST(SurfaceSampling, SeesOnlyFacesThatLookTheRightWay) {
  const TexturedMesh plate = formed_plate({.size_m = {0.02, 0.02}}, kFlat);
  const std::vector<std::uint32_t> triangles = all_triangles(plate);
  const SamplingGrid grid{.width_m = 0.01, .samples = 5};
  const auto covered = [&](const glm::dmat3& rotation, Facing facing) {
    const SampledSurface surface = sample_surface(
        {.mesh = plate, .triangles = triangles, .pose = {.rotation = rotation}}, {}, grid, facing);
    return std::count(surface.covered.begin(), surface.covered.end(), 1);
  };
  EXPECT_EQ(covered(glm::dmat3(1.0), Facing::along_n), 25);
  EXPECT_EQ(covered(glm::dmat3(1.0), Facing::against_n), 0);
  EXPECT_EQ(covered(upside_down({}).rotation, Facing::against_n), 25);
  EXPECT_GT(covered(turn_about({1, 0, 0}, 1.50), Facing::along_n), 0);  // 85.9°
  EXPECT_EQ(covered(turn_about({1, 0, 0}, 1.56), Facing::along_n), 0);  // 89.4°: a wall
}

TEST(SurfaceSampling, TakesTheOutermostSheetAndCountsTheFold) {
  TexturedMesh sheets = formed_plate({.size_m = {0.02, 0.02}}, kFlat);
  const TexturedMesh upper =
      formed_plate({.size_m = {0.02, 0.02}}, [](double, double) { return 0.001; });
  const auto below = static_cast<std::uint32_t>(sheets.vertices_m.size());
  sheets.vertices_m.insert(sheets.vertices_m.end(), upper.vertices_m.begin(),
                           upper.vertices_m.end());
  sheets.normals.insert(sheets.normals.end(), upper.normals.begin(), upper.normals.end());
  sheets.places.insert(sheets.places.end(), upper.places.begin(), upper.places.end());
  for (const auto& [a, b, c] : upper.triangles) {
    sheets.triangles.insert(sheets.triangles.begin(), {a + below, b + below, c + below});
  }
  const std::vector<std::uint32_t> triangles = all_triangles(sheets);
  const SamplingGrid grid{.width_m = 0.01, .samples = 3};
  const auto middle_m = [&](const Pose& pose, Facing facing) {
    const SampledSurface surface =
        sample_surface({.mesh = sheets, .triangles = triangles, .pose = pose}, {}, grid, facing);
    EXPECT_GE(surface.folded, 9);
    return surface.height_m[4];
  };
  EXPECT_EQ(middle_m({}, Facing::along_n), 0.001);
  EXPECT_EQ(middle_m(upside_down({}), Facing::against_n), -0.001);
}

TEST(SurfaceSampling, RefusesWhatIsNoContact) {
  const TexturedMesh plate = formed_plate({.size_m = {0.02, 0.02}}, kFlat);
  const std::vector<std::uint32_t> triangles = all_triangles(plate);
  const SamplingGrid grid{.width_m = 0.01, .samples = 3};
  const double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [&](auto change) {
    TexturedMesh mesh = plate;
    ContactFrame frame;
    SamplingGrid window = grid;
    std::vector<std::uint32_t> chosen = triangles;
    Pose pose;
    change(mesh, frame, window, chosen, pose);
    EXPECT_THROW(sample_surface({.mesh = mesh, .triangles = chosen, .pose = pose}, frame, window,
                                Facing::along_n),
                 std::invalid_argument);
  };
  refuses([](auto&, auto& frame, auto&, auto&, auto&) { frame.n = {0, 0, -1}; });
  refuses([](auto&, auto& frame, auto&, auto&, auto&) { frame.u = {1, 0.1, 0}; });
  refuses([&](auto&, auto& frame, auto&, auto&, auto&) { frame.origin_m.x = kNotANumber; });
  refuses([](auto&, auto&, auto& window, auto&, auto&) { window.width_m = 0.0; });
  refuses([](auto&, auto&, auto& window, auto&, auto&) { window.samples = 1; });
  refuses([](auto&, auto&, auto&, auto& chosen, auto&) { chosen.push_back(2); });
  refuses([&](auto&, auto&, auto&, auto&, auto& pose) { pose.rotation[1].y = kNotANumber; });
  refuses([](auto& mesh, auto&, auto&, auto&, auto&) { mesh.normals.pop_back(); });
  refuses([](auto& mesh, auto&, auto&, auto&, auto&) { mesh.places.pop_back(); });
  refuses([](auto& mesh, auto&, auto&, auto&, auto&) { mesh.triangles[0][1] = 4; });
  refuses([](auto& mesh, auto&, auto&, auto&, auto&) { mesh.atlas.values.pop_back(); });
  refuses([&](auto& mesh, auto&, auto&, auto&, auto&) { mesh.vertices_m[0].z = kNotANumber; });
}

}  // namespace
}  // namespace asperity
