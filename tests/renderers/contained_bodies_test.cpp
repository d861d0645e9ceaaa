// Bodies of which one contains the other, with and without a contact before.

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <string>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/contact_shares.h"
#include "renderers/pd_gradient/contact/textured_contacts.h"
#include "tests/renderers/contact_paths.h"
#include "tests/renderers/contact_scenes.h"
#include "tests/renderers/meshes.h"
#include "tests/renderers/textured_bodies.h"

namespace asperity {
namespace {

// Deeper and deeper until the ball is completely inside, and out again.
TEST(TexturedContacts, KeepABallThatIsPressedWhollyIn) {
  const TexturedMesh tool = bare(ball(1e-3, 12, 16));
  const TexturedMesh plate = grated_plate({.amplitude_m = 0.02e-3, .wavelength_m = 1.2e-3});
  TexturedContacts contacts = between(tool, plate, hard(0.1e-3));
  bool was_kept = false;
  const auto depth_m = [&](double z_m) {
    const auto found = contacts.find(pose_at({0.3e-3, 0.0, z_m}), {}, kTick_s);
    double deepest_m = 0.0;
    for (const TexturedContact& contact : found) {
      deepest_m = std::max(deepest_m, contact.penetration.depth_m);
      was_kept = was_kept || contact.is_kept;
      EXPECT_GT(contact.frame.n.z, 0.95) << z_m;
    }
    return deepest_m;
  };
  double before_m = depth_m(0.5e-3);
  for (double z_m = 0.48e-3; z_m > -4e-3; z_m -= 20e-6) {
    const double now_m = depth_m(z_m);
    EXPECT_NEAR(now_m - before_m, 20e-6, 8e-6) << z_m;
    before_m = now_m;
  }
  EXPECT_TRUE(was_kept);
  EXPECT_NEAR(before_m, 5e-3, 0.05e-3);
  before_m = depth_m(-4e-3);
  for (double z_m = -3.98e-3; z_m < 1.2e-3; z_m += 20e-6) {
    const double now_m = depth_m(z_m);
    EXPECT_NEAR(before_m - now_m, now_m > 0.0 ? 20e-6 : 0.0, 25e-6) << z_m;
    before_m = now_m;
  }
  EXPECT_EQ(before_m, 0.0);
}

TEST(TexturedContacts, LetGoOfAKeptBodyThatLeavesTheOther) {
  const TexturedMesh tool = bare(ball(1e-3, 12, 16));
  const TexturedMesh block = bare(box({0.01, 0.01, 0.01}));
  TexturedContacts contacts = between(tool, block, hard(0.1e-3));
  for (double z_m = 5.5e-3; z_m > 3e-3; z_m -= 50e-6)
    contacts.find(pose_at({0.0, 0.0, z_m}), {}, kTick_s);
  ASSERT_EQ(contacts.find(pose_at({0.0, 0.0, 3e-3}), {}, kTick_s).size(), 1U);
  EXPECT_TRUE(contacts.find(pose_at({0.0, 0.0, 3e-3}), {}, kTick_s)[0].is_kept);
  EXPECT_TRUE(contacts.find(pose_at({0.02, 0.0, 3e-3}), {}, kTick_s).empty());
  EXPECT_TRUE(contacts.find(pose_at({0.0, 0.0, 3e-3}), {}, kTick_s)
                  .empty());  // it went in without a contact
  for (double z_m = 5.5e-3; z_m > 3e-3; z_m -= 50e-6)
    contacts.find(pose_at({0.0, 0.0, z_m}), {}, kTick_s);
  contacts.reset();
  EXPECT_TRUE(contacts.find(pose_at({0.0, 0.0, 3e-3}), {}, kTick_s).empty());
}

// Under a thin plate the depth along the old n would go on growing.
TEST(TexturedContacts, ForgetAContactOnceTheBodiesAreApart) {
  TexturedContacts contacts =
      between(bare(box({0.006, 0.006, 0.001})), bare(box({0.02, 0.02, 0.002})), hard(0.1e-3));
  const auto found = contacts.find(pose_at({0.0, 0.0, 1.1e-3}), {}, kTick_s);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(is_first_felt(found));
  EXPECT_TRUE(contacts.find(pose_at({0.0, 0.0, -1.6e-3}), {}, kTick_s).empty());
}

TEST(TexturedContacts, SayThatABodyIsInsideWithoutHavingBeenFelt) {
  const TexturedMesh tool = bare(ball(1e-3, 12, 16));
  const TexturedMesh block = bare(box({0.01, 0.01, 0.01}));
  TexturedContacts contacts = between(tool, block, hard(0.1e-3));
  const auto is_inside = [&](const glm::dvec3& place_m) {
    contacts.find(pose_at(place_m), {}, kTick_s);
    return contacts.is_inside();
  };
  EXPECT_TRUE(is_inside({0.0, 0.0, 0.0}));  // in the first call
  EXPECT_TRUE(is_inside({0.0, 0.0, 0.1e-3}));
  EXPECT_FALSE(is_inside({0.0, 0.0, 8e-3}));
  EXPECT_FALSE(is_inside({0.02, 0.0, 0.0}));
  EXPECT_TRUE(is_inside({0.0, 0.0, 0.0}));  // from outside in one call
  EXPECT_FALSE(is_inside({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}));
  contacts.reset();
  for (double z_m = 6.5e-3; z_m > 0.0; z_m -= 50e-6) {  // kept on the way in
    EXPECT_FALSE(is_inside({0.0, 0.0, z_m})) << z_m;
  }
  contacts.reset();
  EXPECT_TRUE(is_inside({0.0, 0.0, 0.0}));
  // The tool may be the larger one.
  TexturedContacts around = between(block, tool, hard(0.1e-3));
  around.find({}, {}, kTick_s);
  EXPECT_TRUE(around.is_inside());
}

TEST(TexturedContacts, SayWhetherBodiesTouchOrHoldEachOther) {
  const TexturedMesh small = bare(ball(1e-3, 8, 10));
  const TexturedMesh large = bare(box({0.01, 0.01, 0.01}));
  for (const bool tool_is_small : {true, false}) {
    TexturedContacts contacts =
        tool_is_small ? between(small, large, hard(0.1e-3)) : between(large, small, hard(0.1e-3));
    EXPECT_TRUE(contacts.touch(pose_at({0.0, 0.0, 0.0}), pose_at({0.0, 0.0, 0.001})));    // inside
    EXPECT_TRUE(contacts.touch(pose_at({0.0, 0.0, 0.0}), pose_at({0.0, 0.0, 0.005})));    // cut
    EXPECT_FALSE(contacts.touch(pose_at({0.0, 0.0, 0.0}), pose_at({0.0, 0.0, 0.0065})));  // apart
  }
}

TEST(TexturedContacts, FadeTheOneOfTwoBallsThatGoesWhollyIn) {
  const ContactPath path = one_of_two_balls_enters();
  TexturedContacts contacts = contacts_of(path);
  glm::dvec3 before_N{0.0};
  int faded = 0;
  for (int tick = 0; tick < path.ticks; ++tick) {
    const auto found = contacts.find(path.pose(tick), {}, kTick_s);
    const glm::dvec3 force_N = wrench_about({}, found).force_N;
    EXPECT_LT(glm::distance(force_N, before_N), 0.3) << tick;
    before_N = force_N;
    for (const TexturedContact& contact : found) faded += contact.is_fading ? 1 : 0;
  }
  // From 2.7 to 1.9 N by 4 % of the force in a tick, and by a tenth of its own where that is less.
  EXPECT_NEAR(faded, 25, 8);
  EXPECT_NEAR(before_N.z, 1.8, 0.1);  // of the other one
}

// The smaller of two balls goes completely in and comes out 0.4 mm deep, which is not too deep to be believed at
// once.
TEST(TexturedContacts, RiseWhereABallComesOutAgain) {
  const ContactPath path = small_ball_enters_and_leaves();
  TexturedContacts contacts = contacts_of(path);
  double before_N = 0.0;
  bool has_begun = false;
  int rose = 0;
  for (int tick = 0; tick < path.ticks; ++tick) {
    const auto found = contacts.find(path.pose(tick), {}, kTick_s);
    const double force_N = wrench_about({}, found).force_N.z;
    EXPECT_NEAR(force_N, before_N, 0.1) << tick;
    before_N = force_N;
    for (const TexturedContact& contact : found) {
      if (!is_felt(contact)) continue;
      if (!has_begun) {
        EXPECT_EQ(contact.share, 1.0);  // it begins here
      }
      has_begun = true;
      rose += tick > path.ticks / 2 && !contact.is_fading && contact.share < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(rose, ContactShares::kBlend_s / kTick_s);
  EXPECT_LT(rose, 50);
}

// Through a torus, from outside to outside.
TEST(HeldPoint, AnswersAsAllFacesDoAndVisitsThemRarely) {
  const TexturedBody body(bare(bumpy_torus(30, 20)), 1.0);
  HeldPoint held;
  constexpr int kSteps = 3000;
  int inside = 0;
  for (int step = 0; step < kSteps; ++step) {
    const glm::dvec3 point_m{-0.06 + 0.12 * step / kSteps, 0.005, 0.002};
    const bool is_in = body.whereabouts(point_m).is_inside;
    ASSERT_EQ(held.is_in(body, point_m), is_in) << step;
    inside += is_in ? 1 : 0;
  }
  EXPECT_GT(inside, kSteps / 4);
  EXPECT_LT(inside, 3 * kSteps / 4);
  RecordProperty("visits", std::to_string(held.visits()));
  EXPECT_LT(held.visits(), static_cast<std::uint64_t>(kSteps / 10));
}

}  // namespace
}  // namespace asperity
