// Every pair of intersecting triangles, and no other.

#include "renderers/pd_gradient/geometry/mesh_query.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fcl/fcl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "tests/renderers/meshes.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pose random_pose(Random& random, double reach_m) {
  const glm::dquat turn = glm::normalize(
      glm::dquat(random.normal(), random.normal(), random.normal(), random.normal()));
  const glm::dvec3 shift =
      reach_m * glm::dvec3(2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0,
                           2.0 * random.uniform() - 1.0);
  return {.rotation = glm::mat3_cast(turn), .position_m = shift};
}

Pairs sorted(std::span<const TrianglePair> found) {
  Pairs pairs{};
  for (const TrianglePair& pair : found) pairs.emplace_back(pair.a, pair.b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

using Oracle = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Oracle> oracle_of(const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> vertices{};
  for (const glm::dvec3& vertex : mesh.vertices_m) {
    vertices.emplace_back(vertex.x, vertex.y, vertex.z);
  }
  std::vector<fcl::Triangle> triangles{};
  for (const auto& corners : mesh.triangles) {
    triangles.emplace_back(corners[0], corners[1], corners[2]);
  }
  auto oracle = std::make_shared<Oracle>();
  oracle->beginModel();
  oracle->addSubModel(vertices, triangles);
  oracle->endModel();
  return oracle;
}

Pairs pairs_of_oracle(const Oracle& a, const Oracle& b, const Pose& pose) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      transform.linear()(row, column) = pose.rotation[column][row];
    }
    transform.translation()[row] = pose.position_m[row];
  }
  fcl::CollisionResultd result{};
  fcl::collide<double>(&a, transform, &b, fcl::Transform3d::Identity(),
                       fcl::CollisionRequestd(1000000, true), result);
  Pairs pairs{};
  for (std::size_t i = 0; i < result.numContacts(); ++i) {
    pairs.emplace_back(static_cast<std::uint32_t>(result.getContact(i).b1),
                       static_cast<std::uint32_t>(result.getContact(i).b2));
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(MeshQuery, FindsThePairsThatFclFinds) {
  const TriangleMesh tool = bumpy_torus(24, 15);
  const TriangleMesh surface = bumpy_torus(20, 18);
  const auto tool_oracle = oracle_of(tool);
  const auto surface_oracle = oracle_of(surface);
  MeshQuery query(std::make_shared<ClusteredMesh>(tool), std::make_shared<ClusteredMesh>(surface),
                  10000);
  Random random(11);
  std::size_t pairs = 0;
  for (int pose_number = 0; pose_number < 60; ++pose_number) {
    const Pose pose = random_pose(random, 0.05);
    const Pairs found = sorted(query.find(pose));
    ASSERT_EQ(found, pairs_of_oracle(*tool_oracle, *surface_oracle, pose)) << pose_number;
    pairs += found.size();
  }
  EXPECT_GT(pairs, 3000U);  // otherwise nothing was compared
}

TEST(MeshQuery, FindsTheSamePairsInTheSameOrderWithEveryInstructionSet) {
  const auto tool = std::make_shared<ClusteredMesh>(bumpy_torus(17, 13));
  const auto surface = std::make_shared<ClusteredMesh>(bumpy_torus(24, 15));
  MeshQuery narrow(tool, surface, 10000, InstructionSet::sse2);
  for (const InstructionSet set : instruction_sets_here()) {
    MeshQuery query(tool, surface, 10000, set);
    Random random(12);
    for (int pose_number = 0; pose_number < 100; ++pose_number) {
      const Pose pose = random_pose(random, 0.05);
      const auto expected = narrow.find(pose);
      ASSERT_THAT(query.find(pose), testing::ElementsAreArray(expected.begin(), expected.end()))
          << name_of(set) << ", pose " << pose_number;
    }
  }
}

// A walk with steps of random length, and some jumps. A new query has no list and searches all pairs.
TEST(MeshQuery, FindsTheSamePairsInTheSameOrderFromListsOfNearPairs) {
  const auto tool = std::make_shared<ClusteredMesh>(bumpy_torus(17, 13));
  const auto surface = std::make_shared<ClusteredMesh>(bumpy_torus(24, 15));
  Random random(15);
  MeshQuery query(tool, surface, 10000);
  Pose pose = random_pose(random, 0.03);
  std::size_t pairs = 0;
  constexpr int kSteps = 1500;
  for (int step = 0; step < kSteps; ++step) {
    if (step % 500 == 499) pose = random_pose(random, 0.03);
    const double step_m = step % 50 < 5 ? 1e-3 : 30e-6;
    const auto some = [&](double most) { return most * (2.0 * random.uniform() - 1.0); };
    const glm::dvec3 drift{std::sin(0.01 * step), std::cos(0.013 * step), std::sin(0.007 * step)};
    pose.position_m += 0.5 * step_m * drift + glm::dvec3{some(step_m), some(step_m), some(step_m)};
    const glm::dquat turn =
        glm::angleAxis(some(20.0 * step_m), glm::normalize(glm::dvec3{some(1), some(1), some(1)}));
    pose.rotation = glm::mat3_cast(turn) * pose.rotation;
    const auto found = query.find(pose);
    MeshQuery without_list(tool, surface, 10000);
    const auto expected = without_list.find(pose);
    ASSERT_THAT(found, testing::ElementsAreArray(expected.begin(), expected.end())) << step;
    pairs += found.size();
  }
  EXPECT_GT(pairs, 50'000U);
  EXPECT_GT(query.listed_calls(), 700U);
}

// Motions far below those for which parts of a list were tuned, and rests: lists are whole in time, so that only the first two calls
// search all pairs.
TEST(MeshQuery, UsesListsHoweverSlowTheMotion) {
  const auto mesh = std::make_shared<ClusteredMesh>(bumpy_torus(17, 13));
  MeshQuery query(mesh, mesh, 10000);
  Pose pose{.position_m = {0.005, 0.0, 0.004}};
  std::uint64_t calls = 0;
  const auto move = [&](double step_m, int steps) {
    for (int step = 0; step < steps; ++step, ++calls) {
      pose.position_m.x += step_m;
      query.find(pose);
    }
  };
  move(0.05e-6, 60'000);
  move(0.0, 20'000);
  move(-20e-6, 150);
  EXPECT_EQ(query.listed_calls(), calls - 2);
  MeshQuery without_list(mesh, mesh, 10000);
  const auto expected = without_list.find(pose);
  EXPECT_THAT(query.find(pose), testing::ElementsAreArray(expected.begin(), expected.end()));
}

// The near pairs have no room, the intersecting ones do.
TEST(MeshQuery, FindsThePairsWhereOnlyAListHasNoRoom) {
  const auto mesh = std::make_shared<ClusteredMesh>(bumpy_torus(17, 13));
  const Pose pose{.position_m = {0.005, 0.0, 0.004}};
  MeshQuery roomy(mesh, mesh, 10000);
  const auto all = roomy.find(pose);
  MeshQuery narrow(mesh, mesh, all.size() + 1);
  for (int step = 0; step < 5; ++step) {
    EXPECT_THAT(narrow.find(pose), testing::ElementsAreArray(all.begin(), all.end()));
  }
  EXPECT_EQ(narrow.listed_calls(), 0U);
}

TEST(MeshQuery, SearchesAllPairsWhereAListHasNoRoom) {
  const auto mesh = std::make_shared<ClusteredMesh>(bumpy_torus(17, 13));
  MeshQuery roomy(mesh, mesh, 10000);
  MeshQuery narrow(mesh, mesh, 20);
  for (int step = 0; step < 120; ++step) {
    const Pose pose{.position_m = {0.005 + 1e-6 * step, 0.0, 0.004}};
    roomy.find(pose);
    narrow.find(pose);
    ASSERT_EQ(narrow.count(), roomy.count());
  }
  EXPECT_GT(roomy.listed_calls(), 50U);
  EXPECT_EQ(narrow.listed_calls(), 0U);
}

TriangleMesh triangle(const glm::dvec3& first, const glm::dvec3& second, const glm::dvec3& third) {
  return {.vertices_m = {first, second, third}, .triangles = {{0, 1, 2}}};
}

bool meet(const TriangleMesh& a, const TriangleMesh& b) {
  MeshQuery query(std::make_shared<ClusteredMesh>(a), std::make_shared<ClusteredMesh>(b), 4);
  const bool forward = !query.find({}).empty();
  MeshQuery reverse(std::make_shared<ClusteredMesh>(b), std::make_shared<ClusteredMesh>(a), 4);
  EXPECT_EQ(!reverse.find({}).empty(), forward);
  return forward;
}

TEST(MeshQuery, CountsTrianglesThatTouchAndNotThoseAHairApart) {
  const TriangleMesh floor = triangle({0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0});
  const double hair_m = 1e-12;  // far below what single precision can tell apart
  EXPECT_TRUE(meet(floor, triangle({0.002, 0.002, 0.0}, {0.002, 0.002, 0.01}, {0.0, 0.0, 0.01})));
  EXPECT_FALSE(
      meet(floor, triangle({0.002, 0.002, hair_m}, {0.002, 0.002, 0.01}, {0.0, 0.0, 0.01})));
  EXPECT_TRUE(
      meet(floor, triangle({0.002, 0.002, -hair_m}, {0.002, 0.002, 0.01}, {0.0, 0.0, 0.01})));
}

TEST(MeshQuery, TellsTrianglesOfOnePlaneApart) {
  const TriangleMesh floor = triangle({0.0, 0.0, 0.0}, {0.01, 0.0, 0.0}, {0.0, 0.01, 0.0});
  EXPECT_TRUE(meet(floor, triangle({0.001, 0.001, 0.0}, {0.02, 0.02, 0.0}, {0.02, 0.0, 0.0})));
  EXPECT_TRUE(meet(floor, floor));
  // Their boxes overlap; the line x + y = 1 cm is between them.
  EXPECT_FALSE(
      meet(floor, triangle({0.006, 0.0045, 0.0}, {0.0045, 0.006, 0.0}, {0.01, 0.01, 0.0})));
}

TEST(MeshQuery, FarFromTheOriginSeesWhatItSeesAtTheOrigin) {
  TriangleMesh tool = bumpy_torus(12, 9);
  const auto surface = std::make_shared<ClusteredMesh>(bumpy_torus(14, 10));
  MeshQuery near(std::make_shared<ClusteredMesh>(tool), surface, 10000);
  const glm::dvec3 away_m(40.0, -30.0, 20.0);
  for (glm::dvec3& vertex : tool.vertices_m) vertex += away_m;
  MeshQuery far(std::make_shared<ClusteredMesh>(tool), surface, 10000);
  Random random(13);
  for (int pose_number = 0; pose_number < 20; ++pose_number) {
    const Pose pose = random_pose(random, 0.05);
    const Pose moved{.rotation = pose.rotation,
                     .position_m = pose.position_m - pose.rotation * away_m};
    EXPECT_EQ(sorted(near.find(pose)), sorted(far.find(moved)));
  }
}

// Of what is too large for single precision nothing is known, and every triangle may be met. 17 clusters of
// triangles, and then 15 places for clusters that there are not.
TEST(MeshQuery, FindsOnlyTrianglesThatThereAreAndEachPairOnce) {
  const TriangleMesh good = bumpy_torus(15, 9);
  ASSERT_EQ(good.triangles.size(), 270U);
  TriangleMesh wild = good;
  wild.vertices_m[5] = {1e300, -1e300, 2.0};
  const auto a = std::make_shared<ClusteredMesh>(wild);
  const auto b = std::make_shared<ClusteredMesh>(good);
  const Pose huge{.rotation = glm::dmat3(1e200)};
  for (const InstructionSet set : instruction_sets_here()) {
    for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a), std::pair(a, a)}) {
      MeshQuery query(first, second, 270U * 270U + 1U, set);
      for (const Pose& pose : {Pose{}, huge, Pose{.position_m = {1e300, 0.0, 0.0}}}) {
        const Pairs found = sorted(query.find(pose));
        for (const auto& [of_first, of_second] : found) {
          ASSERT_LT(of_first, 270U) << name_of(set);
          ASSERT_LT(of_second, 270U) << name_of(set);
        }
        EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << name_of(set);
        EXPECT_EQ(query.count(), found.size());
      }
    }
  }
}

TEST(MeshQuery, CountsThePairsThatItHasNoRoomToList) {
  const auto mesh = std::make_shared<ClusteredMesh>(bumpy_torus(12, 9));
  MeshQuery roomy(mesh, mesh, 100000);
  MeshQuery narrow(mesh, mesh, 10);
  const Pose pose{.position_m = {0.001, 0.002, 0.003}};
  EXPECT_GT(roomy.find(pose).size(), 10U);
  EXPECT_EQ(narrow.find(pose).size(), 10U);
  EXPECT_EQ(narrow.count(), roomy.count());
}

TEST(MeshQuery, LeavesTheHeapAlone) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  const auto mesh = std::make_shared<ClusteredMesh>(bumpy_torus(24, 15));
  MeshQuery query(mesh, mesh, 1000);
  const AllocationGuard guard;
  query.find({.position_m = {0.001, 0.0, 0.02}});
  EXPECT_EQ(guard.count(), 0);
}

TEST(MeshQuery, RefusesAMeshThatIsNone) {
  EXPECT_THROW(ClusteredMesh({}), std::invalid_argument);
  EXPECT_THROW(ClusteredMesh({.vertices_m = {{0.0, 0.0, 0.0}}, .triangles = {{0, 1, 2}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
