// Counts what the current thread does to the heap, to hold real-time code to its promise.

#pragma once

#include <cstdint>

#include "renderers/conformance/heap_calls.h"

namespace asperity {

/// Counts the allocations and frees of the current thread since its construction:
///
///   AllocationGuard guard;
///   loop.tick(now_ns);
///   EXPECT_EQ(guard.count(), 0);
///
/// It counts what heap_calls counts: freeing a null pointer does not count, and other threads are not seen. Guards may be
/// nested. Under the address and thread sanitizers the guard counts nothing; `kCounts` says so.
class AllocationGuard final {
 public:
  static constexpr bool kCounts = kCountsHeapCalls;

  AllocationGuard() noexcept;
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  std::int64_t count() const noexcept;

 private:
  std::int64_t at_start_ = 0;
};

}  // namespace asperity
