// Counts what the current thread does to the heap, to hold real-time code to its promise.

#pragma once

#include <cstdint>

namespace asperity {

/// Counts the allocations and frees of the current thread since its construction:
///
///   AllocationGuard guard;
///   loop.tick(now_ns);
///   EXPECT_EQ(guard.count(), 0);
///
/// Linking the library asperity_test_support puts malloc and its family, in which operator new and
/// delete end, in front of those of the C library (glibc); every call of theirs goes on to it.
/// Freeing a null pointer does not count. Guards may be nested. Other threads are not seen.
///
/// Under the address and thread sanitizers, which need these functions for themselves, the guard
/// counts nothing; `kCounts` says so.
class AllocationGuard final {
 public:
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  static constexpr bool kCounts = false;
#else
  static constexpr bool kCounts = true;
#endif

  AllocationGuard() noexcept;
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  std::int64_t count() const noexcept;

 private:
  std::int64_t at_start_ = 0;
};

}  // namespace asperity
