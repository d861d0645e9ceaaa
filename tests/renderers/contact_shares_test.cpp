// How contacts made by hand rise and fade.

#include "renderers/pd_gradient/contact/contact_shares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/renderers/handmade_contacts.h"

namespace asperity {
namespace {

constexpr double kMillisecond_s = 0.001;

TEST(ContactShares, FadeWithoutATickAboveThePermittedChange) {
  ContactShares shares;
  const BodyMotion rest;
  std::vector<TexturedContact> before;
  std::vector now{contact_at(1, 0.3e-3, 0.1e-3)};
  shares.update(now, before, {.motion = rest, .dt_s = kMillisecond_s, .is_first = true});
  EXPECT_EQ(now[0].share, 1.0);
  const std::uint64_t old_force = now[0].force_id;
  double force_m = 0.1e-3;
  int ticks = 0;
  do {  // another force under the same id replaces it
    before = now;
    now = {contact_at(1, 0.3e-3, 0.15e-3)};
    shares.update(now, before, {.motion = rest, .dt_s = kMillisecond_s});
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

/// A full list of contacts, and another one at other places.
struct FullLists {
  std::vector<TexturedContact> before{};
  std::vector<TexturedContact> now{};

  FullLists() {
    for (std::size_t i = 0; i < kMostContacts; ++i) {
      before.push_back(contact_around(i, 20e-3 * static_cast<double>(i)));
      now.push_back(contact_around(100 + i, 20e-3 * static_cast<double>(i) + 10e-3));
    }
  }
};

TEST(ContactShares, CountFadingContactsWithoutRoom) {
  ContactShares shares;
  const BodyMotion rest;
  FullLists lists;
  EXPECT_EQ(shares.update(lists.now, lists.before, {.motion = rest, .dt_s = kMillisecond_s}),
            kMostContacts);
  EXPECT_EQ(lists.now.size(), kMostContacts);
}

TEST(ContactShares, FadeNothingWhereTheBodiesAreApart) {
  ContactShares shares;
  const BodyMotion rest;
  FullLists lists;
  lists.now.resize(3);
  const ContactShares::Tick apart{.motion = rest, .dt_s = kMillisecond_s, .are_apart = true};
  EXPECT_EQ(shares.update(lists.now, lists.before, apart), 0U);
  EXPECT_EQ(lists.now.size(), 3U);
}

}  // namespace
}  // namespace asperity
