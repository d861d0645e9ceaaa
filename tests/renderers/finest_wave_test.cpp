// How fine a texture is, against waves whose length is known, on faces of any proportion.

#include "renderers/pd_gradient/geometry/finest_wave.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "stimuli/meshes/texture_atlas.h"
#include "stimuli/meshes/texture_baking.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

double wave_m(double height_m, double wavelength_m, double at_m) {
  return height_m * std::sin(2.0 * std::numbers::pi * at_m / wavelength_m + 0.4);
}

/// A plate of faces with so many texels along their sides, whose corners are moved by `lean` times y.
template <typename Height>
TexturedMesh relief(const FormedPlate& shape, int texels, double lean, const Height& height_m) {
  TexturedMesh plate = formed_plate(shape, [](double, double) { return 0.0; });
  for (glm::dvec3& vertex_m : plate.vertices_m) vertex_m.x += lean * vertex_m.y;
  fill_atlas(plate, std::vector<int>(plate.triangles.size(), texels),
             [&](std::uint32_t triangle, int i, int j) {
               const auto& [a, b, c] = plate.triangles[triangle];
               const double along = static_cast<double>(i) / texels;
               const double aside = static_cast<double>(j) / texels;
               const glm::dvec3 at_m = (1.0 - along - aside) * plate.vertices_m[a] +
                                       along * plate.vertices_m[b] + aside * plate.vertices_m[c];
               return height_m(at_m.x, at_m.y);
             });
  return plate;
}

TriangleMesh plain_plate(const FormedPlate& shape) {
  const TexturedMesh plate = formed_plate(shape, [](double, double) { return 0.0; });
  return {.vertices_m = plate.vertices_m, .triangles = plate.triangles};
}

// Faces of 8 mm × 0.5 mm: their texels are 16 times as long as wide. As squares of the same area they
// would stand for waves of 0.25 mm in the first case and of 1 mm in the second.
TEST(FinestWave, OfABakedMeshOfSlenderFacesIsThatOfTheOriginal) {
  constexpr FormedPlate kSimple{.size_m = {8e-3, 4e-3}, .cells = {1, 8}};
  const auto baked = [&](const FormedPlate& fine, const auto& height_m) {
    const TexturedMesh original = formed_plate(fine, height_m);
    return bake_texture({.vertices_m = original.vertices_m, .triangles = original.triangles},
                        plain_plate(kSimple), {.samples_per_wavelength = 4.0, .error_samples = 100},
                        {})
        .mesh;
  };
  // A little larger, so that no ray passes beside it.
  const TexturedMesh along = baked({.size_m = {8.5e-3, 4.5e-3}, .cells = {136, 9}},
                                   [](double x_m, double) { return wave_m(2e-5, 1e-3, x_m); });
  EXPECT_NEAR(finest_wave_m(along, 1.0), 1e-3, 0.15e-3);
  const TexturedMesh across = baked({.size_m = {8.5e-3, 4.5e-3}, .cells = {17, 288}},
                                    [](double, double y_m) { return wave_m(5e-6, 0.25e-3, y_m); });
  EXPECT_NEAR(finest_wave_m(across, 1.0), 0.25e-3, 0.04e-3);
}

TEST(FinestWave, HasTheCurvatureOfTheCrestsOfAGrating) {
  for (const double wavelength_m : {1e-3, 2e-3}) {
    const double amplitude_m = 0.02 * wavelength_m;
    const TexturedMesh plate =
        grated_plate({.amplitude_m = amplitude_m, .wavelength_m = wavelength_m});
    const double crest_per_m = amplitude_m * std::pow(2.0 * std::numbers::pi / wavelength_m, 2.0);
    EXPECT_NEAR(fine_waves_of(plate, 1.0).crest_per_m, crest_per_m, 0.15 * crest_per_m);
    EXPECT_NEAR(fine_waves_of(plate, 0.5).crest_per_m, 0.5 * crest_per_m, 0.1 * crest_per_m);
    EXPECT_EQ(fine_waves_of(plate, 0.0).crest_per_m, 0.0);
  }
}

