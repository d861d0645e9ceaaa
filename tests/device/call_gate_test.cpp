// The door through which a maker's thread comes in: nobody leaves while somebody is inside.

#include "device/call_gate.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace asperity {
namespace {

struct SlowTick {
  std::atomic<bool> has_begun{false};
  std::atomic<bool> has_ended{false};
  std::chrono::milliseconds lasts{0};
  int ticks = 0;

  static void run(void* self) noexcept {
    auto* tick = static_cast<SlowTick*>(self);
    ++tick->ticks;
    tick->has_begun = true;
    std::this_thread::sleep_for(tick->lasts);
    tick->has_ended = true;
  }
};

TEST(CallGate, LetsATickInWhileItIsOpenOnly) {
  SlowTick tick;
  CallGate gate;
  EXPECT_FALSE(gate.pass());
  gate.open({.function = &SlowTick::run, .argument = &tick});
  EXPECT_TRUE(gate.pass());
  EXPECT_TRUE(gate.pass());
  gate.close();
  EXPECT_FALSE(gate.pass());
  gate.close();
  EXPECT_EQ(tick.ticks, 2);
}

// What the tick works on is freed next.
TEST(CallGate, IsNotClosedBeforeTheTickUnderWayHasEnded) {
  SlowTick tick;
  tick.lasts = std::chrono::milliseconds(700);
  CallGate gate;
  gate.open({.function = &SlowTick::run, .argument = &tick});
  std::thread makers([&gate] { gate.pass(); });
  while (!tick.has_begun) std::this_thread::yield();
  gate.close();
  EXPECT_TRUE(tick.has_ended);
  EXPECT_FALSE(gate.pass());
  makers.join();
  EXPECT_EQ(tick.ticks, 1);
}

}  // namespace
}  // namespace asperity
