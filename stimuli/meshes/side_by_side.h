// Declares parallel loops of the baking: the same work on many items on several threads.

#pragma once

#include <cstddef>
#include <functional>

namespace asperity {

/// The number of threads and the callback for progress.
struct Workers {
  unsigned jobs = 1;
  std::function<void(double)> progress{};  ///< receives fractions, in the calling thread
};

/// Calls work(begin, end) for pieces of [0, count) on `jobs` threads, including the caller's. The result must not
/// depend on which thread processes which piece: each item has a separate memory location for its result. The first
/// exception is rethrown after all threads have ended.
void side_by_side(std::size_t count, const Workers& workers,
                  const std::function<void(std::size_t begin, std::size_t end)>& work);

}  // namespace asperity
