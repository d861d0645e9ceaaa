// The process that acts for one that is dead or stands still.

#include "device/watchdog_process.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// What the other process has to say comes through this pipe.
int to_test = -1;

void tell(WatchdogProcess::Cause cause, const void* about) noexcept {
  constexpr std::array<char, 3> kLetters{'e', 's', 'l'};
  const std::array<char, 2> said{kLetters[static_cast<std::size_t>(cause)],
                                 *static_cast<const char*>(about)};
  [[maybe_unused]] const ssize_t written = write(to_test, said.data(), said.size());
}

/// A process that has a watchdog and then does something.
class Watched final {
 public:
  explicit Watched(const std::function<void()>& act, bool ends_in_order = false) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    process_ = fork();
    if (process_ == 0) {
      // By itself: where a stopped process is in a group that nobody waits for, the kernel hangs up on all of them.
      setsid();
      const rlimit no_core{0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      for (const int number : {SIGSEGV, SIGABRT}) std::signal(number, SIG_DFL);
      close(ends[0]);
      to_test = ends[1];
      const char about = '7';
      {
        const WatchdogProcess watchdog(&tell, &about, to_test);
        act();
        if (!ends_in_order) _exit(9);
      }
      _exit(0);
    }
    close(ends[1]);
    from_test_ = ends[0];
  }
  ~Watched() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    close(from_test_);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

  /// What comes next of what is said; empty when nobody is left who could.
  std::string next() const {
    std::array<char, 2> said{};
    return read(from_test_, said.data(), said.size()) == 2 ? std::string(said.begin(), said.end())
                                                           : std::string();
  }
  void send(int signal) const { kill(process_, signal); }

 private:
  pid_t process_ = -1;
  int from_test_ = -1;
};

TEST(WatchdogProcess, ActsHoweverTheOtherProcessDies) {
  for (const int signal : {SIGKILL, SIGSEGV, SIGABRT, SIGINT}) {
    const Watched watched([signal] { raise(signal); });
    EXPECT_EQ(watched.next(), "e7") << strsignal(signal);
    EXPECT_EQ(watched.next(), "") << "once, and then it is gone";
  }
}

TEST(WatchdogProcess, ActsWhenTheOtherProcessLeavesWithoutAWord) {
  const Watched watched([] {});
  EXPECT_EQ(watched.next(), "e7");
}

TEST(WatchdogProcess, ActsWhileTheOtherProcessStandsStill) {
  const Watched watched([] {
    raise(SIGSTOP);
    pause();
  });
  EXPECT_EQ(watched.next(), "s7");
  watched.send(SIGKILL);
  std::string last = watched.next();
  while (last == "s7") last = watched.next();
  EXPECT_EQ(last, "e7");
}

TEST(WatchdogProcess, SaysNothingOfAnEndInOrder) {
  const Watched watched([] {}, true);
  EXPECT_EQ(watched.next(), "");
}

TEST(WatchdogProcess, ActsWhenItIsLeftTheLastWord) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  to_test = ends[1];
  {
    WatchdogProcess watchdog(&tell, "7", to_test);
    watchdog.leave_to_act();
  }
  close(ends[1]);
  std::array<char, 3> said{};
  EXPECT_EQ(read(ends[0], said.data(), said.size()), 2)
      << "it has acted before the destructor returns";
  EXPECT_EQ(said[0], 'l');
  close(ends[0]);
}

TEST(WatchdogProcess, HoldsUpNobodyWhereItDoesNotEnd) {
  WatchdogProcess watchdog([](WatchdogProcess::Cause, const void*) noexcept { pause(); }, nullptr,
                           -1);
  watchdog.leave_to_act();
}

// As one that was killed for want of memory: the program that it watched goes on, and can see it.
TEST(WatchdogProcess, IsKnownToBeDeadAndMayBeBeforeItIsDestroyed) {
  const pid_t program = fork();
  if (program == 0) {
    {
      const WatchdogProcess watchdog(&tell, "7", -1);
      if (!watchdog.is_there()) _exit(2);
      std::ifstream children("/proc/self/task/" + std::to_string(getpid()) + "/children");
      pid_t child = 0;
      if (!(children >> child) || kill(child, SIGKILL) != 0) _exit(1);
      siginfo_t dead{};
      waitid(P_PID, static_cast<id_t>(child), &dead, WEXITED | WNOWAIT);
      if (watchdog.is_there()) _exit(3);
    }
    _exit(7);
  }
  int status = 0;
  waitpid(program, &status, 0);
  ASSERT_TRUE(WIFEXITED(status)) << "killed by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(WatchdogProcess, IsNotReachedByTheKeysOfATerminal) {
  // What a terminal sends goes to the whole group of processes.
  const Watched watched([] {
    std::signal(SIGINT, SIG_IGN);
    kill(0, SIGINT);
    kill(0, SIGTERM);
  });
  EXPECT_EQ(watched.next(), "e7");
}

TEST(WatchdogProcess, KeepsNoFileOpenButTheOneThatItNeeds) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const int kept = dup(STDERR_FILENO);
  {
    const WatchdogProcess watchdog(&tell, "7", kept);
    close(ends[1]);
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1),
              0);  // the end of the pipe: nobody has the other side any more
  }
  close(ends[0]);
  close(kept);
}

}  // namespace
}  // namespace asperity