// With the corners moved most, angles are as sharp as 1° and as blunt as 173°, and faces 0.6 mm wide.
TEST(FinestWave, IsTheSameInEveryDirectionOnEveryFace) {
  const auto told_m = [](double lean, double wavelength_m, double angle_rad) {
    const FormedPlate shape{.size_m = {12e-3, 8e-3}, .cells = {2, 2}};
    return finest_wave_m(relief(shape, 128, lean,
                                [&](double x_m, double y_m) {
                                  return wave_m(
                                      1e-5, wavelength_m,
                                      std::cos(angle_rad) * x_m + std::sin(angle_rad) * y_m);
                                }),
                         1.0);
  };
  for (int turn = 0; turn < 4; ++turn) {
    const double angle_rad = std::numbers::pi * turn / 4.0;
    EXPECT_NEAR(told_m(0.0, 0.9e-3, angle_rad), 0.9e-3, 0.1e-3) << turn;
    EXPECT_NEAR(told_m(0.7, 0.9e-3, angle_rad), 0.9e-3, 0.1e-3) << turn;
    EXPECT_NEAR(told_m(8.0, 0.5e-3, angle_rad), 0.5e-3, 0.1e-3) << turn;
  }
}

// Slopes of 6.3 % in the long wave; in the fine one of 6.3 %, of 0.3 % and of 1.1 %, 1/400 and 1/33 of slope².
TEST(FinestWave, CountsWavesThatHoldAShareOfTheSlopeAndNoOthers) {
  const auto with_ripple = [](double height_m) {
    const TexturedMesh plate =
        relief({.size_m = {8e-3, 8e-3}, .cells = {2, 2}}, 256, 0.0, [&](double x_m, double) {
          return wave_m(2e-5, 2e-3, x_m) + wave_m(height_m, 0.2e-3, x_m);
        });
    return finest_wave_m(plate, 1.0);
  };
  EXPECT_LT(with_ripple(2e-6), 0.35e-3);
  EXPECT_NEAR(with_ripple(1e-7), 2e-3, 0.2e-3);
  EXPECT_GT(with_ripple(3.5e-7), 1e-3);
}

TEST(FinestWave, TakesNeitherTheBendOfAFaceNorItsRoundingForDetail) {
  constexpr FormedPlate kPlate{.size_m = {8e-3, 8e-3}, .cells = {2, 2}};
  // A quarter of a millimetre of sag, with slopes of 6 %.
  const TexturedMesh bent = relief(
      kPlate, 256, 0.0, [](double x_m, double y_m) { return 8.0 * (x_m * x_m + x_m * y_m); });
  EXPECT_EQ(finest_wave_m(bent, 1.0), std::numeric_limits<double>::infinity());
  const TexturedMesh waved =
      relief(kPlate, 256, 0.0, [](double x_m, double) { return wave_m(1e-5, 1e-3, x_m); });
  EXPECT_NEAR(finest_wave_m(waved, 1.0), 1e-3, 0.1e-3);
  // In steps of 0.5 µm on texels of 16 µm, which alone are slopes of 1.3 %.
  TexturedMesh stepped = waved;
  stepped.atlas.step_m = 5e-7;
  for (std::size_t i = 0; i < waved.atlas.values.size(); ++i) {
    const double height_m = waved.atlas.step_m * waved.atlas.values[i];
    stepped.atlas.values[i] = static_cast<std::int16_t>(std::lround(height_m / 5e-7));
  }
  EXPECT_NEAR(finest_wave_m(stepped, 1.0), 1e-3, 0.3e-3);
  // A gain that leaves slopes of 0.04 %.
  EXPECT_EQ(finest_wave_m(waved, 0.01), std::numeric_limits<double>::infinity());
  EXPECT_EQ(finest_wave_m(waved, 0.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(finest_wave_m(bare(plain_plate(kPlate)), 1.0), std::numeric_limits<double>::infinity());
}

// A file may hold a face with two corners at nearly one place. It has as many texels, and no relief to be felt.
TEST(FinestWave, OfAFaceDrawnOutToNothingIsThatOfTheOthers) {
  const FormedPlate shape{.size_m = {12e-3, 8e-3}, .cells = {2, 2}};
  TexturedMesh mesh =
      relief(shape, 32, 0.0, [](double x_m, double) { return wave_m(20e-6, 1e-3, x_m); });
  const auto& [a, b, c] = mesh.triangles.front();
  for (const double apart_m : {1e-60, 1e-100, 1e-150}) {
    mesh.vertices_m[a] = {0.0, 0.0, 0.0};
    mesh.vertices_m[b] = {apart_m, 0.0, 0.0};
    mesh.vertices_m[c] = {0.0, 0.01, 0.0};
    const double found_m = finest_wave_m(mesh, 1.0);
    EXPECT_GT(found_m, 0.1e-3) << apart_m;
    EXPECT_LT(found_m, 3e-3) << apart_m;
  }
}

}  // namespace
}  // namespace asperity
