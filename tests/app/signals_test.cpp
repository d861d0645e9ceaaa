// Ctrl-C, once, twice and three times.

#include "app/cli/signals.h"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>

namespace asperity {
namespace {

struct Ended {
  std::string said{};  ///< one letter for each thing that happened
  int status = 0;      ///< as waitpid tells
};

/// What a program does that is sent these signals; after each it waits for the letter that it causes.
template <typename Act>
Ended program(const Act& act) {
  std::array<int, 2> ends{};
  EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const pid_t process = fork();
  if (process == 0) {
    close(STDERR_FILENO);
    act([to_test = ends[1]](char letter) {
      [[maybe_unused]] const ssize_t written = write(to_test, &letter, 1);
    });
    _exit(7);
  }
  close(ends[1]);
  Ended ended{};
  for (char letter = 0; read(ends[0], &letter, 1) == 1;) ended.said += letter;
  waitpid(process, &ended.status, 0);
  close(ends[0]);
  return ended;
}

void wait_for(const std::stop_token& token) {
  while (!token.stop_requested()) std::this_thread::yield();
}

TEST(InterruptWatch, AsksTheWorkToStopAtTheFirst) {
  const Ended ended = program([](const auto& tell) {
    const InterruptWatch watch("stopping", [&] { tell('z'); });
    raise(SIGINT);
    wait_for(watch.token());
    tell('s');
  });
  EXPECT_EQ(ended.said, "s");
  EXPECT_TRUE(WIFEXITED(ended.status));
}

TEST(InterruptWatch, AsksForZeroForceBeforeTheSecondEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Ended ended = program([signal](const auto& tell) {
      const InterruptWatch watch("stopping", [&] { tell('z'); });
      raise(signal);
      wait_for(watch.token());
      tell('s');
      raise(signal);
      for (;;) pause();
    });
    EXPECT_EQ(ended.said, "sz");
    ASSERT_TRUE(WIFSIGNALED(ended.status));
    EXPECT_EQ(WTERMSIG(ended.status), signal);
  }
}

TEST(InterruptWatch, WaitsForNobodyAtTheThird) {
  const Ended ended = program([](const auto& tell) {
    const InterruptWatch watch("stopping", [&] {
      tell('z');
      for (;;) pause();  // a device whose driver hangs
    });
    raise(SIGINT);
    raise(SIGINT);
    raise(SIGINT);
    tell('n');
  });
  EXPECT_EQ(ended.said.find('n'), std::string::npos);
  ASSERT_TRUE(WIFSIGNALED(ended.status));
  EXPECT_EQ(WTERMSIG(ended.status), SIGINT);
}

// As of an arm that moves by itself: it is stopped, and whoever presses again and again waits for that.
TEST(InterruptWatch, LeavesWhatIsHeldToItsEndHoweverManyCome) {
  const Ended ended = program([](const auto& tell) {
    InterruptWatch watch("stopping", [&] { tell('z'); });
    {
      const InterruptWatch::Hold until_it_stands_still;
      for (int i = 0; i < 3; ++i) raise(SIGINT);
      wait_for(watch.token());
      raise(SIGINT);
      std::this_thread::sleep_for(std::chrono::milliseconds(400));
      tell('h');
    }
  });
  EXPECT_EQ(ended.said, "zh");
  ASSERT_TRUE(WIFEXITED(ended.status)) << "the program came to its end by itself";
  EXPECT_EQ(WEXITSTATUS(ended.status), 7);
}

TEST(InterruptWatch, EndsAProgramThatDoesNotLetGoOfWhatItHolds) {
  const Ended ended = program([](const auto& tell) {
    InterruptWatch watch("stopping");
    const InterruptWatch::Hold for_ever;
    raise(SIGTERM);
    wait_for(watch.token());
    tell('s');
    raise(SIGTERM);
    for (;;) pause();
  });
  EXPECT_EQ(ended.said, "s");
  ASSERT_TRUE(WIFSIGNALED(ended.status));
  EXPECT_EQ(WTERMSIG(ended.status), SIGTERM);
}

TEST(InterruptWatch, IsNotPutToSleepByTheTerminal) {
  const Ended ended = program([](const auto& tell) {
    const InterruptWatch watch("stopping");
    raise(SIGTSTP);
    tell('w');
  });
  EXPECT_EQ(ended.said, "w");
}

}  // namespace
}  // namespace asperity
