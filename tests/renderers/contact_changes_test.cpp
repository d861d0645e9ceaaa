// How much the force changes where contacts begin, merge, divide and end.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "stimuli/meshes/detailed_bodies.h"
#include "tests/renderers/contact_scenes.h"

namespace asperity {
namespace {

/// The change of the force in a tick that the motion does not explain: all of it except the changes of the contacts that
/// continue, as far as surfaces of at most 60° permit them.
class UnexplainedChange {
 public:
  /// Relative to the larger force of both ticks, or to 0.12 N.
  double of(std::span<const TexturedContact> found, const Pose& a) {
    constexpr double kLeast_N = 0.12;
    glm::dvec3 force_N{0.0};
    glm::dvec3 change_N{0.0};
    std::map<Key, TexturedContact> now;
    for (const TexturedContact& contact : found) {
      if (!is_felt(contact)) continue;
      force_N += contact.share * kStiffness_N_per_m * force_m(contact);
      now.emplace(Key{contact.id, contact.is_fading}, contact);
    }
    for (const auto& [key, contact] : now) {
      const auto plain = before_.find({key.first, false});
      const auto last = key.second && before_.contains(key) ? before_.find(key) : plain;
      if (last == before_.end()) continue;
      if (key.second && last != plain && plain != before_.end()) {
        const auto still = now.find({key.first, false});
        const bool has_joined =
            still == now.end() || still->second.share < plain->second.share - 1e-9;
        if (has_joined) continue;
      }
      change_N +=
          std::min(contact.share, last->second.share) * explained_N(last->second, contact, a);
    }
    change_N = force_N - force_before_N_ - change_N;
    const double current_N =
        std::max({glm::length(force_N), glm::length(force_before_N_), kLeast_N});
    const double part = is_first_ ? 0.0 : glm::length(change_N) / current_N;
    is_first_ = false;
    before_ = std::move(now);
    force_before_N_ = force_N;
    a_before_ = a;
    return part;
  }

 private:
  using Key = std::pair<std::uint64_t, bool>;  // with whether it fades

  glm::dvec3 explained_N(const TexturedContact& last, const TexturedContact& now,
                         const Pose& a) const {
    const double half_m = 0.5 * now.grid.width_m;
    double way_m = 0.0;
    for (const glm::dvec3& place_m :
         {deepest_m(now), now.frame.origin_m + half_m * now.frame.u,
          now.frame.origin_m - half_m * now.frame.u, now.frame.origin_m + half_m * now.frame.v,
          now.frame.origin_m - half_m * now.frame.v}) {
      const glm::dvec3 then_m = a_before_.rotation * in_body(a, place_m) + a_before_.position_m;
      way_m = std::max(way_m, glm::distance(place_m, then_m));
    }
    const double slope = glm::length(glm::dvec3(now.penetration.slope, 1.0));
    const double most_N = kStiffness_N_per_m * std::numbers::sqrt3 * way_m *
                          (slope + now.penetration.depth_m / now.filter_m);
    const glm::dvec3 change_N = kStiffness_N_per_m * (force_m(now) - force_m(last));
    return std::min(1.0, most_N / std::max(1e-12, glm::length(change_N))) * change_N;
  }

