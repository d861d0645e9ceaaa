// All contacts of two bodies: which there are, that they are continuous, and what they count and refuse.

#include "renderers/pd_gradient/contact/textured_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/renderers/contact_scenes.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

TEST(TexturedContacts, AreContinuousAlongASlowPath) {
  const TexturedMesh tool = shifted(bare(ball(1.5e-3, 30, 40)), {0.0, 0.0, 1.5e-3});
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3});
  TexturedContacts contacts = between(tool, plate, hard(0.1e-3));
  constexpr double kStep_m = 10e-6;
  constexpr int kTicks = 400;
  glm::dvec3 before_N{0.0};
  double largest_N = 0.0;
  double squares_N2 = 0.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const glm::dvec3 place_m{-2e-3 + kStep_m * tick, 0.3e-3 * std::sin(0.01 * tick), -0.15e-3};
    const glm::dvec3 force_N =
        wrench_about(place_m, contacts.find(pose_at(place_m), {}, kTick_s)).force_N;
    if (tick > 0) largest_N = std::max(largest_N, std::abs(force_N.x - before_N.x));
    squares_N2 += force_N.x * force_N.x;
    before_N = force_N;
  }
  // 10 µm are 5 % of a period's phase, 0.07 of the RMS of a sine; at the crests it goes faster.
  EXPECT_LT(largest_N, 0.35 * std::sqrt(squares_N2 / kTicks));
}

// Where bodies meet, and as the contact and with it the window get wider.
TEST(TexturedContacts, BeginWithoutAStepWithTheSmoothMaximumToo) {
  const TexturedMesh block = bare(box({0.02, 0.02, 0.01}));
  const WindowSampling smooth{.law = SmoothMaximum{.tau_m = 20e-6}, .cell_m = 0.1e-3};
  for (const TexturedMesh& tool : {shifted(bare(box({0.008, 0.008, 0.004})), {0.0, 0.0, 0.002}),
                                   shifted(bare(ball(2e-3, 48, 48)), {0.0, 0.0, 2e-3})}) {
    TexturedContacts contacts = between(tool, block, smooth);
    constexpr double kDown_m = 2e-6;
    double before_N = 0.0;
    double widest_m = 0.0;
    for (double depth_m = -kDown_m; depth_m < 0.9e-3; depth_m += kDown_m) {
      const auto found = contacts.find(pose_at({0.0, 0.0, 0.005 - depth_m}), {}, kTick_s);
      const double force_N = wrench_about({}, found).force_N.z;
      EXPECT_NEAR(force_N, before_N, 3.0 * kStiffness_N_per_m * kDown_m) << depth_m;
      before_N = force_N;
      for (const TexturedContact& one : found) widest_m = std::max(widest_m, one.grid.width_m);
    }
    EXPECT_NEAR(before_N, 0.89, 0.03);
    EXPECT_GT(widest_m, 3.3e-3);  // the narrowest is 3.2 mm
  }
}

TEST(TexturedContacts, OfABoxThatLiesOnAPlateAreOne) {
  const TexturedMesh box = with_grating(BoxShape{{0.008, 0.008, 0.008}},
                                        {.amplitude_m = 0.02e-3, .wavelength_m = 1e-3}, 0.001);
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3});
  TexturedContacts contacts = between(box, plate, hard(0.1e-3));
  for (int tick = 0; tick < 100; ++tick) {
    const auto found = contacts.find(pose_at({0.3e-3, 0.2e-3, 0.0042 - 5e-6 * tick}), {}, kTick_s);
    ASSERT_LE(found.size(), 1U) << tick;
    if (found.empty() || found[0].penetration.depth_m <= 0.0) continue;
    EXPECT_GT(found[0].frame.n.z, 1.0 - 1e-6) << tick;
    EXPECT_FALSE(found[0].penetration.at_window) << tick;
  }
}

