// Times of events on the steady clock: delays, jumps, drift and stamps of 32 bits.

#include "app/gui/participant/event_clock.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

constexpr std::int64_t kMs = 1'000'000;

EventClock stamped() { return EventClock(EventClock::Stamps::of_window_system); }

TEST(EventClock, TakesTheDelayOfABusyWindowOutOfTheTime) {
  EventClock clock = stamped();
  // The window system's clock is 1000 ms behind; this event was heard at once.
  EXPECT_EQ(clock.happened_ns(4000, 5000 * kMs), 5000 * kMs);
  // Pressed at 5300, heard 250 ms later.
  EXPECT_EQ(clock.happened_ns(4300, 5550 * kMs), 5300 * kMs);
}

TEST(EventClock, IsNeverLaterThanTheHearing) {
  EventClock clock = stamped();
  clock.happened_ns(4000, 5200 * kMs);  // heard late: the clock seems 1200 ms behind
  EXPECT_EQ(clock.happened_ns(4500, 5501 * kMs), 5501 * kMs);  // it is 1001 at most
  EXPECT_EQ(clock.happened_ns(4700, 5801 * kMs), 5701 * kMs);
}

TEST(EventClock, CountsOnWhereThirtyTwoBitsEnd) {
  EventClock clock = stamped();
  const std::uint64_t last = 0xFFFFFFFFULL;
  EXPECT_EQ(clock.happened_ns(last - 99, 1000 * kMs), 1000 * kMs);
  EXPECT_EQ(clock.happened_ns(100, 1230 * kMs), 1200 * kMs);  // 200 ms on, heard 30 ms late
}

TEST(EventClock, BeginsAnewWhenTheOtherClockJumps) {
  EventClock clock = stamped();
  clock.happened_ns(1'000'000, 5000 * kMs);
  EXPECT_EQ(clock.happened_ns(7, 6000 * kMs), 6000 * kMs);  // 1000 s back
  EXPECT_EQ(clock.happened_ns(107, 6120 * kMs), 6100 * kMs);
  EXPECT_EQ(clock.happened_ns(900'000, 6200 * kMs), 6200 * kMs);  // far ahead
  EXPECT_EQ(clock.happened_ns(900'100, 6310 * kMs), 6300 * kMs);
}

TEST(EventClock, FollowsAClockThatDriftsAway) {
  EventClock clock = stamped();
  // One part in a thousand too slow, an event a second for ten minutes, all heard at once.
  std::int64_t error_ns = 0;
  for (std::int64_t second = 1; second <= 600; ++second) {
    const std::int64_t now_ns = second * 1000 * kMs;
    error_ns = now_ns - clock.happened_ns(static_cast<std::uint64_t>(second * 999), now_ns);
  }
  // Two minutes' worth of drift at most: 0.12 s.
  EXPECT_LE(error_ns, 121 * kMs);
}

TEST(EventClock, TakesTheHearingWhereThereIsNoStamp) {
  EventClock clock = stamped();
  clock.happened_ns(4000, 5000 * kMs);
  EXPECT_EQ(clock.happened_ns(0, 5100 * kMs), 5100 * kMs);
  EventClock off_screen(EventClock::Stamps::invented);
  EXPECT_EQ(off_screen.happened_ns(4000, 5000 * kMs), 5000 * kMs);
  EXPECT_EQ(off_screen.happened_ns(4001, 6000 * kMs), 6000 * kMs);
}

}  // namespace
}  // namespace asperity
