// Contacts that continue, merge, divide and begin, made by hand.

#include "renderers/pd_gradient/contact/contact_succession.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderers/handmade_contacts.h"

namespace asperity {
namespace {

constexpr double kAlike_m = 1e-6;

ContactSuccession succession_of(const std::vector<TexturedContact>& before,
                                const std::vector<TexturedContact>& now, const BodyMotion& motion,
                                bool is_first = false) {
  return ContactSuccession(
      {.now = now, .before = before, .motion = motion, .alike_m = kAlike_m, .is_first = is_first});
}

TEST(ContactSuccession, ContinuesAContactThatDoesNotChange) {
  const std::vector all{contact_at(1, 0.3e-3)};
  const BodyMotion rest;
  const ContactSuccession found = succession_of(all, all, rest);
  EXPECT_EQ(found.predecessor(0), std::optional<std::size_t>(0));
  EXPECT_TRUE(found.continues(0));
  EXPECT_TRUE(found.is_owner(0));
  EXPECT_FALSE(found.rises(0));
}

TEST(ContactSuccession, ReplacesAForceThatTheMotionDoesNotExplain) {
  const std::vector before{contact_at(1, 0.3e-3)};
  const BodyMotion rest;
  for (const bool is_alike : {true, false}) {
    const double change_m = (is_alike ? 0.9 : 1.1) * kAlike_m;
    const std::vector now{contact_at(1, 0.3e-3, 0.1e-3 + change_m)};
    const ContactSuccession found = succession_of(before, now, rest);
    EXPECT_EQ(found.predecessor(0).has_value(), is_alike);
    EXPECT_EQ(found.continues(0), is_alike);
    EXPECT_EQ(found.rises(0), !is_alike);
  }
}

TEST(ContactSuccession, PermitsTheChangeThatFlanksOf60DegreesCause) {
  const double way_m = 20e-6;
  BodyMotion aside;
  aside.X_WA.position_m.x = way_m;
  const std::vector before{contact_at(1, 0.3e-3)};
  const auto continues = [&](double change_m) {
    const std::vector now{contact_at(1, 0.3e-3, 0.1e-3 + change_m)};
    return succession_of(before, now, aside).continues(0);
  };
  EXPECT_TRUE(continues(1.7 * way_m));
  EXPECT_FALSE(continues(1.8 * way_m + kAlike_m));
}

TEST(ContactSuccession, ContinuesOfTwoThatMergeTheOneAtTheDeepestPlace) {
  const std::vector before{contact_at(1, -0.8e-3), contact_at(2, 0.8e-3)};
  const std::vector now{contact_at(1, 0.8e-3)};
  const BodyMotion rest;
  const ContactSuccession found = succession_of(before, now, rest);
  EXPECT_EQ(found.predecessor(0), std::optional<std::size_t>(1));
  EXPECT_FALSE(found.continues(0));
  EXPECT_TRUE(found.continues(1));
}

TEST(ContactSuccession, ContinuesAContactThatDividesInThePartAtItsDeepestPlace) {
  const std::vector before{contact_at(1, 0.8e-3)};
  const BodyMotion rest;
  for (const std::size_t part : {0U, 1U}) {  // the part with the old id, or the other one
    std::vector now{contact_at(1, part == 0 ? 0.8e-3 : -0.8e-3),
                    contact_at(2, part == 0 ? -0.8e-3 : 0.8e-3)};
    const ContactSuccession found = succession_of(before, now, rest);
    EXPECT_EQ(found.predecessor(part), std::optional<std::size_t>(0));
    EXPECT_EQ(found.predecessor(1 - part), std::nullopt);
    EXPECT_FALSE(found.rises(part));
    EXPECT_TRUE(found.rises(1 - part));
    EXPECT_TRUE(found.continues(0));
  }
}

TEST(ContactSuccession, BeginsAtOnceWhereTheToolHasJustArrived) {
  const std::vector<TexturedContact> none;
  const std::vector now{contact_around(1, 0.0)};
  const BodyMotion rest;
  EXPECT_TRUE(succession_of(none, now, rest).rises(0));  // it would have been rendered before
  EXPECT_FALSE(succession_of(none, now, rest, true).rises(0));
  BodyMotion down;
  down.X_WA_before.position_m.z = 0.2e-3;
  EXPECT_FALSE(succession_of(none, now, down).rises(0));
}

TEST(ContactSuccession, RisesWhereADoubtfulDepthBecomesCredible) {
  std::vector doubtful{contact_at(1, 0.3e-3)};
  doubtful[0].is_doubtful = true;
  const std::vector credible{contact_at(1, 0.3e-3)};
  const BodyMotion rest;
  const ContactSuccession risen = succession_of(doubtful, credible, rest);
  EXPECT_EQ(risen.predecessor(0), std::nullopt);
  EXPECT_TRUE(risen.rises(0));
  const ContactSuccession lost = succession_of(credible, doubtful, rest);
  EXPECT_FALSE(lost.continues(0));
}

TEST(ContactSuccession, RendersAPlaceOnce) {
  const std::vector now{contact_at(1, 0.3e-3, 0.1e-3), contact_at(2, 0.3e-3, 0.2e-3),
                        contact_around(3, 20e-3)};
  const BodyMotion rest;
  const ContactSuccession first = succession_of({}, now, rest);
  EXPECT_FALSE(first.is_owner(0));
  EXPECT_TRUE(first.is_owner(1));  // the deeper one
  EXPECT_TRUE(first.is_owner(2));
  const std::vector before{contact_at(1, 0.3e-3, 0.1e-3)};
  const ContactSuccession later = succession_of(before, now, rest);
  EXPECT_TRUE(later.is_owner(0));  // the one that was rendered
  EXPECT_FALSE(later.is_owner(1));
}

// Two curves in one window: the deepest place of the first is inside the curve of the second.
TEST(ContactSuccession, GivesAPlaceInsideAnotherCurveToItsContact) {
  std::vector now{contact_at(1, 1.5e-3, 0.2e-3), contact_around(2, 1.6e-3, 0.1e-3)};
  now[0].half_extent_m = 0.5e-3;
  now[1].half_extent_m = 0.5e-3;
  const BodyMotion rest;
  const ContactSuccession found = succession_of({}, now, rest);
  EXPECT_FALSE(found.is_owner(0));  // though it is deeper
  EXPECT_TRUE(found.is_owner(1));
}

TEST(ContactSuccession, ContinuesNothingWhoseDeepestPlaceWasOutsideTheWindow) {
  const std::vector before{contact_at(1, 0.3e-3)};
  const std::vector now{contact_at(1, 2.1e-3)};  // the same force
  const BodyMotion rest;
  EXPECT_FALSE(succession_of(before, now, rest).continues(0));
}

}  // namespace
}  // namespace asperity
