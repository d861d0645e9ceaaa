// Ctrl-C, once, twice and three times.

#include "app/cli/signals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include <gtest/gtest.h>

#include "renderers/servo/servo_thread.h"
#include "tests/support/patient_servo.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

struct Ended {
  std::string said{};    ///< one letter for each thing that happened
  std::string errors{};  ///< what it wrote there
  int status = 0;        ///< as waitpid tells
  std::chrono::steady_clock::duration took{};
};

std::string read_to_end(int descriptor) {
  std::string text;
  for (char letter = 0; read(descriptor, &letter, 1) == 1;) text += letter;
  close(descriptor);
  return text;
}

/// What a program does that is sent these signals; after each it waits for the letter that it causes.
template <typename Act>
Ended program(const Act& act) {
  std::array<int, 2> ends{};
  std::array<int, 2> errors{};
  EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  EXPECT_EQ(pipe2(errors.data(), O_CLOEXEC), 0);
  const auto begun = std::chrono::steady_clock::now();
  const pid_t process = fork();
  if (process == 0) {
    const rlimit no_core{};  // of SIGQUIT
    setrlimit(RLIMIT_CORE, &no_core);
    dup2(errors[1], STDERR_FILENO);
    act([to_test = ends[1]](char letter) {
      [[maybe_unused]] const ssize_t written = write(to_test, &letter, 1);
    });
    _exit(7);
  }
  close(ends[1]);
  close(errors[1]);
  Ended ended{};
  ended.said = read_to_end(ends[0]);
  ended.errors = read_to_end(errors[0]);  // a few lines, which the pipe holds meanwhile
  waitpid(process, &ended.status, 0);
  ended.took = std::chrono::steady_clock::now() - begun;
  return ended;
}

