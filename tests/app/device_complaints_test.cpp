// What of a device's complaints is shown, and what is told.

#include "app/session/rig/device_complaints.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

TEST(DeviceComplaints, AreAskedForFourTimesASecond) {
  DeviceComplaints complaints;
  EXPECT_TRUE(complaints.is_due(0));
  complaints.hear("", 0);
  EXPECT_FALSE(complaints.is_due(kSecond_ns / 4 - 1));
  EXPECT_TRUE(complaints.is_due(kSecond_ns / 4));
}

TEST(DeviceComplaints, AreToldAtOnceWhenTheyBeginAndWhenTheyAreOver) {
  DeviceComplaints complaints;
  EXPECT_FALSE(complaints.hear("", 0).is_to_tell);
  for (std::int64_t ns = kSecond_ns; ns < 4 * kSecond_ns; ns += kSecond_ns) {
    for (const char* words : {"Unplugged.", ""}) {
      const DeviceComplaints::News news = complaints.hear(words, ns);
      EXPECT_TRUE(news.is_new && news.turns && news.is_to_tell);
      const DeviceComplaints::News again = complaints.hear(words, ns + 1);
      EXPECT_FALSE(again.is_new || again.turns || again.is_to_tell);
    }
  }
}

TEST(DeviceComplaints, AreShownInTheirWordsAndToldInThemEveryTenSeconds) {
  DeviceComplaints complaints;
  constexpr std::int64_t kBegan_ns = 100 * kSecond_ns;
  complaints.hear("Once.", kBegan_ns);
  const auto later = [&](const char* words, std::int64_t after_ns) {
    return complaints.hear(words, kBegan_ns + after_ns);
  };
  const DeviceComplaints::News soon = later("Twice.", kSecond_ns);
  EXPECT_TRUE(soon.is_new);
  EXPECT_FALSE(soon.turns || soon.is_to_tell);
  EXPECT_FALSE(later("Thrice.", 10 * kSecond_ns - 1).is_to_tell);
  // What was not told yet is told when it is time, though it has not changed since.
  const DeviceComplaints::News due = later("Thrice.", 10 * kSecond_ns);
  EXPECT_TRUE(due.is_to_tell);
  EXPECT_FALSE(due.is_new);
  EXPECT_FALSE(later("Often.", 20 * kSecond_ns - 1).is_to_tell);
  EXPECT_TRUE(later("Often.", 20 * kSecond_ns).is_to_tell);
}

TEST(DeviceComplaints, AreNotToldAnewInTheWordsThatWereTold) {
  DeviceComplaints complaints;
  complaints.hear("Once.", 0);
  complaints.hear("Twice.", kSecond_ns);
  EXPECT_FALSE(complaints.hear("Once.", 20 * kSecond_ns).is_to_tell);
}

}  // namespace
}  // namespace asperity
