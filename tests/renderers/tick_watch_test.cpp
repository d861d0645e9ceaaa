// What is seen from outside of ticks that come, that do not return, and that do not begin.

#include "renderers/servo/tick_watch.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace asperity {
namespace {

using Verdict = TickWatch::Verdict;

/// The number of looks, one every 5 ms, until one is of this verdict; 0: none of `most`.
int looks_until(Verdict verdict, TickWatch& watch, const TickProgress& seen, int most = 1000) {
  static constexpr std::int64_t kBegan_ns = 1'000'000'000;
  for (int look = 1; look <= most; ++look) {
    if (watch.look(seen, kBegan_ns + look * TickWatch::kBetweenLooks_ns) == verdict) return look;
  }
  return 0;
}

TEST(TickWatch, IsContentWhileTicksCome) {
  TickWatch watch({}, Pacing::ours);
  for (std::uint64_t tick = 0; tick < 1000; ++tick) {
    EXPECT_EQ(watch.look({.begun = tick + 1, .ended = tick, .presenting = true},
                         static_cast<std::int64_t>(tick) * 49'000'000),
              Verdict::well);
  }
}

// The first look begins the time; more than 50 ms have passed at the twelfth.
TEST(TickWatch, SeesATickThatDoesNotReturnAfterFiftyMilliseconds) {
  TickWatch watch({}, Pacing::ours);
  EXPECT_EQ(looks_until(Verdict::standing, watch, {.begun = 8, .ended = 7, .presenting = true}),
            12);
}

TEST(TickWatch, SeesAThreadThatBeginsNoTickLikeATickThatDoesNotReturn) {
  TickWatch watch({}, Pacing::ours);
  EXPECT_EQ(looks_until(Verdict::standing, watch, {.begun = 7, .ended = 7, .presenting = true}),
            12);
}

TEST(TickWatch, ContinuesToSeeItUntilATickReturns) {
  TickWatch watch({}, Pacing::ours);
  TickProgress seen{.begun = 8, .ended = 7, .presenting = true};
  ASSERT_GT(looks_until(Verdict::standing, watch, seen), 0);
  EXPECT_EQ(watch.look(seen, 9'000'000'000), Verdict::standing);
  seen.ended = 8;
  EXPECT_EQ(watch.look(seen, 9'005'000'000), Verdict::well);
  EXPECT_EQ(watch.look(seen, 9'010'000'000), Verdict::well);
}

// A session waits for a tick also where there is no force.
TEST(TickWatch, WaitsForASecondWhereNoSurfaceIsPresented) {
  TickWatch watch({}, Pacing::ours);
  EXPECT_EQ(looks_until(Verdict::standing, watch, {.begun = 8, .ended = 7}), 202);
}

TEST(TickWatch, DoesNotCountTheTimeInWhichItWasStoppedWhereNoSurfaceIsPresented) {
  TickWatch watch({}, Pacing::ours);
  const TickProgress seen{.begun = 8, .ended = 7};
  EXPECT_EQ(watch.look(seen, 1'000'000'000), Verdict::well);
  EXPECT_EQ(watch.look(seen, 3'600'000'000'000), Verdict::well);
}

TEST(TickWatch, TellsASilenceOfADeviceFromATickThatDoesNotReturn) {
  TickWatch silent({}, Pacing::theirs);
  EXPECT_EQ(looks_until(Verdict::silent, silent, {.begun = 7, .ended = 7}), 12);
  TickWatch hanging({}, Pacing::theirs);
  EXPECT_EQ(looks_until(Verdict::standing, hanging, {.begun = 8, .ended = 7, .presenting = true}),
            12);
}

}  // namespace
}  // namespace asperity
