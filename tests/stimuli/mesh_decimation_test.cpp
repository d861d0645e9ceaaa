// Fewer triangles, and still the same thing.

#include "stimuli/meshes/mesh_decimation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/meshes/mesh_error.h"
#include "stimuli/meshes/mesh_handles.h"
#include "tests/stimuli/made_mesh.h"
#include "tests/support/refusal.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

double rms_error_m(const TriangleMesh& original, const TriangleMesh& simplified) {
  const SurfaceSearch search(simplified);
  return plain_error(surface_samples(original, 5000), search, {}).rms_m;
}

std::string refused_decimation(const TriangleMesh& mesh, std::size_t triangles) {
  return refusal_of<std::invalid_argument>([&] { decimate_mesh(mesh, triangles, "thing"); });
}

/// A tube of three sides between two faces, which it replaces.
void join(TriangleMesh& mesh, std::size_t one, std::size_t other) {
  const auto a = mesh.triangles[one];
  const std::array<std::uint32_t, 3> b{mesh.triangles[other][0], mesh.triangles[other][2],
                                       mesh.triangles[other][1]};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    mesh.triangles.push_back({a[i], a[next], b[next]});
    mesh.triangles.push_back({a[i], b[next], b[i]});
  }
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(std::max(one, other)));
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(std::min(one, other)));
}

/// Where a face looks straight along `direction`.
std::size_t face_towards(const TriangleMesh& mesh, const glm::dvec3& direction) {
  const auto reach = [&](const std::array<std::uint32_t, 3>& triangle) {
    glm::dvec3 sum_m{0.0};
    for (const std::uint32_t corner : triangle) sum_m += mesh.vertices_m[corner];
    return glm::dot(sum_m, direction);
  };
  const auto furthest = std::max_element(
      mesh.triangles.begin(), mesh.triangles.end(),
      [&](const auto& each, const auto& another) { return reach(each) < reach(another); });
  return static_cast<std::size_t>(furthest - mesh.triangles.begin());
}

/// A ball with a tunnel straight through it.
TriangleMesh pierced_ball(int levels = 4) {
  TriangleMesh mesh = smooth_ball(levels, 0.02);
  join(mesh, face_towards(mesh, {1, 2, 3}), face_towards(mesh, {-1, -2, -3}));
  return mesh;
}

TEST(Decimation, ReachesItsTargetAndStaysClosed) {
  const TriangleMesh mesh = ring(60, 24, 0.0003);  // 2880 triangles
  for (const std::size_t triangles : {2880U, 1000U, 301U, 64U}) {
    const TriangleMesh simplified = decimate_mesh(mesh, triangles, "thing").mesh;
    EXPECT_LE(simplified.triangles.size(), triangles);
    EXPECT_GE(simplified.triangles.size(), triangles - 1);
    EXPECT_TRUE(is_closed(simplified));
    // Inside the chords of 64 faces a ring has lost a third.
    EXPECT_NEAR(volume_m3(simplified), volume_m3(mesh), 0.35 * volume_m3(mesh));
  }
}

// A chord of a great circle that spans an angle α leaves R(1 − cos α/2) ≈ Rα²/8. N equal triangles on a ball have sides
// of about α = √(16π/(√3 N)) radians: with N = 512, 0.24, and 7·10⁻³ R at the middle of a side.
TEST(Decimation, OfABallLiesAsCloseAsItsTrianglesPermit) {
  constexpr double kRadius_m = 0.02;
  const TriangleMesh mesh = smooth_ball(5, kRadius_m);
  const double error_m = rms_error_m(mesh, decimate_mesh(mesh, 512, "thing").mesh);
  EXPECT_LT(error_m, 0.01 * kRadius_m);
  EXPECT_GT(error_m, 0.002 * kRadius_m);
}

