// A process that is killed while it stores attempts, again and again.

#include <array>
#include <csignal>
#include <filesystem>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr int kKills = 200;
constexpr int kMostAttempts = 20;  ///< before a kill; on a busy machine it may come late

/// Adds attempts from `first` on and reports each once it is acknowledged, until killed.
[[noreturn]] void add_attempts_until_killed(const std::filesystem::path& folder, int first,
                                            int report) {
  Study study = Study::open(folder, Access::read_write);
  for (int trial = first; trial < first + kMostAttempts; ++trial) {
    study.add_attempt(1, some_attempt(trial));
    if (::write(report, &trial, sizeof trial) != sizeof trial) ::_exit(1);
  }
  for (;;) ::pause();
}

// Kills come after a random number of acknowledgements and a random fraction of the time that the
// next one takes, so that they fall anywhere into a transaction.
TEST(KilledStudy, HoldsEveryAcknowledgedAttempt) {
  const TemporaryFolder folder;
  { study_with_session(folder / "s", kKills * kMostAttempts); }
  std::mt19937 random(7);
  int acknowledged = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const int first = acknowledged + 1;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) add_attempts_until_killed(folder / "s", first, pipe[1]);
    ::close(pipe[1]);
    const auto wanted = static_cast<int>(random() % 8);
    int trial = 0;
    for (int i = 0; i <= wanted; ++i) {
      ASSERT_EQ(::read(pipe[0], &trial, sizeof trial), static_cast<ssize_t>(sizeof trial));
      acknowledged = trial;
    }
    for (auto spin = random() % 300'000; spin > 0; --spin) {
      asm volatile("");
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(pipe[0], &trial, sizeof trial) == static_cast<ssize_t>(sizeof trial)) {
      acknowledged = trial;
    }
    ::close(pipe[0]);

    const Study study = Study::open(folder / "s", Access::read_only);
    const std::vector<AttemptRow> attempts = study.attempts(1);
    ASSERT_GE(attempts.size(), static_cast<std::size_t>(acknowledged));
    // At most the one that was committed but not yet reported.
    ASSERT_LE(attempts.size(), static_cast<std::size_t>(acknowledged + 1));
    ASSERT_THAT(attempts, testing::Each(testing::Field(&AttemptRow::events, testing::SizeIs(2))));
    acknowledged = static_cast<int>(attempts.size());
  }
  EXPECT_THAT(Study::open(folder / "s", Access::read_write).verify({}), testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