// An outer and an inner curve around the same wall of a cup: one contact, not two.
TEST(TexturedContacts, OfARimAreOne) {
  TriangleMesh cup;
  constexpr std::uint32_t kAround = 24;
  constexpr std::array<glm::dvec2, 4> kProfile{
      {{2e-3, 0.0}, {3e-3, 0.0}, {3e-3, 5e-3}, {2e-3, 5e-3}}};  // of the wall: radius, height
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / kAround;
    for (const glm::dvec2& corner : kProfile) {
      cup.vertices_m.push_back(
          {corner.x * std::cos(angle_rad), corner.x * std::sin(angle_rad), corner.y});
    }
    for (std::uint32_t j = 0; j < 4; ++j) {
      const std::uint32_t next = (i + 1) % kAround;
      const std::uint32_t a = 4 * i + j;
      const std::uint32_t b = 4 * i + (j + 1) % 4;
      const std::uint32_t c = 4 * next + (j + 1) % 4;
      const std::uint32_t d = 4 * next + j;
      cup.triangles.push_back({a, c, b});
      cup.triangles.push_back({a, d, c});
    }
  }
  TexturedContacts contacts = between(bare(cup), bare(box({0.02, 0.02, 0.01})), hard(0.1e-3));
  const auto found = contacts.find(pose_at({0.0, 0.0, 0.005 - 0.2e-3}), {}, kTick_s);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].penetration.depth_m, 0.2e-3, 1e-6);
  EXPECT_GT(found[0].frame.n.z, 0.999);
}

// The far side of a ring looks down too, and another shelf up.
TEST(TexturedContacts, LeaveOutSheetsThatAreFarFromTheContact) {
  TriangleMesh shelves = box({0.03, 0.03, 0.002});
  for (const glm::dvec3& vertex_m : box({0.03, 0.03, 0.002}).vertices_m) {
    shelves.vertices_m.push_back(vertex_m + glm::dvec3{0.0, 0.0, 0.02});
  }
  for (const auto& [a, b, c] : box({0.03, 0.03, 0.002}).triangles) {
    shelves.triangles.push_back({a + 8, b + 8, c + 8});
  }
  TexturedContacts contacts = between(bare(ball(2e-3, 16, 20)), bare(shelves), hard(0.1e-3));
  const auto found = contacts.find(pose_at({0.0, 0.0, 0.003 - 0.2e-3}), {}, kTick_s);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].penetration.depth_m, 0.2e-3, 0.02e-3);
  EXPECT_EQ(found[0].penetration.folded, 0);
}

// Each of two contacts 1 mm wide has a window of 3.2 mm, and sees the other's place too.
TEST(TexturedContacts, FeelOfTwoSpikesThatAreCloseTheDeeperOneOnce) {
  const TexturedMesh spikes = balls_at({{-0.65e-3, 0.0, 0.3e-3}, {0.65e-3, 0.0, 0.5e-3}}, 0.3e-3);
  TexturedContacts contacts = between(spikes, bare(box({0.02, 0.02, 0.01})), hard(0.1e-3));
  double before_N = 0.0;
  for (int tick = 0; tick <= 300; ++tick) {
    const double sunk_m = 1e-6 * tick;
    const auto found = contacts.find(pose_at({0.0, 0.0, 0.005 - sunk_m}), {}, kTick_s);
    const double force_N = wrench_about({}, found).force_N.z;
    EXPECT_LE(force_N, kStiffness_N_per_m * sunk_m + 1e-6) << tick;
    EXPECT_NEAR(force_N, before_N, 0.02) << tick;
    before_N = force_N;
  }
  EXPECT_NEAR(before_N, 0.3, 0.02);
  const auto place_m = [](const TexturedContact& contact) {
    return contact.frame.origin_m + contact.frame.to_world(contact.penetration.deepest_m);
  };
  // Over to the other one.
  for (int tick = 0; tick <= 300; ++tick) {
    const Pose pose{.rotation = turn_about({0, 1, 0}, 1e-3 * tick),
                    .position_m = {0.0, 0.0, 0.005 - 0.3e-3}};
    const auto found = contacts.find(pose, {}, kTick_s);
    const double force_N = glm::length(wrench_about({}, found).force_N);
    EXPECT_NEAR(force_N, before_N, 0.02) << tick;
    before_N = force_N;
    for (const TexturedContact& one : found) {
      double share = 0.0;
      for (const TexturedContact& other : found) {
        if (is_felt(one) && is_felt(other) &&
            glm::distance(place_m(one), place_m(other)) < 0.1e-3) {
          share += other.share;
        }
      }
      EXPECT_LE(share, 1.0 + 1e-9) << tick;
    }
    if (tick < 100 || tick > 200) {
      EXPECT_EQ(found.size(), 1U) << tick;
    }
  }
}