TEST(Decimation, LeavesNothingOfAFinelyDividedBoxButItsCorners) {
  // Each face of the box in 2·8² triangles: all that lies flat goes, at no cost.
  TriangleMesh mesh{};
  const TriangleMesh plain = box({0.01, 0.02, 0.03});
  constexpr std::uint32_t kParts = 8;
  for (std::size_t face = 0; face < plain.triangles.size(); ++face) {
    const auto corner = [&](std::size_t i) { return plain.vertices_m[plain.triangles[face][i]]; };
    const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
    std::vector<std::vector<std::uint32_t>> rows{};
    std::uint32_t next = first;
    for (std::uint32_t j = 0; j <= kParts; ++j) {
      rows.emplace_back();
      for (std::uint32_t i = 0; i + j <= kParts; ++i) {
        // In a fixed order of the corners, so that both faces of an edge compute the same point.
        mesh.vertices_m.push_back(
            (corner(0) * double(kParts - i - j) + corner(1) * double(i) + corner(2) * double(j)) /
            double(kParts));
        rows.back().push_back(next++);
      }
    }
    for (std::uint32_t j = 0; j < kParts; ++j) {
      for (std::uint32_t i = 0; i + j < kParts; ++i) {
        mesh.triangles.push_back({rows[j][i], rows[j][i + 1], rows[j + 1][i]});
        if (i + j + 2 <= kParts) {
          mesh.triangles.push_back({rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]});
        }
      }
    }
  }
  std::map<std::array<std::int64_t, 3>, std::uint32_t> places{};
  TriangleMesh welded{};
  for (auto triangle : mesh.triangles) {
    for (std::uint32_t& vertex : triangle) {
      const glm::dvec3 point_m = mesh.vertices_m[vertex];
      const auto key = [](double length_m) { return std::llround(length_m * 1e9); };
      const auto [place, is_new] =
          places.try_emplace({key(point_m.x), key(point_m.y), key(point_m.z)},
                             static_cast<std::uint32_t>(welded.vertices_m.size()));
      if (is_new) welded.vertices_m.push_back(point_m);
      vertex = place->second;
    }
    welded.triangles.push_back(triangle);
  }
  ASSERT_EQ(welded.triangles.size(), 12U * 64U);
  const TriangleMesh simplified = decimate_mesh(welded, 12, "thing").mesh;
  EXPECT_EQ(simplified.triangles.size(), 12U);
  EXPECT_NEAR(volume_m3(simplified), 8.0 * 0.01 * 0.02 * 0.03, 1e-12);
}

// Seen from the middle of a ball with bumps, every face shows its back, however few are left.
TEST(Decimation, TurnsNoFaceOver) {
  const TriangleMesh mesh = bumpy_ball(5, 0.02, 0.0015, 14.0);
  for (const std::size_t triangles : {2000U, 500U, 100U}) {
    const TriangleMesh simplified = decimate_mesh(mesh, triangles, "thing").mesh;
    std::size_t turned = 0;
    for (const auto& [a, b, c] : simplified.triangles) {
      const glm::dvec3& corner_m = simplified.vertices_m[a];
      const glm::dvec3 front =
          glm::cross(simplified.vertices_m[b] - corner_m, simplified.vertices_m[c] - corner_m);
      if (glm::dot(front, corner_m) <= 0.0) ++turned;
    }
    EXPECT_EQ(turned, 0U) << "of " << triangles;
  }
}

