// How long the verdict of a pair of triangles holds, against gaps and depths in double precision.

#include "renderers/pd_gradient/geometry/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "renderers/pd_gradient/loops/instruction_set.h"
#include "tests/renderers/meshes.h"

namespace asperity {
namespace {

using Corners = std::array<glm::dvec3, 3>;

constexpr double kTriangle_m = 1e-3;
constexpr float kTolerance_m = 1e-7F;
constexpr int kSlivers = 10;

glm::dvec3 some(Random& random, double most) {
  const auto one = [&] { return most * (2.0 * random.uniform() - 1.0); };
  return {one(), one(), one()};
}

// As single precision stores it.
glm::dvec3 stored(const glm::dvec3& place_m) { return glm::dvec3(glm::vec3(place_m)); }

std::pair<double, double> ends_along(const glm::dvec3& axis, const Corners& corners) {
  return std::minmax(
      {glm::dot(axis, corners[0]), glm::dot(axis, corners[1]), glm::dot(axis, corners[2])});
}

// By how much a is too far along the axis, or b in the opposite direction, to be separate along it.
double overlap_m(const glm::dvec3& axis, const Corners& a, const Corners& b) {
  const auto [a_low, a_high] = ends_along(axis, a);
  const auto [b_low, b_high] = ends_along(axis, b);
  return std::min(a_high - b_low, b_high - a_low);
}

// A second triangle: any; a sliver; or with an edge that is nearly parallel to one of the first, anywhere or so that the two edges nearly meet
// and the triangles overlap a little along their product.
Corners partner(Random& random, const Corners& first, int kind) {
  Corners second{};
  const glm::dvec3 shift_m = some(random, kTriangle_m);
  for (glm::dvec3& corner : second) corner = shift_m + some(random, kTriangle_m);
  if (kind == kSlivers) {
    const glm::dvec3 along = some(random, kTriangle_m);
    for (glm::dvec3& corner : second)
      corner = along * random.uniform() + some(random, 0.05 * kTriangle_m);
  } else if (kind > 0) {
    const glm::dvec3 edge = first[1] - first[0];
    const double off = kTriangle_m * std::pow(10.0, -0.5 * kind);
    const bool meet = kind % 2 == 1;
    const glm::dvec3 along = edge * (0.5 + random.uniform()) + some(random, off);
    const glm::dvec3 middle = 0.5 * (first[0] + first[1]) + some(random, meet ? 0.0 : kTriangle_m);
    second[0] = middle - 0.5 * along;
    second[1] = middle + 0.5 * along;
    if (meet) {
      glm::dvec3 axis = glm::normalize(glm::cross(edge, along));
      if (glm::dot(axis, first[2] - middle) > 0.0) axis = -axis;
      if (glm::dot(axis, second[2] - middle) < 0.0) second[2] = 2.0 * middle - second[2];
      for (glm::dvec3& corner : second) corner -= 1e-6 * (1.0 + 9.0 * random.uniform()) * axis;
    }
  }
  for (glm::dvec3& corner : second) corner = stored(corner);
  return second;
}

// The smallest overlap along the normals of the facets of a − b: by how much a has to move to be free of b. If it is negative, they
// are at least so far apart.
double least_overlap_m(const Corners& a, const Corners& b) {
  double least_m = std::numeric_limits<double>::infinity();
  const auto look = [&](const glm::dvec3& one, const glm::dvec3& other) {
    const glm::dvec3 product = glm::cross(one, other);
    if (glm::length(product) < 1e-12 * glm::length(one) * glm::length(other)) return;
    least_m = std::min(least_m, overlap_m(glm::normalize(product), a, b));
  };
  look(a[1] - a[0], a[2] - a[0]);
  look(b[1] - b[0], b[2] - b[0]);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) look(a[(i + 1) % 3] - a[i], b[(j + 1) % 3] - b[j]);
  }
  return least_m;
}

