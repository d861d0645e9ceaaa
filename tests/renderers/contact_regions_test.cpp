// Pairs of triangles become contacts, and their directions are steady.

#include "renderers/pd_gradient/geometry/contact_regions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "tests/renderers/meshes.h"
#include "tests/renderers/pd_gradient_surfaces.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

Pose turned_to(double angle_rad, const glm::dvec3& axis, const glm::dvec3& place_m) {
  return {.rotation = glm::mat3_cast(glm::angleAxis(angle_rad, glm::normalize(axis))),
          .position_m = place_m};
}

/// The two steps of a tick that end in contacts.
struct Meeting {
  Meeting(const TriangleMesh& a, const TriangleMesh& b)
      : query(std::make_shared<ClusteredMesh>(a), std::make_shared<ClusteredMesh>(b), 4000),
        regions(a, b, 4000, 16) {}

  std::span<const ContactRegion> update(const Pose& a, const Pose& b) {
    const glm::dmat3 back = glm::transpose(b.rotation);
    const auto pairs = query.find(
        {.rotation = back * a.rotation, .position_m = back * (a.position_m - b.position_m)});
    return regions.update(pairs, a, b);
  }

  MeshQuery query;
  ContactRegions regions;
};

constexpr double kBallRadius_m = 0.01;
constexpr double kBallDepth_m = 0.001;

TriangleMesh plate() { return box({0.1, 0.1, 0.01}); }
/// Under whose upper face z = 0 lies.
Pose plate_pose() { return pose_at({0.0, 0.0, -0.005}); }

TEST(ContactRegions, ABallOnAPlateIsOneContactAlongThePlatesNormal) {
  Meeting meeting(ball(kBallRadius_m, 24, 36), plate());
  const auto regions =
      meeting.update(pose_at({0.013, -0.007, kBallRadius_m - kBallDepth_m}), plate_pose());
  ASSERT_EQ(regions.size(), 1U);
  const ContactRegion& region = regions[0];
  EXPECT_GT(region.frame.n.z, 0.999);
  EXPECT_NEAR(region.frame.origin_m.x, 0.013, 2e-4);
  EXPECT_NEAR(region.frame.origin_m.y, -0.007, 2e-4);
  EXPECT_NEAR(region.frame.origin_m.z, 0.0, 1e-9);  // on the plane in which both are cut
  // The circle in which the ball is cut, and not much more.
  const double circle_m =
      2.0 * std::sqrt(2.0 * kBallRadius_m * kBallDepth_m - kBallDepth_m * kBallDepth_m);
  EXPECT_GT(region.width_m, 0.97 * circle_m);
  EXPECT_LT(region.width_m, 1.3 * circle_m);
  EXPECT_EQ(meeting.regions.regions_left_out(), 0U);
}

TEST(ContactRegions, AFacePressedIntoAFaceIsOneContactAlongTheirNormal) {
  // No triangle of the two faces cuts the other's plane: the curve is that of the box's walls.
  Meeting meeting(box({0.02, 0.03, 0.02}), plate());
  const auto regions =
      meeting.update(turned_to(0.3, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.01 - 1e-4}), plate_pose());
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_GT(regions[0].frame.n.z, 1.0 - 1e-9);
  EXPECT_GT(regions[0].width_m, 0.03);
}

TEST(ContactRegions, WhatDoesNotHangTogetherIsSeveralContacts) {
  // A ring that stands on edge, half of it in a block, cuts the block's face in two places.
  Meeting meeting(bumpy_torus(40, 20), box({0.1, 0.1, 0.1}));
  const Pose ring = turned_to(1.5, {1.0, 0.1, 0.2}, {0.0, 0.0, 0.005});
  const auto regions = meeting.update(ring, pose_at({0.0, 0.0, -0.05}));
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_GT(glm::distance(regions[0].frame.origin_m, regions[1].frame.origin_m), 0.03);
}

/// How many pairs each of the parts has that hang together, each pair held against each other one.
std::vector<std::size_t> parts_by_every_two(std::span<const TrianglePair> pairs,
                                            const TriangleMesh& a, const TriangleMesh& b) {
  const auto have_a_corner_in_common = [](const auto& one, const auto& other) {
    return std::any_of(one.begin(), one.end(), [&](std::uint32_t corner) {
      return std::find(other.begin(), other.end(), corner) != other.end();
    });
  };
  std::vector<std::size_t> part(pairs.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool along_b =
          pairs[i].a == pairs[j].a &&
          have_a_corner_in_common(b.triangles[pairs[i].b], b.triangles[pairs[j].b]);
      const bool along_a =
          pairs[i].b == pairs[j].b &&
          have_a_corner_in_common(a.triangles[pairs[i].a], a.triangles[pairs[j].a]);
      if (along_a || along_b) std::replace(part.begin(), part.end(), part[i], std::size_t{part[j]});
    }
  }
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto size = static_cast<std::size_t>(std::count(part.begin(), part.end(), i));
    if (size > 0) sizes.push_back(size);
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

