// The allocation guard sees every way to the heap, and only its own thread's.

#include "tests/support/allocation_guard.h"

#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

#define SKIP_WHERE_SANITIZERS_OWN_THE_HEAP() \
  if (!AllocationGuard::kCounts) GTEST_SKIP() << "a sanitizer owns malloc here"

// What is kept here is kept from the optimiser, which may otherwise remove a pair of new and
// delete.
void* volatile kept = nullptr;

TEST(AllocationGuard, CountsNothingWhereNothingHappens) {
  AllocationGuard guard;
  double numbers[64] = {};
  kept = numbers;
  EXPECT_EQ(guard.count(), 0);
}

TEST(AllocationGuard, CountsNewAndDelete) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  AllocationGuard guard;
  auto owned = std::make_unique<double>(1.0);
  kept = owned.get();
  EXPECT_EQ(guard.count(), 1);
  owned.reset();
  EXPECT_EQ(guard.count(), 2);
}

TEST(AllocationGuard, CountsNewOfAnOverAlignedType) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  struct alignas(64) Line {
    double numbers[8] = {};
  };
  AllocationGuard guard;
  {
    const auto owned = std::make_unique<Line>();
    kept = owned.get();
  }
  EXPECT_EQ(guard.count(), 2);
}

TEST(AllocationGuard, CountsTheFamilyOfMalloc) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  AllocationGuard guard;
  void* block = std::malloc(16);
  kept = block;
  EXPECT_EQ(guard.count(), 1);
  block = std::realloc(block, 4096);
  kept = block;
  EXPECT_EQ(guard.count(), 2);
  std::free(block);
  EXPECT_EQ(guard.count(), 3);
  block = std::calloc(4, 16);
  kept = block;
  EXPECT_EQ(guard.count(), 4);
  std::free(block);
  EXPECT_EQ(guard.count(), 5);
  ASSERT_EQ(posix_memalign(&block, 64, 128), 0);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % 64, 0U);
  EXPECT_EQ(guard.count(), 6);
  std::free(block);
  std::free(nullptr);
  EXPECT_EQ(guard.count(), 7);
}

TEST(AllocationGuard, CountsTheGrowthOfAVector) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  std::vector<int> numbers;
  numbers.reserve(4);
  AllocationGuard guard;
  for (int i = 0; i < 4; ++i) {
    numbers.push_back(i);
  }
  EXPECT_EQ(guard.count(), 0);
  numbers.push_back(4);  // takes a larger block and gives the old one back
  EXPECT_EQ(guard.count(), 2);
}

TEST(AllocationGuard, GuardsNest) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  AllocationGuard outer;
  kept = std::malloc(1);
  AllocationGuard inner;
  std::free(kept);
  EXPECT_EQ(inner.count(), 1);
  EXPECT_EQ(outer.count(), 2);
}

TEST(AllocationGuard, DoesNotSeeOtherThreads) {
  SKIP_WHERE_SANITIZERS_OWN_THE_HEAP();
  std::int64_t there = 0;
  std::int64_t here = 0;
  {
    std::thread other;
    AllocationGuard guard;
    other = std::thread([&there] {
      AllocationGuard theirs;
      for (int i = 0; i < 1000; ++i) {
        kept = std::malloc(8);
        std::free(kept);
      }
      there = theirs.count();
    });
    other.join();
    here = guard.count();
  }
  EXPECT_EQ(there, 2000);
  EXPECT_LT(here, 100);  // the start of the thread itself
}

}  // namespace
}  // namespace asperity
