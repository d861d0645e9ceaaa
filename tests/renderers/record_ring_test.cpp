// The ring alone, full, and between two threads.

#include "renderers/servo/record_ring.h"

#include <atomic>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TickRecord numbered(std::uint64_t number) {
  TickRecord record;
  record.presentation = number;
  record.penetration_m = static_cast<double>(number);
  return record;
}

TEST(RecordRing, GivesBackWhatWasPushedInOrder) {
  RecordRing ring(8);
  TickRecord record;
  EXPECT_FALSE(ring.pop(record));
  for (std::uint64_t i = 1; i <= 3; ++i) ring.push(numbered(i));
  for (std::uint64_t i = 1; i <= 3; ++i) {
    ASSERT_TRUE(ring.pop(record));
    EXPECT_EQ(record.presentation, i);
  }
  EXPECT_FALSE(ring.pop(record));
}

TEST(RecordRing, RoundsItsCapacityUpToAPowerOfTwo) {
  RecordRing ring(5);
  for (std::uint64_t i = 1; i <= 8; ++i) ring.push(numbered(i));
  EXPECT_EQ(ring.lost(), 0U);
  ring.push(numbered(9));
  EXPECT_EQ(ring.lost(), 1U);
}

TEST(RecordRing, DropsTheNewestWhenFullAndCountsIt) {
  RecordRing ring(2);
  for (std::uint64_t i = 1; i <= 5; ++i) ring.push(numbered(i));
  EXPECT_EQ(ring.lost(), 3U);
  TickRecord record;
  ASSERT_TRUE(ring.pop(record));
  EXPECT_EQ(record.presentation, 1U);
  ASSERT_TRUE(ring.pop(record));
  EXPECT_EQ(record.presentation, 2U);
  EXPECT_FALSE(ring.pop(record));
  ring.push(numbered(6));
  ASSERT_TRUE(ring.pop(record));
  EXPECT_EQ(record.presentation, 6U);
}

// Under ThreadSanitizer this is the proof that no record is read while it is written. It ends with the producer,
// whatever is lost without being counted.
TEST(RecordRing, LosesNothingUncountedBetweenTwoThreads) {
  constexpr std::uint64_t kCount = 200'000;
  RecordRing ring(64);
  std::atomic<bool> all_pushed{false};
  std::thread producer([&] {
    for (std::uint64_t i = 1; i <= kCount; ++i) ring.push(numbered(i));
    all_pushed.store(true);
  });
  std::uint64_t received = 0;
  std::uint64_t last = 0;
  const auto take_all = [&] {
    TickRecord record;
    while (ring.pop(record)) {
      ASSERT_GT(record.presentation, last);
      ASSERT_EQ(record.penetration_m, static_cast<double>(record.presentation));
      last = record.presentation;
      ++received;
    }
  };
  for (bool is_last = false; !is_last && !HasFatalFailure();) {
    is_last = all_pushed.load();
    take_all();
  }
  producer.join();
  EXPECT_EQ(received + ring.lost(), kCount);
}

}  // namespace
}  // namespace asperity