// Rings through each other and through a block, whose faces are cut many times, in pose after pose: what
// was joined before is forgotten.
TEST(ContactRegions, AreWhatHangsTogetherWhateverTheirPairsShare) {
  const TriangleMesh ring = bumpy_torus(40, 20);
  std::size_t most_parts = 0;
  for (const TriangleMesh& other : {box({0.1, 0.1, 0.1}), bumpy_torus(24, 15)}) {
    Meeting meeting(ring, other);
    for (int step = 0; step < 12; ++step) {
      const Pose pose = turned_to(0.3 + 0.25 * step, {1.0, 0.3 * step, 0.2}, {0.0, 0.003, 0.05});
      const auto pairs = meeting.query.find(pose);
      const std::vector<std::size_t> expected = parts_by_every_two(pairs, ring, other);
      std::vector<std::size_t> found;
      for (const ContactRegion& region : meeting.regions.update(pairs, pose, {})) {
        found.push_back(region.pairs);
      }
      std::sort(found.begin(), found.end());
      // What has no direction is counted, not listed.
      EXPECT_EQ(found.size() + meeting.regions.regions_left_out(), expected.size()) << step;
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), found.begin(), found.end()))
          << step;
      most_parts = std::max(most_parts, found.size());
    }
  }
  EXPECT_GE(most_parts, 2U);
}

// Segments of pairs that were there in the previous update, and places in the list that others have taken since.
TEST(ContactRegions, AreThoseOfThePresentPairsWithEveryInstructionSet) {
  const TriangleMesh ring = bumpy_torus(40, 20);
  const TriangleMesh other = box({0.1, 0.1, 0.1});
  Meeting meeting(ring, other);
  std::vector<ContactRegions> all;
  for (const InstructionSet set : instruction_sets_here()) {
    all.emplace_back(ring, other, 4000, 16, set);
  }
  std::size_t regions = 0;
  for (int step = 0; step < 60; ++step) {
    const Pose pose = turned_to(0.3 + 0.01 * step, {1.0, 0.3, 0.2}, {0.0, 0.003, 0.05});
    const Pose surface = pose_at({0.0, 1e-5 * step, 0.0});
    const auto pairs = meeting.query.find(
        {.rotation = pose.rotation, .position_m = pose.position_m - surface.position_m});
    const auto expected = all.front().update(pairs, pose, surface);
    regions += expected.size();
    for (ContactRegions& each : all) {
      if (&each == &all.front()) continue;
      const auto found = each.update(pairs, pose, surface);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].frame.origin_m, expected[i].frame.origin_m);
        EXPECT_EQ(found[i].frame.n, expected[i].frame.n);
        EXPECT_EQ(found[i].half_extent_m, expected[i].half_extent_m);
        EXPECT_EQ(found[i].upright_a, expected[i].upright_a);
        EXPECT_EQ(found[i].upright_b, expected[i].upright_b);
      }
    }
    ContactRegions fresh(ring, other, 4000, 16);
    const auto first = fresh.update(pairs, pose, surface);
    ASSERT_EQ(first.size(), expected.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i].pairs, expected[i].pairs);
      EXPECT_EQ(first[i].frame.origin_m, expected[i].frame.origin_m);
    }
  }
  EXPECT_GE(regions, 60U);
}

TEST(ContactRegions, ExchangingTheBodiesReversesTheDirection) {
  const TriangleMesh one = ball(kBallRadius_m, 12, 20);
  const TriangleMesh other = bumpy_torus(24, 15);
  const Pose one_pose = turned_to(0.4, {1.0, 2.0, 3.0}, {0.03, 0.004, 0.0205});
  Meeting forward(one, other);
  Meeting backward(other, one);
  const auto first = forward.update(one_pose, {});
  const auto second = backward.update({}, one_pose);
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_LT(glm::length(first[0].frame.n + second[0].frame.n), 1e-9);
  EXPECT_LT(glm::distance(first[0].frame.origin_m, second[0].frame.origin_m), 1e-12);
}

TEST(ContactRegions, MovingBothBodiesMovesTheContactWithThem) {
  const TriangleMesh one = ball(kBallRadius_m, 12, 20);
  const TriangleMesh other = bumpy_torus(24, 15);
  const Pose pose = pose_at({0.03, 0.004, 0.0205});
  const Pose motion = turned_to(1.1, {2.0, -1.0, 0.5}, {0.2, -0.1, 0.3});
  const Pose moved{.rotation = motion.rotation * pose.rotation,
                   .position_m = motion.rotation * pose.position_m + motion.position_m};
  Meeting still(one, other);
  Meeting moving(one, other);
  const ContactRegion before = still.update(pose, {})[0];
  const ContactRegion after = moving.update(moved, motion)[0];
  EXPECT_LT(glm::distance(after.frame.n, motion.rotation * before.frame.n), 1e-9);
  EXPECT_LT(glm::distance(after.frame.u, motion.rotation * before.frame.u), 1e-9);
  EXPECT_LT(glm::distance(after.frame.origin_m,
                          motion.rotation * before.frame.origin_m + motion.position_m),
            1e-9);
}