// Four times as many ticks at 4 kHz.
TEST(TexturedContacts, BlendAndBelieveWithinTheSameTimeAtEveryRate) {
  const TexturedMesh balls = balls_at({{-4e-3, 0.0, 1e-3}, {4e-3, 0.0, 2e-3}}, 1e-3);
  const TexturedMesh block = bare(box({0.03, 0.03, 0.01}));
  for (const double tick_s : {1e-3, 0.25e-3}) {
    TexturedContacts sinking = between(balls, block, hard(0.1e-3));
    double faded_s = 0.0;
    for (double time_s = 0.0; time_s < 0.280; time_s += tick_s) {
      for (const TexturedContact& contact :
           sinking.find(pose_at({0.0, 0.0, 0.005 - 0.01 * time_s}), {}, tick_s)) {
        faded_s += contact.is_fading ? tick_s : 0.0;
      }
    }
    EXPECT_NEAR(faded_s, 0.025, 1.5e-3) << tick_s;
    TexturedContacts sudden = between(bare(needle()), block, hard(0.1e-3));
    double doubted_s = 0.0;
    while (doubted_s < 0.1 &&
           !is_first_felt(sudden.find(pose_at({0.0, 0.0, 0.00525 - 3e-3}), {}, tick_s))) {
      doubted_s += tick_s;
    }
    EXPECT_NEAR(doubted_s, 0.025, 0.002) << tick_s;
  }
}

// The spike's window shows a strip of the flat that ends beside it, which is as deep everywhere: its first
// sample there is another one than that of the flat's own window.
TEST(TexturedContacts, FeelABroadFlatTopOnceBesideASmallerContact) {
  TriangleMesh tool = box({6e-3, 9e-3, 4e-3});
  for (glm::dvec3& vertex_m : tool.vertices_m) vertex_m += glm::dvec3{-3e-3, 0.0, 2e-3};
  const auto first = static_cast<std::uint32_t>(tool.vertices_m.size());
  const TriangleMesh spike = ball(0.3e-3, 12, 16);
  for (const glm::dvec3& vertex_m : spike.vertices_m) {
    tool.vertices_m.push_back(vertex_m + glm::dvec3{1.4e-3, 0.0, 0.45e-3});
  }
  for (const auto& [p, q, r] : spike.triangles) {
    tool.triangles.push_back({p + first, q + first, r + first});
  }
  TexturedContacts contacts = between(bare(tool), bare(box({0.03, 0.03, 0.01})), hard(0.1e-3));
  double before_N = 0.0;
  for (int tick = 0; tick <= 300; ++tick) {
    const double sunk_m = 1e-6 * tick;
    const double force_N =
        wrench_about({}, contacts.find(pose_at({0.0, 0.0, 0.005 - sunk_m}), {}, kTick_s)).force_N.z;
    EXPECT_NEAR(force_N, kStiffness_N_per_m * sunk_m, 1e-5) << tick;
    before_N = force_N;
  }
  EXPECT_NEAR(before_N, 0.3, 1e-5);
}

