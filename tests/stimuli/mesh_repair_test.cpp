// What is wrong with meshes, and what becomes of it.

#include "stimuli/meshes/mesh_repair.h"

#include <array>
#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "stimuli/meshes/mesh_decimation.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/support/refusal.h"

namespace asperity::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kBox_m3 = 8.0 * 0.01 * 0.02 * 0.03;
TriangleMesh small_box() { return box({0.01, 0.02, 0.03}); }

RepairedMesh repaired(const TriangleMesh& mesh, const MeshRepairLimits& limits = {}) {
  RepairedMesh result = repair_mesh(mesh, limits, "thing");
  EXPECT_TRUE(is_closed(result.mesh));
  return result;
}

std::string refused_repair(const TriangleMesh& mesh, const MeshRepairLimits& limits = {}) {
  return refusal_of<std::invalid_argument>([&] { repair_mesh(mesh, limits, "thing"); });
}

/// Every face with corners of its own, as STL has them.
TriangleMesh in_pieces(const TriangleMesh& mesh) {
  TriangleMesh pieces{};
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(pieces.vertices_m.size());
    for (const std::uint32_t corner : triangle) {
      pieces.vertices_m.push_back(mesh.vertices_m[corner]);
    }
    pieces.triangles.push_back({first, first + 1, first + 2});
  }
  return pieces;
}

TEST(MeshRepair, LeavesAGoodMeshAsItIs) {
  const TriangleMesh mesh = ring(24, 12, 0.0005);
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_DOUBLE_EQ(volume_m3(result.mesh), volume_m3(mesh));
  EXPECT_THAT(sentences_of(result.found), ElementsAre());
}

TEST(MeshRepair, JoinsTheCornersOfStl) {
  const RepairedMesh result = repaired(in_pieces(small_box()));
  EXPECT_EQ(result.mesh.vertices_m.size(), 8U);
  EXPECT_EQ(result.found.vertices_welded, 28U);
  EXPECT_THAT(sentences_of(result.found),
              ElementsAre("Vertices merged with another one at the same position: 28."));
}

TEST(MeshRepair, LeavesOutDegenerateAndDuplicateFacesAndLooseVertices) {
  TriangleMesh mesh = small_box();
  mesh.vertices_m.emplace_back(std::numeric_limits<double>::quiet_NaN());
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({2, 1, 0});
  mesh.triangles.push_back({0, 2, 1});
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.degenerate_faces, 1U);
  EXPECT_EQ(result.found.duplicate_faces, 2U);
  EXPECT_EQ(result.mesh.triangles.size(), 12U);
  EXPECT_EQ(result.mesh.vertices_m.size(), 8U);
}

// Two tetrahedra, above and below the triangle 0 1 2, which is a face of both.
TEST(MeshRepair, KeepsBothFacesInWhichTwoSolidsTouch) {
  const TriangleMesh mesh{
      {{0.01, 0, 0}, {-0.005, 0.00866, 0}, {-0.005, -0.00866, 0}, {0, 0, 0.01}, {0, 0, -0.01}},
      {{3, 0, 1}, {3, 1, 2}, {3, 2, 0}, {2, 1, 0}, {4, 1, 0}, {4, 2, 1}, {4, 0, 2}, {2, 0, 1}}};
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.duplicate_faces, 0U);
  EXPECT_EQ(result.mesh.triangles.size(), 8U);
  // The area of the triangle is 0.015 m · 0.00866 m, a third of the height 0.01 m, twice.
  EXPECT_NEAR(volume_m3(result.mesh), 2.0 * 0.015 * 0.00866 * 0.01 / 3.0, 1e-15);
}