  std::map<Key, TexturedContact> before_{};
  glm::dvec3 force_before_N_{0.0};
  Pose a_before_{};
  bool is_first_ = true;
};

struct Change {
  double largest = 0.0;    // unexplained, of the current force
  double largest_N = 0.0;  // of the force
};

Change changes_of(const TexturedMesh& tool, const TexturedMesh& surface,
                  const std::function<Pose(int)>& pose, int ticks, double step_m = 0.1e-3) {
  TexturedContacts contacts = between(tool, surface, hard(step_m));
  for (int tick = 0; tick < 30; ++tick) contacts.find(pose(0), {}, kTick_s);
  UnexplainedChange unexplained;
  Change change;
  for (int tick = 0; tick < ticks; ++tick) {
    const auto found = contacts.find(pose(tick), {}, kTick_s);
    change.largest = std::max(change.largest, unexplained.of(found, pose(tick)));
    glm::dvec3 force_N{0.0};
    for (const TexturedContact& contact : found) {
      if (is_felt(contact)) force_N += contact.share * kStiffness_N_per_m * force_m(contact);
    }
    change.largest_N = std::max(change.largest_N, glm::length(force_N));
  }
  return change;
}

TEST(ContactChanges, AreLessThanATwentiethOfTheForceWhereOneOfTwoBallsGoesIn) {
  const TexturedMesh block = bare(box({0.03, 0.03, 0.01}));
  const Change in = changes_of(
      balls_at({{-4e-3, 0.0, 1e-3}, {4e-3, 0.0, 2e-3}}, 1e-3), block,
      [](int tick) {
        return pose_at({0.0, 0.0, 0.005 - 1e-5 * tick});
      },
      281);
  EXPECT_GT(in.largest, 0.01);
  EXPECT_LT(in.largest, 0.05);
  EXPECT_GT(in.largest_N, 2.0);
  const auto in_and_out = [](int tick) {
    return pose_at({0.0, 0.0, 0.005 - 5e-6 * std::min(tick, std::max(240 - tick, 0))});
  };
  const TexturedMesh small = balls_at({{-4e-3, 0.0, 0.2e-3}, {4e-3, 0.0, 0.5e-3}}, 0.2e-3);
  EXPECT_LT(changes_of(small, block, in_and_out, 271).largest, 0.05);
}

// A box that is pressed on a floor and slides against a step. It was as deep as in the upper floor, and pushed to the side
// with the steepest slope, from one tick to the next: up to 2.7 N.
TEST(ContactChanges, AreSmallAtALowStep) {
  for (const double high_m : {0.2e-3, 0.5e-3, 1e-3}) {
    for (const double angle_rad : {0.25 * std::numbers::pi, 0.5 * std::numbers::pi}) {
      for (const double in_m : {0.3e-3, 0.8e-3}) {
        const auto slide = [in_m](int tick) {
          return pose_at({-4e-3 + 5e-6 * (tick + 300), 0.1e-3, 2e-3 - in_m});
        };
        const Change change = changes_of(bare(box({4e-3, 4e-3, 4e-3})),
                                         bare(floor_and_wall(angle_rad, high_m)), slide, 300);
        EXPECT_LT(change.largest, 0.08) << high_m << ' ' << angle_rad << ' ' << in_m;
        EXPECT_GT(change.largest_N, 1.1 * kStiffness_N_per_m * in_m);
      }
    }
  }
}

TEST(ContactChanges, AreSmallWhereADoubtfulDepthIsBelieved) {
  TriangleMesh needle = ball(0.25e-3, 8, 12);
  for (glm::dvec3& vertex_m : needle.vertices_m) {
    if (vertex_m.z > 0.0) vertex_m.z += 8e-3;
  }
  const Change change = changes_of(
      bare(needle), bare(box({0.02, 0.02, 0.01})),
      [](int) {
        return pose_at({0.0, 0.0, 0.00525 - 3e-3});
      },
      150);
  EXPECT_LT(change.largest, 0.05);
  EXPECT_NEAR(change.largest_N, 3.0, 0.1);
}

// A bumpy ring that lies on a block and rocks, pressed and lifted: bumps become one contact and part.
class RingOnABlock : public testing::Test {
 protected:
  static glm::dmat3 rocked(double phase) {
    return turn_about({1, 0.1, 0.2}, 0.02 + 0.05 * std::sin(phase)) *
           turn_about({0, 1, 0}, 0.04 * std::sin(1.7 * phase)) * turn_about({0, 0, 1}, 0.1 * phase);
  }
  // That much deeper than where it touches first.
  Pose pressed(double phase, double depth_m) const {
    const glm::dmat3 turn = rocked(phase);
    double lowest_m = 1.0;
    for (const glm::dvec3& vertex_m : ring_.vertices_m) {
      lowest_m = std::min(lowest_m, (turn * vertex_m).z);
    }
    return {.rotation = turn, .position_m = {0.3e-3 * phase, 0.0, 0.05 - lowest_m - depth_m}};
  }
  const TexturedMesh ring_ = bare(bumpy_torus(30, 20));
  const TexturedMesh block_ = bare(box({0.1, 0.1, 0.1}));
  WindowSampling sampling_{.law = HardMaximum{.step_m = 0.2e-3}, .cell_m = 0.2e-3};
};

TEST_F(RingOnABlock, JumpsLittleWhereContactsPartAndJoin) {
  TexturedContacts contacts = between(ring_, block_, sampling_);
  constexpr int kTicks = 1000;
  const auto pose = [&](int tick) {
    const double phase = 2.0 * std::numbers::pi * (0.45 + 0.5 * tick / kTicks);
    return pressed(phase, 1e-3 + 0.8e-3 * std::sin(7.0 * phase));
  };
  for (int tick = 0; tick < 30; ++tick)
    contacts.find(pose(0), {}, kTick_s);  // what is new rises once
  struct Jumps {
    glm::dvec3 before_N{0.0};
    double largest_N = 0.0;
    double squares_N2 = 0.0;
    void add(const glm::dvec3& force_N, bool is_first) {
      if (!is_first) largest_N = std::max(largest_N, glm::distance(force_N, before_N));
      squares_N2 += glm::dot(force_N, force_N);
      before_N = force_N;
    }
    double of_rms() const { return largest_N / std::sqrt(squares_N2 / kTicks); }
  };
  Jumps felt;
  Jumps whole;  // as if every contact counted wholly from its first tick to its last
  for (int tick = 0; tick < kTicks; ++tick) {
    glm::dvec3 whole_N{0.0};
    const auto found = contacts.find(pose(tick), {}, kTick_s);
    for (const TexturedContact& contact : found) {
      EXPECT_GT(contact.share, 0.0);
      EXPECT_LE(contact.share, 1.0);
      if (contact.is_fading || !is_felt(contact)) continue;
      whole_N += contact_wrench(contact.penetration, contact.frame, kStiffness_N_per_m).force_N;
    }
    felt.add(wrench_about({}, found).force_N, tick == 0);
    whole.add(whole_N, tick == 0);
  }
  RecordProperty("jumps_of_rms",
                 std::to_string(felt.of_rms()) + " " + std::to_string(whole.of_rms()));
  EXPECT_GT(whole.of_rms(), 0.5);
  EXPECT_LT(felt.of_rms(), 0.2);
  EXPECT_LT(changes_of(ring_, block_, pose, kTicks, 0.2e-3).largest, 0.05);
}

// Net over gross work of pressing and lifting without rocking. The shares lag, and less the slower it goes.
TEST_F(RingOnABlock, TakesALittleEnergyFromAHandThatPressesAndLifts) {
  const auto net_over_gross = [&](int ticks) {
    TexturedContacts contacts = between(ring_, block_, sampling_);
    const auto pose = [&](int tick) {
      return pressed(0.0, 1e-3 - 0.8e-3 * std::cos(2.0 * std::numbers::pi * tick / ticks));
    };
    double net_J = 0.0;
    double gross_J = 0.0;
    for (int tick = 0; tick < ticks; ++tick) {
      const Pose from = pose(tick);
      const Pose to = pose(tick + 1);
      const Pose half{.rotation = from.rotation,
                      .position_m = 0.5 * (from.position_m + to.position_m)};
      const double work_J = glm::dot(wrench_about({}, contacts.find(half, {}, kTick_s)).force_N,
                                     to.position_m - from.position_m);
      net_J += work_J;
      gross_J += std::abs(work_J);
    }
    return net_J / gross_J;
  };
  const double fast = net_over_gross(400);
  const double slow = net_over_gross(1600);
  RecordProperty("net_over_gross", std::to_string(fast) + " " + std::to_string(slow));
  EXPECT_LT(fast, 0.0);
  EXPECT_GT(fast, -0.15);
  EXPECT_LT(slow, 0.0);
  EXPECT_GT(slow, 0.75 * fast);
}

}  // namespace
}  // namespace asperity