TEST(ContactRegions, ADirectionMovesContinuouslyWhileABodySlides) {
  Meeting meeting(ball(kBallRadius_m, 16, 24), bumpy_torus(30, 20));
  constexpr double kStep_m = 1e-5;
  double largest_rad = 0.0;
  ContactFrame before{};
  for (int step = 0; step < 1500; ++step) {
    const auto regions = meeting.update(pose_at({0.03, -0.0075 + kStep_m * step, 0.0205}), {});
    ASSERT_EQ(regions.size(), 1U) << step;
    const ContactFrame& frame = regions[0].frame;
    if (step > 0) largest_rad = std::max(largest_rad, glm::length(frame.n - before.n));
    EXPECT_NEAR(glm::dot(frame.u, frame.n), 0.0, 1e-12);
    EXPECT_NEAR(glm::dot(glm::cross(frame.u, frame.v), frame.n), 1.0, 1e-12);
    before = frame;
  }
  // 10 µm on faces of some 5 mm that meet at some 0.3 rad.
  EXPECT_LT(largest_rad, 0.005);
}

TEST(ContactRegions, AContactKeepsItsNameWhileABodySlidesAndANewOneGetsAnother) {
  Meeting meeting(ball(kBallRadius_m, 16, 24), plate());
  const auto id_at = [&](double x_m) {
    return meeting.update(pose_at({x_m, 0.0, kBallRadius_m - kBallDepth_m}), plate_pose())[0].id;
  };
  const std::uint64_t first = id_at(0.0);
  for (int step = 1; step < 50; ++step) EXPECT_EQ(id_at(1e-4 * step), first) << step;
  EXPECT_NE(id_at(-0.02), first);  // further than half a window in one tick
  meeting.regions.reset();
  EXPECT_EQ(id_at(0.0), first);  // and the past is forgotten
}

TEST(ContactRegions, ADirectionStaysWhileTheBodiesRockWithinItsPlay) {
  Meeting meeting(box({0.02, 0.02, 0.02}), plate());
  const auto rocked = [&](double angle_rad) {
    // The plate rocks, and the box with it.
    const Pose motion = turned_to(angle_rad, {0.0, 1.0, 0.0}, {0.0, 0.0, 0.0});
    const Pose block{.rotation = motion.rotation,
                     .position_m = motion.rotation * glm::dvec3(0.0, 0.0, 0.0099)};
    const Pose ground{.rotation = motion.rotation,
                      .position_m = motion.rotation * glm::dvec3(0.0, 0.0, -0.005)};
    return meeting.update(block, ground)[0].frame.n;
  };
  const glm::dvec3 first = rocked(0.0);
  EXPECT_EQ(rocked(0.9 * ContactRegions::kPlay_rad), first);
  EXPECT_EQ(rocked(-0.9 * ContactRegions::kPlay_rad), first);
  const glm::dvec3 followed = rocked(3.0 * ContactRegions::kPlay_rad);
  EXPECT_NEAR(std::acos(glm::dot(followed, first)), 2.0 * ContactRegions::kPlay_rad, 1e-6);
  meeting.regions.reset();
  EXPECT_NEAR(std::acos(glm::dot(rocked(0.3), first)), 0.3, 1e-6);  // nothing to stay behind
}

TEST(ContactRegions, AreThoseWithTheLongestCurvesWhereThereIsNoRoomForMore) {
  const TriangleMesh ring = bumpy_torus(40, 20);
  const TriangleMesh block = box({0.1, 0.1, 0.1});
  Meeting meeting(ring, block);
  ContactRegions narrow(ring, block, 4000, 1);
  const Pose pose = turned_to(1.5, {1.0, 0.1, 0.2}, {0.0, 0.0, 0.005});
  const Pose below = pose_at({0.0, 0.0, -0.05});
  const ContactRegion longest = meeting.update(pose, below)[0];
  const auto pairs = meeting.query.find(
      {.rotation = pose.rotation, .position_m = pose.position_m - below.position_m});
  const auto regions = narrow.update(pairs, pose, below);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].frame.origin_m, longest.frame.origin_m);
  EXPECT_EQ(narrow.regions_left_out(), 1U);
}

TEST(ContactRegions, BodiesApartMakeNoContact) {
  Meeting meeting(ball(kBallRadius_m, 12, 20), plate());
  EXPECT_TRUE(meeting.update(pose_at({0.0, 0.0, 0.02}), plate_pose()).empty());
}

TEST(ContactRegions, LeaveTheHeapAlone) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  Meeting meeting(bumpy_torus(30, 20), bumpy_torus(24, 15));
  const AllocationGuard guard;
  for (int step = 0; step < 50; ++step) {
    meeting.update(turned_to(0.02 * step, {1.0, 2.0, 0.5}, {0.001 * step, 0.002, 0.01}), {});
  }
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