// A fine relief must not be dearer than a corner: the planes of its slopes, extended, are soon further from the surface
// than a corner that is cut off.
TEST(Decimation, KeepsTheCornersOfARoughBlock) {
  constexpr std::uint32_t kCells = 80;
  constexpr double kSize_m = 0.03;
  const auto place_m = [](std::uint32_t i) { return kSize_m * (double{1} * i / kCells - 0.5); };
  TriangleMesh block{};
  const auto at = [](std::uint32_t row, std::uint32_t column) {
    return row * (kCells + 1) + column;
  };
  for (std::uint32_t row = 0; row <= kCells; ++row) {
    for (std::uint32_t column = 0; column <= kCells; ++column) {
      const double x_m = place_m(column);
      const double y_m = place_m(row);
      const double relief_m = 0.1e-3 * (std::sin(6.3e3 * x_m + 2e3 * y_m) + std::sin(5.1e3 * y_m));
      block.vertices_m.push_back({x_m, y_m, relief_m});
    }
  }
  std::vector<std::uint32_t> rim{};  // counter-clockwise from above
  for (std::uint32_t i = 0; i < kCells; ++i) rim.push_back(at(0, i));
  for (std::uint32_t i = 0; i < kCells; ++i) rim.push_back(at(i, kCells));
  for (std::uint32_t i = kCells; i > 0; --i) rim.push_back(at(kCells, i));
  for (std::uint32_t i = kCells; i > 0; --i) rim.push_back(at(i, 0));
  for (std::uint32_t row = 0; row < kCells; ++row) {
    for (std::uint32_t column = 0; column < kCells; ++column) {
      const std::uint32_t corner = at(row, column);
      const std::uint32_t opposite = at(row + 1, column + 1);
      block.triangles.push_back({corner, at(row, column + 1), opposite});
      block.triangles.push_back({corner, opposite, at(row + 1, column)});
    }
  }
  const auto below = static_cast<std::uint32_t>(block.vertices_m.size());
  for (const std::uint32_t vertex : rim) {
    block.vertices_m.push_back({block.vertices_m[vertex].x, block.vertices_m[vertex].y, -0.006});
  }
  block.vertices_m.push_back({0.0, 0.0, -0.006});
  const auto middle = static_cast<std::uint32_t>(block.vertices_m.size() - 1);
  for (std::uint32_t i = 0; i < rim.size(); ++i) {
    const auto next = static_cast<std::uint32_t>((i + 1) % rim.size());
    block.triangles.push_back({rim[i], below + i, below + next});
    block.triangles.push_back({rim[i], below + next, rim[next]});
    block.triangles.push_back({below + next, below + i, middle});
  }
  ASSERT_TRUE(is_closed(block));
  const TriangleMesh simplified = decimate_mesh(block, 100, "thing").mesh;
  const SurfaceSearch search(simplified);
  for (const std::uint32_t corner : {at(0, 0), at(0, kCells), at(kCells, 0), at(kCells, kCells)}) {
    EXPECT_LT(search.nearest(block.vertices_m[corner]).distance_m, 0.05e-3) << corner;
  }
}

TEST(Decimation, UsesVerticesOfTheOriginal) {
  const TriangleMesh mesh = bumpy_ball(3, 0.02, 0.001, 5.0);
  for (const glm::dvec3& vertex : decimate_mesh(mesh, 100, "thing").mesh.vertices_m) {
    EXPECT_THAT(mesh.vertices_m, testing::Contains(vertex));
  }
}

TEST(Decimation, GivesTheSameAgain) {
  const TriangleMesh mesh = ring(40, 20, 0.0003);
  const TriangleMesh one = decimate_mesh(mesh, 200, "thing").mesh;
  const TriangleMesh two = decimate_mesh(mesh, 200, "thing").mesh;
  EXPECT_EQ(one.triangles, two.triangles);
  EXPECT_TRUE(one.vertices_m == two.vertices_m);
}

// With handles to cut, and enough vertices that each batch of costs is divided among the threads.
TEST(Decimation, GivesTheSameWithAnyNumberOfThreads) {
  const TriangleMesh mesh = pierced_ball(5);
  const SimplifiedMesh one = decimate_mesh(mesh, 150, "thing", {.jobs = 1});
  ASSERT_EQ(one.handles_cut, 1U);
  for (const unsigned jobs : {2U, 7U}) {
    const SimplifiedMesh several = decimate_mesh(mesh, 150, "thing", {.jobs = jobs});
    EXPECT_EQ(one.mesh.triangles, several.mesh.triangles) << jobs;
    EXPECT_TRUE(one.mesh.vertices_m == several.mesh.vertices_m) << jobs;
  }
}

TEST(Decimation, RefusesAMeshThatIsNotClosed) {
  TriangleMesh mesh = smooth_ball(2, 0.02);
  mesh.triangles.pop_back();
  EXPECT_THAT(refused_decimation(mesh, 50),
              HasSubstr("thing has a non-manifold surface at vertex "));
}

TEST(Decimation, EndsWithTheExceptionOfItsProgress) {
  EXPECT_THROW(decimate_mesh(smooth_ball(5, 0.02), 500, "thing",
                             {.jobs = 2,
                              .progress =
                                  [](double fraction) {
                                    if (fraction > 0.3) throw std::runtime_error("stopped");
                                  }}),
               std::runtime_error);
}

