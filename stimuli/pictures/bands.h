// A loop over many rows, shared out among the cores.

#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace asperity {

/// As many threads as the machine runs at once, at most four: beyond that memory is what keeps them
/// waiting.
inline int usual_threads() noexcept {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 4);
}

/// Calls use(first, last) for bands that make up [0, count), each on a thread of its own, one of them
/// the caller's. Returns when all have ended, with the exception of one that threw.
///
/// Which band an index falls into depends on `threads`: what is computed for it must not.
template <class Use>
void in_bands(std::size_t count, int threads, const Use& use) {
  const std::size_t bands = std::clamp<std::size_t>(static_cast<std::size_t>(threads), 1,
                                                    std::max<std::size_t>(1, count));
  const auto begin = [count, bands](std::size_t band) { return band * count / bands; };
  std::vector<std::future<void>> others{};  // wait when they are destroyed
  for (std::size_t band = 1; band < bands; ++band) {
    others.push_back(
        std::async(std::launch::async,
                   [&use, first = begin(band), last = begin(band + 1)] { use(first, last); }));
  }
  use(begin(0), begin(1));
  for (std::future<void>& other : others) other.get();
}

}  // namespace asperity