TEST(PairSlack, IsAtMostTheDistanceToTheOppositeVerdict) {
  for (const InstructionSet set : instruction_sets_here()) {
    Random random(21);
    std::vector<double> parts_together;
    std::vector<double> parts_apart;
    for (int round = 0; round < 4000; ++round) {
      PairBatch batch{};
      std::array<Corners, kClusterSize> first{};
      std::array<Corners, kClusterSize> second{};
      for (std::size_t lane = 0; lane < kClusterSize; ++lane) {
        for (glm::dvec3& corner : first[lane]) corner = stored(some(random, kTriangle_m));
        second[lane] = partner(random, first[lane], round % (kSlivers + 1));
        for (std::size_t corner = 0; corner < 3; ++corner) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<int>(axis);
            batch.a[corner][axis][lane] = static_cast<float>(first[lane][corner][at]);
            batch.b[corner][axis][lane] = static_cast<float>(second[lane][corner][at]);
          }
        }
      }
      PairVerdicts verdicts;
      const ClusterPose pose{.turn = {1, 0, 0, 0, 1, 0, 0, 0, 1}, .tolerance_m = kTolerance_m};
      triangle_loops_of(set).judge_pairs(batch, pose, verdicts);
      for (std::size_t lane = 0; lane < kClusterSize; ++lane) {
        if ((verdicts.together & verdicts.unsure & 1U << lane) != 0) {
          EXPECT_LT(verdicts.slack_m[lane], 0.0F);
          continue;
        }
        const bool are_together = (verdicts.together & 1U << lane) != 0;
        ASSERT_EQ(are_together, triangles_intersect(first[lane], second[lane]));
        const double most_m = std::abs(least_overlap_m(first[lane], second[lane]));
        ASSERT_LE(verdicts.slack_m[lane], most_m) << name_of(set) << ", round " << round;
        if (round % (kSlivers + 1) != 0) continue;
        (are_together ? parts_together : parts_apart).push_back(verdicts.slack_m[lane] / most_m);
      }
    }
    // Of any triangles: a slack that is often much smaller saves little.
    const auto median = [](std::vector<double>& of) {
      std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2),
                       of.end());
      return of[of.size() / 2];
    };
    EXPECT_GT(parts_together.size(), 300U);
    EXPECT_GT(median(parts_together), 0.9) << name_of(set);
    EXPECT_GT(median(parts_apart), 0.9) << name_of(set);
  }
}

using ListedPairs = std::vector<TrianglePair>;

// Lists are compared with lists that are made at each pose.
TEST(NearPairs, HaveTheVerdictsOfANewListAlsoIfPairsAreAddedAfterAMotion) {
  const ClusteredMesh tool(bumpy_torus(9, 7));
  const ClusteredMesh surface(bumpy_torus(10, 6));
  const MeshPair meshes{
      .a = tool, .b = surface, .loops = triangle_loops_of(instruction_sets_here().back())};
  constexpr double kMargin_m = 2e-3;
  constexpr double kStep_m = 20e-6;
  const auto add_all = [&](NearPairs& pairs, std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t a = first; a < end; ++a) {
      for (std::uint32_t b = 0; b < 120; ++b) pairs.add(meshes, {.a = a, .b = b});
    }
    pairs.add_last(meshes);
  };
  const auto intersecting = [](const NearPairs& pairs) {
    ListedPairs found(120 * 126);
    found.resize(pairs.intersecting(found));
    return found;
  };
  const auto pose_at = [](int step) {
    return Pose{.position_m = {0.004 + kStep_m * step, 0.002, 0.005}};
  };
  NearPairs pairs(120 * 126);
  pairs.begin(pose_at(0), kMargin_m);
  add_all(pairs, 0, 60);
  std::size_t changes = 0;
  ListedPairs before;
  for (int step = 0; step < 90; ++step) {
    if (step > 0) pairs.move(kStep_m);
    if (step == 30) add_all(pairs, 60, 126);
    pairs.renew(meshes, pose_at(step));
    if (step < 30) continue;
    NearPairs fresh(120 * 126);
    fresh.begin(pose_at(step), 0.0);
    add_all(fresh, 0, 126);
    const ListedPairs found = intersecting(pairs);
    ASSERT_EQ(found, intersecting(fresh)) << step;
    changes += found != before ? 1 : 0;
    before = found;
  }
  EXPECT_GT(before.size(), 50U);
  EXPECT_GT(changes, 20U);
}

}  // namespace
}  // namespace asperity