// A pen that leans: its deepest place is further aside than its curve reaches, at the window's border. The
// windows of kept heights are not quite where those that are sampled anew are.
TEST(TexturedContacts, SayFromKeptHeightsTooThatTheWindowEndsBeforeTheBodies) {
  TriangleMesh pen = ball(0.6e-3, 12, 16);
  for (glm::dvec3& vertex_m : pen.vertices_m) {
    if (vertex_m.z > 0.0) vertex_m.z += 12e-3;
  }
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.02e-3, .wavelength_m = 1.2e-3});
  const auto ticks_at_window = [&](Heights heights) {
    WindowSampling sampling = hard(0.1e-3);
    sampling.heights = heights;
    TexturedContacts contacts = between(bare(pen), plate, sampling);
    int ticks = 0;
    for (int tick = 0; tick < 400; ++tick) {
      const Pose pose{
          .rotation = turn_about({0, 1, 0}, 1.1),
          .position_m = {1e-5 * tick, 0.0, 0.2e-3 - 2.5e-3 * std::min(1.0, tick / 200.0)}};
      const auto found = contacts.find(pose, {}, kTick_s);
      ticks += std::any_of(found.begin(), found.end(), [](const TexturedContact& contact) {
        return is_felt(contact) && contact.penetration.at_window;
      });
    }
    return ticks;
  };
  const int anew = ticks_at_window(Heights::sampled);
  const int kept = ticks_at_window(Heights::kept);
  RecordProperty("ticks", std::to_string(kept) + " of " + std::to_string(anew));
  EXPECT_GT(anew, 50);
  EXPECT_NEAR(kept, anew, 0.1 * anew);
}

TEST(TexturedContacts, CountWhatThereIsNoRoomFor) {
  // Spikes in a row: more contacts than are kept.
  TriangleMesh comb;
  for (std::uint32_t i = 0; i < kMostContacts + 4; ++i) {
    const auto first = static_cast<std::uint32_t>(comb.vertices_m.size());
    for (const glm::dvec3& vertex_m : ball(0.5e-3, 6, 8).vertices_m) {
      comb.vertices_m.push_back(vertex_m + glm::dvec3{5e-3 * i, 0.0, 0.0});
    }
    for (const auto& [a, b, c] : ball(0.5e-3, 6, 8).triangles) {
      comb.triangles.push_back({a + first, b + first, c + first});
    }
  }
  TexturedContacts contacts = between(bare(comb), bare(box({0.3, 0.3, 0.01})), hard(0.1e-3));
  EXPECT_EQ(contacts.find(pose_at({0.0, 0.0, 0.0053}), {}, kTick_s).size(), kMostContacts);
  EXPECT_GE(contacts.left_out().regions, 4U);
}

TEST(TexturedContacts, FindNothingWhereAPoseIsNotFinite) {
  TexturedContacts contacts =
      between(bare(ball(1e-3, 8, 10)), bare(box({0.01, 0.01, 0.01})), hard(0.1e-3));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contacts.find(pose_at({nan, 0.0, 0.005}), {}, kTick_s).empty());
  Pose pose = pose_at({0.0, 0.0, 0.005});
  pose.rotation[1].y = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(contacts.find(pose, {}, kTick_s).empty());
  EXPECT_FALSE(contacts.touch(pose, {}));
  EXPECT_FALSE(contacts.find(pose_at({0.0, 0.0, 0.0055}), {}, kTick_s).empty());
}

TEST(TexturedContacts, AreTheSameBitsWithEveryInstructionSet) {
  const TexturedMesh tool = with_grating(BoxShape{{0.006, 0.006, 0.006}},
                                         {.amplitude_m = 0.02e-3, .wavelength_m = 1e-3}, 0.001);
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3});
  std::vector<std::vector<double>> answers;
  for (const InstructionSet set : instruction_sets_here()) {
    TexturedContacts contacts({tool, 1.0}, {plate, 1.0}, hard(0.1e-3), set);
    std::vector<double>& answer = answers.emplace_back();
    for (int tick = 0; tick < 40; ++tick) {
      const Pose pose{.rotation = turn_about({1.0, 0.4, 0.2}, 0.005 * tick),
                      .position_m = {1e-5 * tick, 0.0, 0.003}};
      for (const TexturedContact& contact : contacts.find(pose, {}, kTick_s)) {
        const Penetration& p = contact.penetration;
        answer.insert(answer.end(), {p.depth_m, p.slope.x, p.slope.y, p.lever_m.x, p.lever_m.y,
                                     p.lever_m.z, contact.frame.origin_m.x});
      }
    }
  }
  ASSERT_GT(answers.front().size(), 100U);
  for (const auto& answer : answers) EXPECT_EQ(answer, answers.front());
}