// The triangle is divided into four, of which the middle one has no edge at the border of the wall.
TEST(MeshRepair, KeepsBothFacesWithinAWallOfTwoSolids) {
  TriangleMesh mesh{{{0.01, 0, 0},
                     {-0.005, 0.00866, 0},
                     {-0.005, -0.00866, 0},
                     {0.0025, 0.00433, 0},
                     {-0.005, 0, 0},
                     {0.0025, -0.00433, 0},
                     {0, 0, 0.01},
                     {0, 0, -0.01}},
                    {}};
  for (const auto& [a, b, c] : {std::array{0U, 3U, 5U}, {3U, 1U, 4U}, {5U, 4U, 2U}, {3U, 4U, 5U}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, b});
  }
  constexpr std::array kBorder{0U, 3U, 1U, 4U, 2U, 5U};
  for (std::size_t i = 0; i < kBorder.size(); ++i) {
    const std::uint32_t a = kBorder[i];
    const std::uint32_t b = kBorder[(i + 1) % kBorder.size()];
    mesh.triangles.push_back({6, a, b});
    mesh.triangles.push_back({7, b, a});
  }
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.duplicate_faces, 0U);
  EXPECT_EQ(result.found.holes_filled, 0U);
  EXPECT_EQ(result.found.parts, 2U);
  EXPECT_EQ(result.mesh.triangles.size(), 20U);
  EXPECT_NEAR(volume_m3(result.mesh), 2.0 * 0.015 * 0.00866 * 0.01 / 3.0, 1e-15);
}

TEST(MeshRepair, LeavesOutTheBacksOfASurfaceThatIsSeenFromBothSides) {
  TriangleMesh mesh = small_box();
  const std::size_t faces = mesh.triangles.size();
  for (std::size_t i = 0; i < faces; ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    mesh.triangles.push_back({a, c, b});
  }
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.duplicate_faces, faces);
  EXPECT_NEAR(volume_m3(result.mesh), kBox_m3, 1e-15);
}

TEST(MeshRepair, TurnsFacesThatRunAgainstTheirNeighbours) {
  TriangleMesh mesh = small_box();
  std::swap(mesh.triangles[4][1], mesh.triangles[4][2]);
  std::swap(mesh.triangles[9][0], mesh.triangles[9][1]);
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.faces_turned, 2U);
  EXPECT_EQ(result.found.inside_out_parts, 0U);
  EXPECT_NEAR(volume_m3(result.mesh), kBox_m3, 1e-15);
}

TEST(MeshRepair, TurnsWhatIsInsideOut) {
  TriangleMesh mesh = small_box();
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.inside_out_parts, 1U);
  EXPECT_EQ(result.found.faces_turned, 0U);
  EXPECT_NEAR(volume_m3(result.mesh), kBox_m3, 1e-15);
}

TEST(MeshRepair, KnowsACavityFromAPartThatIsInsideOut) {
  TriangleMesh hollow = box({0.005, 0.005, 0.005});
  for (auto& triangle : hollow.triangles) std::swap(triangle[0], triangle[1]);
  const RepairedMesh result = repaired(together(small_box(), hollow));
  EXPECT_EQ(result.found.cavities, 1U);
  EXPECT_EQ(result.found.inside_out_parts, 0U);
  EXPECT_NEAR(volume_m3(result.mesh), kBox_m3 - 1e-6, 1e-12);
  // The same cavity, the wrong way round.
  const RepairedMesh wrong = repaired(together(small_box(), box({0.005, 0.005, 0.005})));
  EXPECT_EQ(wrong.found.inside_out_parts, 1U);
  EXPECT_NEAR(volume_m3(wrong.mesh), kBox_m3 - 1e-6, 1e-12);
}

TEST(MeshRepair, TakesBodiesApartThatShareAnEdge) {
  const RepairedMesh result =
      repaired(together(box({0.01, 0.01, 0.01}), box({0.01, 0.01, 0.01}, {0.02, 0.02, 0.0})));
  EXPECT_EQ(result.found.non_manifold_edges, 1U);
  EXPECT_EQ(result.found.vertices_split, 2U);
  EXPECT_EQ(result.found.parts, 2U);
  EXPECT_EQ(result.mesh.vertices_m.size(), 16U);
  EXPECT_NEAR(volume_m3(result.mesh), 2.0 * 8e-6, 1e-12);
}

