// Work in bands on several threads: every index once, and exceptions after the end of all.

#include "stimuli/pictures/bands.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(Bands, MeetEveryIndexOnceHoweverManyThereAre) {
  for (const std::size_t count : {0U, 1U, 2U, 7U, 100U}) {
    for (const int threads : {1, 2, 3, 8, 200}) {
      std::vector<std::atomic<int>> met(count);
      in_bands(count, threads, [&met](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++met[i];
      });
      for (const std::atomic<int>& times : met) EXPECT_EQ(times, 1) << count << ' ' << threads;
    }
  }
}

TEST(Bands, EndBeforeTheExceptionOfOneOfThemIsPassedOn) {
  for (const std::size_t failing : {0U, 3U}) {
    std::atomic<int> ended{0};
    const auto use = [&](std::size_t first, std::size_t) {
      if (first == failing) throw std::runtime_error("a full memory");
      ++ended;
    };
    EXPECT_THROW(in_bands(4, 4, use), std::runtime_error);
    EXPECT_EQ(ended, 3);
  }
}

}  // namespace
}  // namespace asperity