TEST(TexturedContacts, LeaveTheHeapAlone) {
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "the sanitizer owns the heap";
  TexturedContacts contacts =
      between(bare(bumpy_torus(30, 20)), bare(box({0.1, 0.1, 0.1})), hard(0.1e-3));
  const AllocationGuard guard;
  std::size_t found = 0;
  for (int tick = 0; tick < 60; ++tick) {
    const Pose pose{.rotation = turn_about({1.0, 0.1, 0.2}, 1.5 + 0.01 * tick),
                    .position_m = {0.0, 0.0, 0.11 - 0.002 * tick}};
    contacts.touch(pose, {});
    found += contacts.find(pose, {}, kTick_s).size();
  }
  contacts.reset();
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(found, 20U);
}

// A block through both: its curves are as long as each other, each in the other one's window.
TEST(TexturedContacts, StayTheOnesTheyWereWhereCurvesAreAsLong) {
  TexturedContacts contacts = between(bare(box({3.135e-3, 2.461e-3, 2.25e-3})),
                                      bare(two_sheets(0.755e-3, 1.567e-3)), hard(0.1e-3));
  std::vector<std::uint64_t> before;
  int changes = 0;
  std::size_t most = 0;
  for (int tick = 0; tick < 300; ++tick) {
    const double angle_rad = 1.3e-3 + 3e-4 * std::sin(0.01 * (tick + 400));
    const Pose pose{
        .rotation = turn_about({0.226, 0.617, 0.265}, angle_rad),
        .position_m = {1e-3 * std::sin(0.006 * (tick + 400)), 0.3e-3, -0.805e-3 - 6.5e-6 * tick}};
    std::vector<std::uint64_t> now;
    for (const TexturedContact& contact : contacts.find(pose, {}, kTick_s)) {
      if (is_felt(contact) && !contact.is_fading) now.push_back(contact.id);
    }
    std::sort(now.begin(), now.end());
    changes += tick > 0 && now != before ? 1 : 0;
    most = std::max(most, now.size());
    before = now;
  }
  RecordProperty("changes", changes);
  EXPECT_GE(most, 2U);
  EXPECT_LE(changes, 8);
}

// The lower sheet comes into the box in which triangles are looked for while the heights of the upper one are
// kept.
TEST(TexturedContacts, FeelTheSameFromKeptHeightsThroughTwoThinSheets) {
  const TexturedMesh tool = bare(ball(2e-3, 24, 32));
  const TexturedMesh surface = bare(two_sheets(0.5e-3, 1.5e-3));
  WindowSampling sampling = hard(0.1e-3);
  TexturedContacts kept = between(tool, surface, sampling);
  sampling.heights = Heights::sampled;
  TexturedContacts anew = between(tool, surface, sampling);
  const auto felt_N = [](std::span<const TexturedContact> found) {
    glm::dvec3 sum_N{0.0};
    for (const TexturedContact& contact : found) {
      if (!is_felt(contact)) continue;
      sum_N +=
          contact_wrench(contact.penetration, contact.frame, contact.share * kStiffness_N_per_m)
              .force_N;
    }
    return sum_N;
  };
  double furthest_N = 0.0;
  double largest_N = 0.0;
  for (int tick = 0; tick < 450; ++tick) {
    const Pose pose = pose_at({1e-3 * std::sin(0.006 * tick), 0.3e-3, 2.3e-3 - 1e-5 * tick});
    const glm::dvec3 expected_N = felt_N(anew.find(pose, {}, kTick_s));
    largest_N = std::max(largest_N, glm::length(expected_N));
    furthest_N =
        std::max(furthest_N, glm::distance(felt_N(kept.find(pose, {}, kTick_s)), expected_N));
  }
  RecordProperty("furthest_N", std::to_string(furthest_N) + " of " + std::to_string(largest_N));
  EXPECT_GT(largest_N, 0.4);
  EXPECT_LT(furthest_N, 1e-4);
}

