// Declares a loop over rows that is divided among the processor cores.

#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace asperity {

/// The number of hardware threads, at most four: beyond four the loops are limited by memory bandwidth.
inline int usual_threads() noexcept {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
}

/// Calls use(first, last) for contiguous bands that make up [0, count), each in a separate thread, one of them the
/// caller's. Returns when all have ended; an exception of a band is rethrown.
///
/// The band of an index depends on `threads`; the result for the index must not.
template <class Use>
void in_bands(std::size_t count, int threads, const Use& use) {
  const std::size_t bands = std::clamp<std::size_t>(static_cast<std::size_t>(threads), 1,
                                                    std::max<std::size_t>(1, count));
  const auto begin = [count, bands](std::size_t band) { return band * count / bands; };
  std::vector<std::future<void>> others{};  // their destructors wait
  for (std::size_t band = 1; band < bands; ++band) {
    others.push_back(
        std::async(std::launch::async,
                   [&use, first = begin(band), last = begin(band + 1)] { use(first, last); }));
  }
  use(begin(0), begin(1));
  for (std::future<void>& other : others) other.get();
}

}  // namespace asperity
