// Inside the baking: the same work on many items, on several threads.

#pragma once

#include <cstddef>
#include <functional>

namespace asperity {

/// How many threads, and who wants to know how far it is.
struct Workers {
  unsigned jobs = 1;
  std::function<void(double)> progress{};  ///< told fractions, from the calling thread
};

/// Calls work(begin, end) for pieces of [0, count) on `jobs` threads, the caller's among them. What
/// comes out must not depend on which thread does which piece: each item has its own place for its
/// result. The first exception is thrown again here, after all threads have ended.
void side_by_side(std::size_t count, const Workers& workers,
                  const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace asperity