// Heights are kept over many ticks of a slide that also rocks and turns, and sampled anew on the way.
TEST(TexturedContacts, FeelTheSameFromKeptHeightsAsFromNewOnes) {
  const TexturedMesh tool = bare(ball(4e-3, 20, 30));
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3});
  WindowSampling sampling = hard(0.1e-3);
  TexturedContacts kept = between(tool, plate, sampling);
  sampling.heights = Heights::sampled;
  TexturedContacts anew = between(tool, plate, sampling);
  double squares_N2 = 0.0;
  double furthest_N = 0.0;
  constexpr int kTicks = 300;
  for (int tick = 0; tick < kTicks; ++tick) {
    const double phase = 0.02 * tick;
    const Pose pose{.rotation = turn_about({1, 0, 0}, 0.05 * std::sin(0.7 * phase)) *
                                turn_about({0, 0, 1}, 0.1 * phase),
                    .position_m = {3e-3 * std::sin(phase), 0.5e-3, 3.8e-3}};
    const Wrench found = wrench_about({}, kept.find(pose, {}, kTick_s));
    const Wrench expected = wrench_about({}, anew.find(pose, {}, kTick_s));
    ASSERT_GT(expected.force_N.z, 0.05);
    squares_N2 += glm::dot(expected.force_N, expected.force_N);
    furthest_N = std::max(furthest_N, glm::distance(found.force_N, expected.force_N));
  }
  EXPECT_GT(furthest_N, 0.0);  // they are not the same thing
  EXPECT_LT(furthest_N, 0.1 * std::sqrt(squares_N2 / kTicks));
}

// A device may report anything, and a file that is read may hold what nobody would model. AddressSanitizer and
// UndefinedBehaviorSanitizer see what the plain build does not.
TEST(TexturedContacts, SurvivesEveryPlaceTurnAndVertexThatIsANumber) {
  std::vector<Pose> poses{{.position_m = {0.0, 0.0, -0.5e-3}}};
  for (const double far_m : {1.0, 9e3, 2e4, 1e20, 1e300}) {
    for (const glm::dvec3 way : {glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(1.0, -1.0, 1.0)}) {
      poses.push_back({.position_m = far_m * way});
    }
    poses.push_back({.rotation = glm::dmat3(far_m), .position_m = {0.0, 0.0, -0.5e-3}});
    poses.push_back({.rotation = glm::dmat3(1.0 / far_m), .position_m = {0.0, 0.0, -0.5e-3}});
  }
  const TexturedMesh tool = shifted(bare(ball(1e-3, 14, 20)), {0.0, 0.0, 1e-3});
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.05e-3, .wavelength_m = 1.2e-3});
  for (const double far_m : {20.0, -20.0}) {
    for (const bool of_tool : {true, false}) {
      TexturedMesh a = tool;
      TexturedMesh b = plate;
      (of_tool ? a : b).vertices_m[3].y = far_m;
      TexturedContacts contacts = between(a, b, hard(50e-6));
      for (const Pose& pose : poses) {
        for (int tick = 0; tick < 3; ++tick) contacts.find(pose, {}, kTick_s);
        contacts.touch(pose, {});
        contacts.find(poses.front(), {}, kTick_s);
        contacts.reset();
      }
    }
  }
}

}  // namespace
}  // namespace asperity