/// As `program`, again where nothing was said: a busy machine may keep every thread from its cores for the 0.1 s that a
/// program waits for zero force before it ends.
template <typename Act>
Ended program_given_cores(const Act& act) {
  constexpr int kTries = 3;
  Ended ended = program(act);
  for (int more = 1; more < kTries && ended.said.empty(); ++more) ended = program(act);
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
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) {
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

// What a time limit, a batch system or another program may send.
TEST(InterruptWatch, AsksTheWorkToStopAtAnyOtherSignalThatWouldEndTheProgram) {
  for (const int signal : {SIGALRM, SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2, SIGIO, SIGPWR, SIGSTKFLT,
                           SIGXCPU, SIGRTMIN, SIGRTMAX}) {
    const Ended ended = program([signal](const auto& tell) {
      const InterruptWatch watch("stopping", [&] { tell('z'); });
      raise(signal);
      wait_for(watch.token());
      tell('s');
    });
    EXPECT_EQ(ended.said, "s") << signal;
    EXPECT_TRUE(WIFEXITED(ended.status)) << signal;
  }
}

/// A servo loop that pushes. `at_zero` is called once it has pushed and then no longer does.
class PushingLoop final {
 public:
  explicit PushingLoop(const std::function<void()>& at_zero, std::function<void()> at_tick = {}) {
    device_.at_send = [this, at_zero](const Wrench& wrench) {
      if (wrench.force_N.z > 0.0) {
        pushes_ = true;
      } else if (pushes_.exchange(false)) {
        at_zero();
      }
    };
    device_.at_zero_from_outside = [this, at_zero] {
      if (pushes_.exchange(false)) at_zero();
    };
    loop_.present({.id = 1, .renderer = std::make_unique<Push>(std::move(at_tick), pushes_)});
    thread_.emplace(loop_, device_, Scheduling::normal);
    while (!pushes_) std::this_thread::yield();
  }

 private:
  class Push final : public ForceRenderer {
   public:
    Push(std::function<void()> at_tick, const std::atomic<bool>& pushes)
        : at_tick_(std::move(at_tick)), pushes_(pushes) {}
    void reset(const ProbeState&) noexcept override {}
    RenderedTick tick(const ProbeState&, double) noexcept override {
      if (at_tick_ && pushes_) at_tick_();
      return {.wrench = {.force_N = {0.0, 0.0, 1.0}}};
    }

   private:
    std::function<void()> at_tick_;
    const std::atomic<bool>& pushes_;
  };

  std::atomic<bool> pushes_{false};
  ScriptedDevice device_{};
  RecordRing ring_{};
  ServoLoop loop_{device_, ring_, patient_servo()};
  std::optional<ServoThread> thread_{};
};

constexpr std::array kEndings{SIGHUP,    SIGINT,    SIGQUIT, SIGTERM, SIGALRM, SIGUSR1, SIGUSR2,
                              SIGXCPU,   SIGVTALRM, SIGPROF, SIGIO,   SIGPWR,  SIGSYS,  SIGTRAP,
                              SIGSTKFLT, SIGSEGV,   SIGBUS,  SIGFPE,  SIGILL,  SIGABRT};

TEST(Signals, EndTheProgramWithZeroForce) {
  for (const int signal : kEndings) {
    const Ended ended = program_given_cores([signal](const auto& tell) {
      std::signal(signal, SIG_DFL);  // not that of a sanitizer
      handle_signals();
      const PushingLoop loop([&] { tell('z'); });
      raise(signal);
      tell('n');
    });
    EXPECT_EQ(ended.said, "z") << signal;
    ASSERT_TRUE(WIFSIGNALED(ended.status)) << signal;
    EXPECT_EQ(WTERMSIG(ended.status), signal);
  }
}

// The thread that would send zero is the one that does not come back from the error.
TEST(Signals, EndTheProgramWithZeroForceWhereTheServoThreadCausesThem) {
  const Ended ended = program_given_cores([](const auto& tell) {
    std::signal(SIGABRT, SIG_DFL);
    handle_signals();
    const PushingLoop loop([&] { tell('z'); }, [] { raise(SIGABRT); });
    for (;;) pause();
  });
  EXPECT_EQ(ended.said, "z");
  ASSERT_TRUE(WIFSIGNALED(ended.status));
  EXPECT_EQ(WTERMSIG(ended.status), SIGABRT);
}

TEST(Signals, OfAFailedWriteAreErrorsAndEndNoProgram) {
  const Ended ended = program([](const auto& tell) {
    for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_DFL);
    handle_signals();
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return;
    close(pipe_ends[0]);
    if (write(pipe_ends[1], "a", 1) < 0 && errno == EPIPE) tell('p');
    const rlimit no_bytes{0, 0};
    setrlimit(RLIMIT_FSIZE, &no_bytes);
    const int file = open(testing::TempDir().c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (write(file, "a", 1) < 0 && errno == EFBIG) tell('f');
  });
  EXPECT_EQ(ended.said, "pf");
  EXPECT_TRUE(WIFEXITED(ended.status));
}

TEST(Signals, AreHandledAgainOnceTheWorkIsOver) {
  const Ended ended = program([](const auto& tell) {
    handle_signals();
    { const InterruptWatch watch("stopping"); }
    const PushingLoop loop([&] { tell('z'); });
    raise(SIGTERM);
  });
  EXPECT_EQ(ended.said, "z");
  ASSERT_TRUE(WIFSIGNALED(ended.status));
  EXPECT_EQ(WTERMSIG(ended.status), SIGTERM);
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

// Two that come between two looks of the watch.
TEST(InterruptWatch, SaysWhatItWaitsForThoughTwoCameAtOnce) {
  const Ended ended = program([](const auto& tell) {
    InterruptWatch watch("stopping the arm");
    {
      const InterruptWatch::Hold until_it_stands_still;
      raise(SIGINT);
      raise(SIGINT);
      wait_for(watch.token());
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      tell('h');
    }
  });
  EXPECT_EQ(ended.said, "h");
  const std::size_t at = ended.errors.find("stopping the arm (");
  ASSERT_NE(at, std::string::npos) << ended.errors;
  EXPECT_NE(ended.errors.find("within three seconds"), std::string::npos) << ended.errors;
  EXPECT_EQ(ended.errors.find("stopping the arm", at + 1), std::string::npos) << ended.errors;
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
  EXPECT_GE(ended.took, InterruptWatch::kLongestHold) << "what is held was not waited for";
}

TEST(InterruptWatch, IsNotPutToSleepByTheTerminal) {
  const Ended ended = program([](const auto& tell) {
    const InterruptWatch watch("stopping");
    for (const int signal : {SIGTSTP, SIGTTIN, SIGTTOU, SIGHUP}) raise(signal);
    tell('w');
  });
  EXPECT_EQ(ended.said, "w");
}

}  // namespace
}  // namespace asperity
