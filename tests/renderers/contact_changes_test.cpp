// How much the force changes where contacts begin, merge, divide and end.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/renderers/contact_paths.h"
#include "tests/renderers/unexplained_change.h"

namespace asperity {
namespace {

struct Change {
  double largest = 0.0;     // unexplained, relative to the current force, or to 0.1 N
  double largest_N = 0.0;   // of the force
  double opposition = 0.0;  // the largest ratio of the forces' magnitudes, above 1 N, to their sum
};

constexpr double kMost = 0.045;

Change changes_of(const ContactPath& path) {
  constexpr double kLeast_N = 0.1;
  TexturedContacts contacts = contacts_of(path);
  for (int tick = 0; tick < path.ticks_at_rest; ++tick) contacts.find(path.pose(0), {}, kTick_s);
  UnexplainedChange unexplained;
  Change change;
  for (int tick = 0; tick < path.ticks; ++tick) {
    const Pose pose = path.pose(tick);
    const UnexplainedChange::Tick found = unexplained.add(contacts.find(pose, {}, kTick_s), pose);
    change.largest = std::max(change.largest, found.part(kLeast_N));
    change.largest_N = std::max(change.largest_N, found.current_N);
    if (found.magnitudes_N > 1.0) {
      change.opposition = std::max(change.opposition, found.magnitudes_N / found.current_N);
    }
  }
  return change;
}

TEST(ContactChanges, AreLessThanATwentiethOfTheForceWhereOneOfTwoBallsGoesIn) {
  const Change in = changes_of(one_of_two_balls_enters());
  EXPECT_GT(in.largest, 0.01);
  EXPECT_LT(in.largest, kMost);
  EXPECT_GT(in.largest_N, 2.0);
  EXPECT_LT(changes_of(small_ball_enters_and_leaves()).largest, kMost);
}

// A box that is pressed on a floor and slides against a step. It was as deep as in the upper floor, and pushed to the side
// with the steepest slope, from one tick to the next: up to 2.7 N.
TEST(ContactChanges, AreSmallAtALowStep) {
  constexpr int kBeforeStep = 300;
  for (const double high_m : {0.2e-3, 0.5e-3, 1e-3}) {
    for (const double angle_rad : {0.25 * std::numbers::pi, 0.5 * std::numbers::pi}) {
      for (const double in_m : {0.3e-3, 0.8e-3}) {
        ContactPath slide =
            box_against({.high_m = high_m, .angle_rad = angle_rad, .pressed_m = in_m});
        slide.pose = [pose = slide.pose](int tick) { return pose(tick + kBeforeStep); };
        slide.ticks = 300;
        const Change change = changes_of(slide);
        EXPECT_LT(change.largest, kMost) << high_m << ' ' << angle_rad << ' ' << in_m;
        EXPECT_GT(change.largest_N, 1.1 * kStiffness_N_per_m * in_m);
      }
    }
  }
}

// The upper side of the plate pushes up and the lower one down, with up to 2 N each and a tenth of it together.
TEST(ContactChanges, AreSmallWhereContactsOfTwoSidesOpposeEachOther) {
  constexpr double kPressed_m = 0.1e-3;
  const ContactPath through{.name = "ball through a thin plate",
                            .tool = bare(ball(2e-3, 24, 32)),
                            .surface = bare(box({0.02, 0.02, 0.5e-3})),
                            .pose =
                                [](int tick) {
                                  return pose_at({0.0, 0.0, 2.25e-3 - kPressed_m - 5e-6 * tick});
                                },
                            .ticks = 640};
  const Change change = changes_of(through);
  EXPECT_GT(change.largest, 0.01);
  EXPECT_LT(change.largest, kMost);
  EXPECT_GT(change.largest_N, 0.6);
  EXPECT_GT(change.opposition, 3.0);
}

TEST(ContactChanges, AreSmallWhereADoubtfulDepthIsBelieved) {
  const Change change = changes_of(needle_that_is_suddenly_deep());
  EXPECT_LT(change.largest, kMost);
  EXPECT_NEAR(change.largest_N, 3.0, 0.1);
}

TEST(RingOnABlock, JumpsLittleWhereContactsPartAndJoin) {
  const ContactPath path = ring_that_rocks();
  TexturedContacts contacts = contacts_of(path);
  for (int tick = 0; tick < path.ticks_at_rest; ++tick) contacts.find(path.pose(0), {}, kTick_s);
  struct Jumps {
    glm::dvec3 before_N{0.0};
    double largest_N = 0.0;
    double squares_N2 = 0.0;
    int ticks = 0;
    void add(const glm::dvec3& force_N, bool is_first) {
      if (!is_first) largest_N = std::max(largest_N, glm::distance(force_N, before_N));
      squares_N2 += glm::dot(force_N, force_N);
      before_N = force_N;
      ++ticks;
    }
    double of_rms() const { return largest_N / std::sqrt(squares_N2 / ticks); }
  };
  Jumps felt;
  Jumps whole;  // as if every contact counted wholly from its first tick to its last
  for (int tick = 0; tick < path.ticks; ++tick) {
    glm::dvec3 whole_N{0.0};
    const auto found = contacts.find(path.pose(tick), {}, kTick_s);
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
  EXPECT_LT(changes_of(path).largest, kMost);
}

// Net over gross work of pressing and lifting without rocking. The shares lag, and less the slower it goes.
TEST(RingOnABlock, TakesALittleEnergyFromAHandThatPressesAndLifts) {
  const auto net_over_gross = [](int ticks) {
    const PathWork work = work_around(ring_that_is_pressed(), ticks);
    return work.net_J / work.gross_J;
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