// Two cubes that touch along an edge, between two plates that hold both: around each end of that edge
// everything hangs together, so that no vertex can be split.
TEST(MeshRepair, DividesEdgesThatHaveTheSameEnds) {
  const RepairedMesh result = repaired(cubes({{0, 0, 0},
                                              {1, 0, 0},
                                              {0, 1, 0},
                                              {1, 1, 0},
                                              {0, 0, 1},
                                              {1, 1, 1},
                                              {0, 0, 2},
                                              {1, 0, 2},
                                              {0, 1, 2},
                                              {1, 1, 2}}));
  EXPECT_EQ(result.found.non_manifold_edges, 1U);
  EXPECT_EQ(result.found.vertices_split, 0U);
  EXPECT_EQ(result.found.edges_divided, 1U);
  EXPECT_EQ(result.found.parts, 1U);
  EXPECT_NEAR(volume_m3(result.mesh), 10e-6, 1e-15);
}

TEST(MeshRepair, TakesBodiesApartThatShareACorner) {
  const RepairedMesh result =
      repaired(together(box({0.01, 0.01, 0.01}), box({0.01, 0.01, 0.01}, {0.02, 0.02, 0.02})));
  EXPECT_EQ(result.found.non_manifold_edges, 0U);
  EXPECT_EQ(result.found.vertices_split, 1U);
  EXPECT_EQ(result.found.parts, 2U);
}

TEST(MeshRepair, ClosesSmallHolesAndSaysHowWideTheyWere) {
  TriangleMesh mesh = smooth_ball(4, 0.02);
  const double whole_m3 = volume_m3(mesh);
  // All faces around a vertex, and one face by itself.
  std::erase_if(mesh.triangles, [](const auto& t) { return t[0] == 4 || t[1] == 4 || t[2] == 4; });
  mesh.triangles.erase(mesh.triangles.begin() + 1000);
  const RepairedMesh result = repaired(mesh);
  EXPECT_EQ(result.found.holes_filled, 2U);
  EXPECT_NEAR(volume_m3(result.mesh), whole_m3, 1e-3 * whole_m3);
  EXPECT_GT(result.found.widest_hole_m, 0.002);
  EXPECT_LT(result.found.widest_hole_m, 0.006);
}

TEST(MeshRepair, RefusesAWideOpeningUnlessItIsAskedFor) {
  TriangleMesh mesh = small_box();
  mesh.triangles.resize(10);  // without the side at +x, 40 mm by 60 mm
  const std::string sentence = refused_repair(mesh);
  EXPECT_THAT(sentence, HasSubstr("thing is not closed: it has 1 hole, the widest 72.111 mm"));
  EXPECT_THAT(sentence, HasSubstr("7.483 mm"));  // a tenth of the diagonal, 74.83 mm
  EXPECT_THAT(refused_repair(mesh, {.widest_hole_m = std::numeric_limits<double>::quiet_NaN()}),
              HasSubstr("widest_hole_m"));
  const RepairedMesh result = repaired(mesh, {.widest_hole_m = 0.08});
  EXPECT_NEAR(volume_m3(result.mesh), kBox_m3, 1e-12);
}

TEST(MeshRepair, LeavesOutDebrisAndWhatEnclosesNothing) {
  TriangleMesh mesh = together(small_box(), box({1e-4, 1e-4, 1e-4}, {0.1, 0.0, 0.0}));
  TriangleMesh flake{{{0.05, 0, 0}, {0.06, 0, 0}, {0.05, 0.01, 0}}, {{0, 1, 2}}};
  mesh = together(mesh, flake);
  const RepairedMesh result = repaired(mesh, {.widest_hole_m = 0.02});
  EXPECT_EQ(result.found.debris_parts, 1U);
  EXPECT_EQ(result.found.flat_parts, 1U);
  EXPECT_EQ(result.found.dropped_faces, 14U);
  EXPECT_EQ(result.found.parts, 1U);
  EXPECT_EQ(result.mesh.triangles.size(), 12U);
}

// A sheet of 10 mm next to a body of which holes up to 7.5 mm are closed.
TEST(MeshRepair, TakesNoSheetForABodyWithAHole) {
  const TriangleMesh sheet{{{0.02, 0, 0}, {0.03, 0, 0}, {0.03, 0.01, 0}, {0.02, 0.01, 0}},
                           {{0, 1, 2}, {0, 2, 3}}};
  const RepairedMesh result = repaired(together(small_box(), sheet));
  EXPECT_EQ(result.found.flat_parts, 1U);
  EXPECT_EQ(result.found.holes_filled, 0U);
  EXPECT_EQ(result.found.widest_hole_m, 0.0);
  EXPECT_EQ(result.mesh.triangles.size(), 12U);
}

