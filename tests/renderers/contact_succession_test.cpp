// Contacts that continue, merge, divide and begin, made by hand.

#include "renderers/pd_gradient/contact/contact_succession.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "renderers/pd_gradient/contact/contact_shares.h"

namespace asperity {
namespace {

constexpr double kAlike_m = 1e-6;
constexpr double kMillisecond_s = 0.001;

/// A contact on a plane z = 0 whose deepest place is at (x, 0), in a window of 4 mm around (0, 0).
TexturedContact contact_at(std::uint64_t id, double x_m, double depth_m = 0.1e-3) {
  TexturedContact contact{.id = id,
                          .width_m = 3e-3,
                          .grid = {.width_m = 4e-3, .samples = 64},
                          .penetration = {.depth_m = depth_m, .deepest_m = {x_m, 0.0, 0.0}},
                          .sampled_depth_m = depth_m,
                          .half_extent_m = 2e-3,
                          .filter_m = 0.1e-3,
                          .half_height_m = 2e-3};
  return contact;
}

/// A contact whose window is around its deepest place, far from that of others.
TexturedContact contact_around(std::uint64_t id, double x_m, double depth_m = 0.1e-3) {
  TexturedContact contact = contact_at(id, 0.0, depth_m);
  contact.frame.origin_m.x = x_m;
  contact.origin_in_a_m.x = x_m;
  return contact;
}

/// The two lists live as long as the result.
ContactSuccession succession_of(const std::vector<TexturedContact>& before,
                                const std::vector<TexturedContact>& now, const BodyMotion& motion,
                                bool is_first = false) {
  return ContactSuccession(now, before, motion, kAlike_m, is_first);
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

TEST(ContactShares, FadeWithoutATickAboveThePermittedChange) {
  ContactShares shares;
  const BodyMotion rest;
  std::vector<TexturedContact> before;
  std::vector now{contact_at(1, 0.3e-3, 0.1e-3)};
  shares.update(now, before, rest, kMillisecond_s, false);
  EXPECT_EQ(now[0].share, 1.0);
  const std::uint64_t old_force = now[0].force_id;
  double force_m = 0.1e-3;
  int ticks = 0;
  do {  // another force under the same id replaces it
    before = now;
    now = {contact_at(1, 0.3e-3, 0.15e-3)};
    shares.update(now, before, rest, kMillisecond_s, false);
    double sum_m = 0.0;
    for (const TexturedContact& contact : now) {
      sum_m += contact.share * contact.penetration.depth_m;
      EXPECT_EQ(contact.force_id == old_force, contact.is_fading);
    }
    const double most_m =
        std::max(ContactShares::kMostChange * force_m, ContactShares::kLeastChange_m);
    EXPECT_LE(std::abs(sum_m - force_m), most_m * (1.0 + 1e-9));
    force_m = sum_m;
  } while (++ticks < 100 && now.size() > 1);
  EXPECT_GT(ticks, 9);  // no faster than in 10 ms
  EXPECT_LT(ticks, 30);
  EXPECT_EQ(now[0].share, 1.0);
}

TEST(ContactShares, CountFadingContactsWithoutRoom) {
  ContactShares shares;
  const BodyMotion rest;
  std::vector<TexturedContact> before;
  std::vector<TexturedContact> now;
  for (std::size_t i = 0; i < kMostContacts; ++i) {
    before.push_back(contact_around(i, 20e-3 * static_cast<double>(i)));
    now.push_back(contact_around(100 + i, 20e-3 * static_cast<double>(i) + 10e-3));
  }
  EXPECT_EQ(shares.update(now, before, rest, kMillisecond_s, false), kMostContacts);
  EXPECT_EQ(now.size(), kMostContacts);
  now.pop_back();
  EXPECT_EQ(shares.update(now, before, rest, kMillisecond_s, true),
            0U);  // bodies apart: nothing fades
}

}  // namespace
}  // namespace asperity