TEST(Decimation, RefusesTargetsThatCannotBe) {
  const TriangleMesh mesh = box({0.01, 0.02, 0.03});
  EXPECT_THAT(refused_decimation(mesh, 13),
              HasSubstr("thing cannot be simplified to 13 triangles: it has only 12"));
  EXPECT_THAT(refused_decimation(mesh, 3), HasSubstr("at least 4"));
  const TriangleMesh several = together(mesh, box({0.01, 0.01, 0.01}, {0.1, 0.0, 0.0}));
  EXPECT_THAT(refused_decimation(several, 6),
              HasSubstr("thing cannot be simplified to 6 triangles: at "));
}

TEST(Decimation, TellsHowFarItIs) {
  double last = 0.0;
  decimate_mesh(smooth_ball(5, 0.02), 500, "thing", {.progress = [&last](double fraction) {
                  EXPECT_GE(fraction, last);
                  EXPECT_LE(fraction, 1.0);
                  last = fraction;
                }});
  EXPECT_GT(last, 0.7);
}

TEST(NarrowHandles, AreCountedAndCutWhereTheyAreNarrowerThanAsked) {
  TriangleMesh mesh = pierced_ball();
  ASSERT_TRUE(is_closed(mesh));
  EXPECT_EQ(handles_of(smooth_ball(2, 0.02)), 0U);
  EXPECT_EQ(handles_of(ring(20, 10, 0.0)), 1U);
  EXPECT_EQ(handles_of(mesh), 1U);
  // Sides of a ball's 2048 triangles: √(4·4πR²/(√3·2048)) = 2.4 mm, three of them 7 mm.
  EXPECT_EQ(cut_narrow_handles(mesh, 0.003).handles, 0U);
  const HandleCuts cuts = cut_narrow_handles(mesh, 0.01);
  EXPECT_EQ(cuts.handles, 1U);
  EXPECT_NEAR(cuts.widest_m, 0.007, 0.0015);
  EXPECT_EQ(cuts.copies.size(), 3U);
  EXPECT_EQ(handles_of(mesh), 0U);
  EXPECT_TRUE(is_closed(mesh));
}

// The neck is the narrowest way around of all, and nothing but the neck holds the two balls together.
TEST(NarrowHandles, AreNoNecks) {
  TriangleMesh mesh = pierced_ball();
  TriangleMesh small = smooth_ball(3, 0.005);
  const std::size_t neck = face_towards(small, {-1, 0.1, 0.2}) + mesh.triangles.size();
  const auto first = static_cast<std::uint32_t>(mesh.vertices_m.size());
  for (const glm::dvec3& vertex : small.vertices_m) {
    mesh.vertices_m.push_back(vertex + glm::dvec3{0.03, 0.0, 0.0});
  }
  for (const auto& [a, b, c] : small.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
  join(mesh, face_towards(pierced_ball(), {1, 0.1, -0.1}), neck);
  ASSERT_EQ(handles_of(mesh), 1U);
  const HandleCuts cuts = cut_narrow_handles(mesh, 0.01);
  EXPECT_EQ(cuts.handles, 1U);
  EXPECT_GT(cuts.widest_m, 0.005);  // around the neck it is less than 4 mm
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_EQ(handles_of(mesh), 0U);
}

TEST(Decimation, CutsWhatIsNarrowerThanAFaceAndKeepsARingARing) {
  const TriangleMesh mesh = pierced_ball();
  // Sides of 200 faces: 7.6 mm.
  const SimplifiedMesh simplified = decimate_mesh(mesh, 200, "thing");
  EXPECT_EQ(simplified.handles_cut, 1U);
  EXPECT_GT(simplified.widest_handle_m, 0.0);
  EXPECT_LT(simplified.widest_handle_m, 0.0076);
  EXPECT_EQ(handles_of(simplified.mesh), 0U);
  EXPECT_TRUE(is_closed(simplified.mesh));
  EXPECT_NEAR(volume_m3(simplified.mesh), volume_m3(smooth_ball(4, 0.02)), 3e-6);
  EXPECT_THAT(sentence_of(simplified).value(), HasSubstr("in circumference: 1."));
  const SimplifiedMesh whole = decimate_mesh(ring(60, 24, 0.0003), 300, "thing");
  EXPECT_EQ(whole.handles_cut, 0U);
  EXPECT_EQ(handles_of(whole.mesh), 1U);
  EXPECT_EQ(sentence_of(whole), std::nullopt);
}

}  // namespace
}  // namespace asperity::test