TEST(MeshRepair, LeavesASurfaceThatPassesThroughItselfAsItLies) {
  TriangleMesh mesh = box({0.01, 0.01, 0.01});
  const TriangleMesh other = box({0.01, 0.01, 0.01}, {0.005, 0.004, 0.003});
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 8, b + 8, c + 8});
  mesh.vertices_m.insert(mesh.vertices_m.end(), other.vertices_m.begin(), other.vertices_m.end());
  const RepairedMesh result = repair_mesh(mesh, {}, "thing");
  EXPECT_TRUE(is_closed(result.mesh));
  EXPECT_EQ(result.mesh.triangles.size(), 24U);
  EXPECT_EQ(result.found.parts, 2U);
}

TEST(MeshRepair, RefusesWhatHasNoInside) {
  EXPECT_THAT(refused_repair({{{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}}, {{0, 1, 2}}}),
              HasSubstr("flat"));
  EXPECT_THAT(refused_repair(box({0.01, 0.01, 0.0})), HasSubstr("flat"));
  EXPECT_THAT(refused_repair({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}}),
              HasSubstr("no face"));
  // A strip of six faces, closed with a twist.
  TriangleMesh strip{};
  for (int i = 0; i < 3; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / 3.0;
    const double twist_rad = angle_rad / 2.0;
    for (const double side : {-1.0, 1.0}) {
      const double from_axis_m = 0.03 + side * 0.01 * std::cos(twist_rad);
      strip.vertices_m.emplace_back(from_axis_m * std::cos(angle_rad),
                                    from_axis_m * std::sin(angle_rad),
                                    side * 0.01 * std::sin(twist_rad));
    }
  }
  strip.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}, {4, 1, 5}, {5, 1, 0}};
  EXPECT_THAT(refused_repair(strip), HasSubstr("one side only"));
}

// Triangles between random corners meet in every way there is. What comes out can be simplified.
TEST(MeshRepair, MakesOfAnyTrianglesAClosedMeshOrSaysWhyNot) {
  std::size_t mended = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    Random random(seed);
    TriangleMesh mesh = box({0.01, 0.02, 0.03});
    for (int i = 0; i < 6; ++i) {
      mesh.vertices_m.emplace_back(0.03 * random.uniform(), 0.03 * random.uniform(),
                                   0.03 * random.uniform());
    }
    const std::size_t more = 1 + seed % 24;
    for (std::size_t i = 0; i < more; ++i) {
      const auto corner = [&] { return static_cast<std::uint32_t>(14.0 * random.uniform()); };
      mesh.triangles.push_back({corner(), corner(), corner()});
    }
    if (seed % 3 == 0) mesh.triangles.erase(mesh.triangles.begin() + 5);
    try {
      const RepairedMesh result = repair_mesh(mesh, {.widest_hole_m = 1.0}, "thing");
      ASSERT_TRUE(is_closed(result.mesh)) << seed;
      ++mended;
      decimate_mesh(result.mesh, std::max<std::size_t>(4, result.mesh.triangles.size() * 3 / 4),
                    "thing");
    } catch (const std::invalid_argument& refused) {
      EXPECT_THAT(refused.what(), testing::AnyOf(HasSubstr("one side only"), HasSubstr("flat"),
                                                 HasSubstr("cannot be simplified")))
          << seed;
    }
  }
  EXPECT_GT(mended, 100U);
}

TEST(MeshRepair, RefusesCoordinatesThatAreNoNumbersAndSizesNobodyFeels) {
  TriangleMesh mesh = small_box();
  mesh.vertices_m[6].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refused_repair(mesh), HasSubstr("number 7"));
  mesh.vertices_m[6].y = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refused_repair(mesh), HasSubstr("number 7"));
  EXPECT_THAT(refused_repair(box({10.0, 20.0, 30.0})), HasSubstr("unit"));
  EXPECT_THAT(refused_repair(box({1e-6, 2e-6, 3e-6})), HasSubstr("unit"));
}

}  // namespace
}  // namespace asperity::test
