// Implements the distribution of work to threads.

#include "stimuli/meshes/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace asperity {

void side_by_side(std::size_t count, const Workers& workers,
                  const std::function<void(std::size_t begin, std::size_t end)>& work) {
  const std::size_t piece = std::clamp<std::size_t>(count / 512, 1, 4096);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure{};
  std::mutex failure_mutex{};
  const auto run = [&](bool tell) {
    for (;;) {
      const std::size_t begin = next.fetch_add(piece);
      if (begin >= count) return;
      try {
        if (tell) workers.progress(static_cast<double>(begin) / static_cast<double>(count));
        work(begin, std::min(count, begin + piece));
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        next.store(count);
      }
    }
  };
  std::vector<std::thread> threads{};
  for (unsigned i = 1; i < workers.jobs; ++i) threads.emplace_back(run, false);
  run(static_cast<bool>(workers.progress));
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace asperity
