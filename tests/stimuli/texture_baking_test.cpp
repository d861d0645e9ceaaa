// The detail of a fine mesh, as displacements on a simple one.

#include "stimuli/meshes/texture_baking.h"

#include <atomic>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "stimuli/meshes/mesh_decimation.h"
#include "stimuli/meshes/mesh_edges.h"
#include "stimuli/meshes/texture_atlas.h"
#include "stimuli/meshes/textured_point.h"
#include "tests/stimuli/made_mesh.h"

namespace asperity::test {
namespace {

constexpr BakeSettings kQuick{.error_samples = 5000};

BakedMesh baked(const TriangleMesh& original, std::size_t triangles, unsigned jobs = 1,
                const BakeSettings& settings = kQuick) {
  return bake_texture(original, decimate_mesh(original, triangles, "thing").mesh, settings,
                      {jobs, {}});
}

int texels_along(const TexturedMesh& mesh, std::size_t triangle) {
  const glm::dvec2 leg = glm::abs(mesh.places[triangle][1] - mesh.places[triangle][0]);
  return static_cast<int>(std::lround(std::max(leg.x, leg.y)));
}

// The original is a ball but for its own facets, which at level 6 (side 1/64 · π/2 R) leave R·(π/128)²/8 = 7.5·10⁻⁵ R
// at most; the texture has to find the ball again from 100 triangles that leave 500 times as much.
TEST(Baking, FindsABallAgainOnAFewTriangles) {
  constexpr double kRadius_m = 0.02;
  const BakedMesh result = baked(smooth_ball(6, kRadius_m), 100);
  double largest_m = 0.0;
  for (std::size_t triangle = 0; triangle < result.mesh.triangles.size(); ++triangle) {
    for (const glm::dvec3& b : {glm::dvec3{1.0 / 3.0}, glm::dvec3{0.5, 0.3, 0.2},
                                glm::dvec3{0.0, 0.37, 0.63}, glm::dvec3{0.9, 0.1, 0.0}}) {
      const double radius_m = glm::length(textured_point_m(result.mesh, triangle, b));
      largest_m = std::max(largest_m, std::abs(radius_m - kRadius_m));
    }
  }
  EXPECT_LT(largest_m, 3e-4 * kRadius_m);
  EXPECT_GT(result.report.plain.max_m, 0.02 * kRadius_m);
}

TEST(Baking, LeavesATenthOfTheErrorOfTheSimplifiedMesh) {
  const BakedMesh result = baked(ring(160, 80, 0.0004), 400);
  EXPECT_GT(result.report.plain.rms_m, 1e-4);
  EXPECT_LT(result.report.textured.rms_m, 0.1 * result.report.plain.rms_m);
  EXPECT_LT(result.report.textured.max_m, result.report.plain.max_m);
  EXPECT_EQ(result.report.missed, 0U);
  EXPECT_EQ(result.report.folded_faces, 0U);
}

// The error that is told is one of places on the textured surface: spoiling the texture must show in it.
TEST(Baking, MeasuresItsErrorOnTheTextureItself) {
  const TriangleMesh original = bumpy_ball(5, 0.02, 0.0005, 9.0);
  BakedMesh result = baked(original, 300);
  const std::vector<glm::dvec3> samples_m = surface_samples(original, 5000);
  const GeometricError as_told = textured_error(samples_m, result.mesh, {});
  EXPECT_DOUBLE_EQ(as_told.rms_m, result.report.textured.rms_m);
  EXPECT_LT(as_told.rms_m, 0.1 * result.report.plain.rms_m);
  result.mesh.atlas.step_m *= 1.5;  // everything half as far again
  EXPECT_GT(textured_error(samples_m, result.mesh, {}).rms_m, 0.3 * result.report.plain.rms_m);
  std::fill(result.mesh.atlas.values.begin(), result.mesh.atlas.values.end(), std::int16_t{0});
  EXPECT_NEAR(textured_error(samples_m, result.mesh, {}).rms_m, result.report.plain.rms_m,
              0.05 * result.report.plain.rms_m);
}

// Two sheets, 0.3 mm apart, that a texture lifts by 0.5 mm: over the lower one then lies what was the upper one.
TEST(Baking, FindsNoErrorAtPlacesOfTheTextureItselfOnAThinPart) {
  constexpr double kHalf_m = 0.005;
  TexturedMesh mesh{};
  for (const double z_m : {0.0, -0.3e-3}) {
    const bool is_upper = z_m == 0.0;
    const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
    for (const glm::dvec2& corner : {glm::dvec2{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      mesh.vertices_m.emplace_back(kHalf_m * corner, z_m);
      mesh.normals.emplace_back(0.0, 0.0, is_upper ? 1.0 : -1.0);
    }
    for (const auto& [a, b, c] : {std::array<std::uint32_t, 3>{0, 1, 2}, {2, 3, 0}}) {
      mesh.triangles.push_back({first + a, first + (is_upper ? b : c), first + (is_upper ? c : b)});
    }
  }
  fill_atlas(mesh, {128, 128, 128, 128}, [&](std::uint32_t triangle, int i, int j) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    const glm::dvec3 at_m =
        (mesh.vertices_m[a] * (128.0 - i - j) + mesh.vertices_m[b] * static_cast<double>(i) +
         mesh.vertices_m[c] * static_cast<double>(j)) /
        128.0;
    const double x = at_m.x / kHalf_m;
    const double y = at_m.y / kHalf_m;
    return 0.5e-3 * (1.0 - x * x) * (1.0 - y * y) * mesh.normals[a].z;
  });
  std::vector<glm::dvec3> samples_m{};
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    for (int i = 0; i <= 23; ++i) {
      for (int j = 0; i + j <= 23; ++j) {
        samples_m.push_back(
            textured_point_m(mesh, triangle, glm::dvec3{23.0 - i - j, i, j} / 23.0));
      }
    }
  }
  EXPECT_LT(textured_error(samples_m, mesh, {}).max_m, 1e-6);
}

// A pit of 30 mm in a block of 50 mm, whose vertices lie at most 20 mm from the block. In the middle of a
// side the mean of its corners' normals is 0.58 long, and the floor is as far as 52 mm of displacement.
TEST(Baking, NeverDisplacesFurtherThanTwiceAsFarAsVerticesOfTheOriginalLie) {
  std::set<std::array<int, 3>> cells{};
  for (int x = 0; x < 11; ++x) {
    for (int y = 0; y < 11; ++y) {
      for (int z = 0; z < 5; ++z) {
        const bool is_pit = x >= 4 && x <= 6 && y >= 4 && y <= 6 && z >= 2;
        if (!is_pit) cells.insert({x, y, z});
      }
    }
  }
  const BakedMesh result =
      bake_texture(cubes(cells), box({0.055, 0.055, 0.025}, {0.055, 0.055, 0.025}), kQuick, {});
  double furthest_m = 0.0;
  for (const std::int16_t value : result.mesh.atlas.values) {
    furthest_m = std::max(furthest_m, std::abs(value * result.mesh.atlas.step_m));
  }
  EXPECT_LE(furthest_m, 0.0401);
  EXPECT_GT(result.report.missed, 0U);
}

TEST(Baking, SaysWhereATextureMakesAMeshWorse) {
  const auto said = [](const GeometricError& plain, const GeometricError& textured) {
    BakeReport report{};
    report.plain = plain;
    report.textured = textured;
    return warning_of(report).value_or("");
  };
  EXPECT_EQ(said({1e-4, 4e-4}, {1e-5, 2e-4}), "");
  EXPECT_EQ(said({0.0, 0.0}, {1e-9, 1e-8}), "");  // of a mesh onto itself
  EXPECT_EQ(
      said({1e-4, 4e-4}, {1e-5, 5e-4}),
      "At its worst point the mesh lies 500.0 µm from the original with its texture and 400.0 µm "
      "without: there the texture increases this distance. Increase the number of triangles.");
  EXPECT_EQ(said({1e-4, 4e-4}, {2e-4, 5e-4}),
            "The mesh lies 200.0 µm from the original with its texture and 100.0 µm without (RMS): "
            "the texture increases this distance. Increase the number of triangles.");
}

TEST(Baking, HoldsTheSameDisplacementOnBothSidesOfEveryEdge) {
  const BakedMesh result = baked(ring(96, 48, 0.0004), 300);
  const TexturedMesh& mesh = result.mesh;
  const auto opposite = opposite_half_edges(mesh.triangles);
  double largest_m = 0.0;
  double variation_m = 0.0;
  bool sides_differ = false;
  for (std::uint32_t half = 0; half < opposite.size(); ++half) {
    const std::uint32_t other = opposite[half];
    sides_differ = sides_differ || texels_along(mesh, half / 3) != texels_along(mesh, other / 3);
    double last_m = 0.0;
    for (int k = 0; k <= 200; ++k) {
      const double part = k / 200.0;
      const auto displaced_m = [&](std::uint32_t edge, double along) {
        const auto& places = mesh.places[edge / 3];
        return displacement_m(mesh.atlas, (1.0 - along) * places[edge % 3] +
                                              along * places[next_half_edge(edge) % 3]);
      };
      const double own_m = displaced_m(half, part);
      largest_m = std::max(largest_m, std::abs(own_m - displaced_m(other, 1.0 - part)));
      if (k > 0) variation_m = std::max(variation_m, std::abs(own_m - last_m));
      last_m = own_m;
    }
  }
  EXPECT_LE(largest_m, 1.0001 * mesh.atlas.step_m);
  EXPECT_GT(variation_m, 20.0 * mesh.atlas.step_m);  // there was something to differ in
  EXPECT_TRUE(sides_differ) << "no edge between a coarse and a fine face was tried";
}

TEST(Baking, NeverReadsAnotherFacesTexels) {
  const BakedMesh result = baked(bumpy_ball(4, 0.02, 0.0005, 9.0), 150);
  const TexturedMesh& mesh = result.mesh;
  // The four texels around each place of a face, its border included, belong to that face alone.
  std::vector<std::uint32_t> owner(mesh.atlas.values.size(), kNoHalfEdge);
  std::size_t shared = 0;
  for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const int n = texels_along(mesh, triangle);
    for (int j = 0; j <= 2 * n; ++j) {
      for (int i = 0; i + j <= 2 * n; ++i) {
        const double b = i / (2.0 * n);
        const double c = j / (2.0 * n);
        const auto& t = mesh.places[triangle];
        const glm::dvec2 place = (1.0 - b - c) * t[0] + b * t[1] + c * t[2];
        for (const double aside : {-0.01, 0.01}) {
          const auto column = static_cast<std::size_t>(place.x + aside);
          const auto row = static_cast<std::size_t>(place.y + aside);
          for (const std::size_t texel :
               {row * mesh.atlas.columns + column, row * mesh.atlas.columns + column + 1,
                (row + 1) * mesh.atlas.columns + column,
                (row + 1) * mesh.atlas.columns + column + 1}) {
            ASSERT_LT(texel, owner.size());
            if (owner[texel] == kNoHalfEdge) owner[texel] = triangle;
            if (owner[texel] != triangle) ++shared;
          }
        }
      }
    }
  }
  EXPECT_EQ(shared, 0U);
}

TEST(Baking, TakesEightTexelsForTwoEdgesOfTheOriginal) {
  const TriangleMesh original = smooth_ball(5, 0.02);
  const BakedMesh result = baked(original, 100);
  // The largest triangle of the original, as if its sides were equal, holds the longest waves.
  double longest_m = 0.0;
  for (const auto& [a, b, c] : original.triangles) {
    const double doubled_m2 =
        glm::length(glm::cross(original.vertices_m[b] - original.vertices_m[a],
                               original.vertices_m[c] - original.vertices_m[a]));
    longest_m = std::max(longest_m, std::sqrt(2.0 / std::sqrt(3.0) * doubled_m2));
  }
  EXPECT_LE(result.report.coarsest_pitch_m, 2.0 * longest_m / 8.0);
  EXPECT_DOUBLE_EQ(result.report.samples_per_wavelength, 8.0);
}

TEST(Baking, SaysWhatItReachedWhereTexelsAreShort) {
  const TriangleMesh original = smooth_ball(5, 0.02);
  const BakedMesh result = baked(original, 100, 1, {.most_texels = 30'000, .error_samples = 1000});
  EXPECT_LE(result.mesh.atlas.values.size(), 40'000U);
  EXPECT_LT(result.report.samples_per_wavelength, 8.0);
  EXPECT_GE(result.report.samples_per_wavelength, 1.0);
}

TEST(Baking, GivesTheSameWithAnyNumberOfThreads) {
  const TriangleMesh original = bumpy_ball(4, 0.02, 0.0005, 9.0);
  const BakedMesh one = baked(original, 200, 1);
  const BakedMesh three = baked(original, 200, 3);
  EXPECT_EQ(one.mesh.atlas.values, three.mesh.atlas.values);
  EXPECT_EQ(one.mesh.atlas.step_m, three.mesh.atlas.step_m);
  EXPECT_EQ(one.report.textured.rms_m, three.report.textured.rms_m);
  EXPECT_EQ(one.report.plain.max_m, three.report.plain.max_m);
}

TEST(Baking, OfAMeshOntoItselfDisplacesNothing) {
  const TriangleMesh mesh = box({0.01, 0.02, 0.03});
  const BakedMesh result = bake_texture(mesh, mesh, kQuick, {});
  EXPECT_LT(result.report.textured.max_m, 1e-8);
  EXPECT_EQ(result.report.missed, 0U);
  for (const auto value : result.mesh.atlas.values) {
    EXPECT_LT(std::abs(value) * result.mesh.atlas.step_m, 2e-8);
  }
}

TEST(Baking, CountsRaysThatMeetNothingAndContinuesFromTheirNeighbours) {
  // The original lacks a cap that the simple mesh has: a ball and the same ball with a hole.
  const TriangleMesh whole = smooth_ball(5, 0.02);
  TriangleMesh open = whole;
  std::erase_if(open.triangles, [&](const auto& t) { return whole.vertices_m[t[0]].z > 0.0185; });
  const BakedMesh result = bake_texture(open, decimate_mesh(whole, 200, "thing").mesh, kQuick, {});
  EXPECT_GT(result.report.missed, 0U);
  EXPECT_LT(result.report.missed, result.report.samples / 4);
  for (std::size_t triangle = 0; triangle < result.mesh.triangles.size(); ++triangle) {
    const double radius_m =
        glm::length(textured_point_m(result.mesh, triangle, glm::dvec3{1.0 / 3.0}));
    EXPECT_NEAR(radius_m, 0.02, 0.001);
  }
}

TEST(Baking, PassesFailuresOfItsThreadsOn) {
  EXPECT_THROW(side_by_side(10000, {3, {}},
                            [](std::size_t begin, std::size_t) {
                              if (begin > 5000) throw std::runtime_error("no");
                            }),
               std::runtime_error);
}

TEST(Baking, DoesEveryPieceOfWorkOnce) {
  std::vector<std::atomic<int>> done(9999);
  side_by_side(done.size(), {3, {}}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++done[i];
  });
  for (const auto& times : done) EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace asperity::test
