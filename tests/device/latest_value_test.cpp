// The mailbox between two threads.

#include "device/latest_value.h"

#include <thread>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(LatestValue, GivesTheNewestOnceAndForgetsTheOthers) {
  LatestValue<int> box;
  int value = 0;
  EXPECT_FALSE(box.take(value));
  box.put(1);
  box.put(2);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 2);
  EXPECT_FALSE(box.take(value));
  box.put(3);
  EXPECT_TRUE(box.take(value));
  EXPECT_EQ(value, 3);
}

TEST(LatestValue, NeverGivesHalfOfOneAndHalfOfAnother) {
  struct Pair {
    std::int64_t one = 0;
    std::int64_t minus_one = 0;
  };
  constexpr std::int64_t kLast = 200'000;
  LatestValue<Pair> box;
  std::thread writer([&box] {
    for (std::int64_t i = 1; i <= kLast; ++i) box.put({.one = i, .minus_one = -i});
  });
  Pair pair{};
  std::int64_t before = 0;
  while (before < kLast) {
    if (!box.take(pair)) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(pair.one, -pair.minus_one);
    ASSERT_GT(pair.one, before);
    before = pair.one;
  }
  writer.join();
}

}  // namespace
}  // namespace asperity
