// The door through which a maker's thread comes in: nobody leaves while somebody is inside.

#include "device/call_gate.h"

#include <thread>

#include <gtest/gtest.h>

#include "tests/device/long_tick.h"

namespace asperity {
namespace {

void count(void* ticks) noexcept { ++*static_cast<int*>(ticks); }

TEST(CallGate, LetsATickInWhileItIsOpenOnly) {
  int ticks = 0;
  CallGate gate;
  EXPECT_FALSE(gate.pass());
  gate.open({.function = &count, .argument = &ticks});
  EXPECT_TRUE(gate.pass());
  EXPECT_TRUE(gate.pass());
  gate.close();
  EXPECT_FALSE(gate.pass());
  gate.close();
  EXPECT_EQ(ticks, 2);
}

// What the tick works on is freed next.
TEST(CallGate, IsNotClosedBeforeTheTickUnderWayHasEnded) {
  LongTick tick;
  CallGate gate;
  gate.open({.function = &LongTick::run, .argument = &tick});
  std::thread makers([&gate] { gate.pass(); });
  tick.wait_until_begun();
  tick.end_calls([&gate] { gate.close(); });
  EXPECT_FALSE(gate.pass());
  makers.join();
  EXPECT_FALSE(tick.was_left);
  EXPECT_EQ(tick.ticks, 1);
}

}  // namespace
}  // namespace asperity
