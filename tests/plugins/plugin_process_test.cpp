// The process in which plug-ins are called: whatever ends it or holds it up is named, and nothing else changes.

#include "app/plugins/plugin_process.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderers/plugin/plugin_call.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kRidges = "ridges (ridges.so)";

struct WatchedWork {
  int status = -1;
  std::vector<std::string> told{};
};

WatchedWork watched(const std::function<int()>& work, const PluginCallLimits& limits = {}) {
  WatchedWork result{};
  result.status = in_plugin_process(
      {.plugins = {"/somewhere/ridges.so"},
       .work = work,
       .report = [&result](const std::string& message) { result.told.push_back(message); },
       .limits = limits});
  return result;
}

void wait_for_ever() {
  for (;;) pause();
}

TEST(PluginProcess, HasTheStatusOfItsWork) {
  for (const int status : {0, 1, 2}) {
    const WatchedWork done = watched([status] {
      const PluginCall call(kRidges, PluginFunction::tick);
      return status;
    });
    EXPECT_EQ(done.status, status);
    EXPECT_THAT(done.told, testing::IsEmpty());
  }
}

TEST(PluginProcess, ChangesNothingOfTheOtherProcess) {
  int changed = 0;
  EXPECT_EQ(watched([&] { return changed = 1; }).status, 1);
  EXPECT_EQ(changed, 0);
}

TEST(PluginProcess, NamesThePluginThatEndsItWithAnExitStatus) {
  const WatchedWork with_exit = watched([]() -> int {
    const PluginCall call(kRidges, PluginFunction::tick);
    std::exit(0);
  });
  EXPECT_EQ(with_exit.status, 1);
  EXPECT_THAT(with_exit.told,
              testing::ElementsAre(StartsWith("asperity: the plug-in ridges (ridges.so) ended the "
                                              "program with exit status 0 in its function tick; "
                                              "correct the plug-in")));
  const WatchedWork at_once = watched([]() -> int {
    const PluginCall call("ridges.so", PluginFunction::initialisation);
    _exit(3);
  });
  EXPECT_EQ(at_once.status, 1);
  EXPECT_THAT(at_once.told,
              testing::ElementsAre(StartsWith("asperity: the plug-in ridges.so ended the program "
                                              "with exit status 3 in its initialisation;")));
}

TEST(PluginProcess, NamesThePluginThatCrashesIt) {
  const WatchedWork crashed = watched([]() -> int {
    const PluginCall call(kRidges, PluginFunction::create);
    std::raise(SIGSTKFLT);
    return 0;
  });
  EXPECT_EQ(crashed.status, 1);
  EXPECT_THAT(crashed.told, testing::ElementsAre(AllOf(HasSubstr("with signal 16 ("),
                                                       HasSubstr(" in its function create;"))));
}

TEST(PluginProcess, DoesNotBlameThePluginThatRunsWhenItIsKilled) {
  const WatchedWork killed = watched([]() -> int {
    const PluginCall call(kRidges, PluginFunction::create);
    std::raise(SIGKILL);
    return 0;
  });
  EXPECT_EQ(killed.status, 1);
  EXPECT_THAT(killed.told,
              testing::ElementsAre(StartsWith(
                  "asperity: the program was killed, by the user or because memory ran out, while "
                  "the plug-in ridges (ridges.so) ran its function create; make sure")));
}

TEST(PluginProcess, NamesOnlyTheCallThatRaisedTheSignal) {
  const WatchedWork aborted = watched([]() -> int {
    name_plugins_that_end_the_program();
    std::atomic<bool> is_running{false};
    const std::jthread other([&is_running] {
      const PluginCall call("waves (waves.so)", PluginFunction::reset);
      is_running = true;
      wait_for_ever();
    });
    while (!is_running) std::this_thread::yield();
    const PluginCall call(kRidges, PluginFunction::tick);
    std::abort();
  });
  EXPECT_EQ(aborted.status, 1);
  EXPECT_THAT(aborted.told,
              testing::ElementsAre(StartsWith("asperity: the plug-in ridges (ridges.so) ended the "
                                              "program with a call of abort (SIGABRT) in its "
                                              "function tick;")));
}

TEST(PluginProcess, StatesTheLoadedPluginsWhereNoneIsKnown) {
  const WatchedWork ended = watched([]() -> int {
    { const PluginCall call(kRidges, PluginFunction::tick); }
    _exit(0);
  });
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.told,
              testing::ElementsAre(HasSubstr("the program ended with exit status 0 outside of the "
                                             "functions of its plug-ins (ridges.so); ")));
}

TEST(PluginProcess, EndsACallThatDoesNotReturn) {
  const WatchedWork ended = watched(
      []() -> int {
        const PluginCall outer(kRidges, PluginFunction::create);
        const PluginCall call(kRidges, PluginFunction::tick);
        wait_for_ever();
        return 0;
      },
      {.real_time_s = 0.3, .preparing_s = 60.0});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.told,
              testing::ElementsAre(StartsWith(
                  "asperity: the plug-in ridges (ridges.so) did not return from its function tick "
                  "within 0.3 s, the limit of a call, and the command was ended; correct")));
}

// A process that has stopped does not return either.
TEST(PluginProcess, EndsACallThatStopsTheProcess) {
  const WatchedWork ended = watched(
      []() -> int {
        const PluginCall call(kRidges, PluginFunction::tick);
        std::raise(SIGSTOP);
        return 0;
      },
      {.real_time_s = 0.3, .preparing_s = 60.0});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.told, testing::ElementsAre(HasSubstr("did not return from its function tick")));
}

TEST(PluginProcess, GivesEachCallItsOwnTime) {
  constexpr PluginCallLimits kLimits{.real_time_s = 1.0, .preparing_s = 1.0};
  const WatchedWork done = watched(
      [] {
        const PluginCall outer(kRidges, PluginFunction::description);
        for (int i = 0; i < 30; ++i) {
          const PluginCall call(kRidges, PluginFunction::tick);
          std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        return 0;
      },
      kLimits);
  EXPECT_EQ(done.status, 0);
  EXPECT_THAT(done.told, testing::IsEmpty());
}

TEST(PluginProcess, EndsAPluginThatDoesNotLetItEnd) {
  const WatchedWork ended = watched(
      [] {
        std::atexit(wait_for_ever);  // as a destructor of a library that is not unloaded
        return 0;
      },
      {.real_time_s = 60.0, .preparing_s = 0.3});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.told, testing::ElementsAre(HasSubstr(
                              "the plug-in ridges.so did not return from its finalisation")));
}

TEST(PluginProcess, DoesNotTakeTheStatusOfAPluginForThatOfItsWork) {
  const WatchedWork ended = watched([] {
    std::atexit([] { _exit(0); });
    return 1;
  });
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.told,
              testing::ElementsAre(HasSubstr("the plug-in ridges.so ended the program with exit "
                                             "status 0 in its finalisation;")));
}

// Its other threads call plug-ins.
TEST(PluginProcess, DoesNotBlameAPluginForASignalOfOtherCode) {
  const WatchedWork aborted = watched([]() -> int {
    name_plugins_that_end_the_program();
    std::atomic<bool> is_running{false};
    const std::jthread other([&is_running] {
      const PluginCall call(kRidges, PluginFunction::tick);
      is_running = true;
      wait_for_ever();
    });
    while (!is_running) std::this_thread::yield();
    std::abort();
  });
  EXPECT_EQ(aborted.status, 1);
  EXPECT_THAT(aborted.told, testing::ElementsAre(HasSubstr(
                                "the program ended with a call of abort (SIGABRT) "
                                "outside of the functions of its plug-ins (ridges.so); ")));
}

TEST(PluginProcess, EndsAsItsChildWithASignalThatItReceived) {
  EXPECT_EXIT((void)watched([]() -> int {
                const PluginCall call(kRidges, PluginFunction::tick);
                kill(getppid(), SIGTERM);
                wait_for_ever();
                return 0;
              }),
              testing::KilledBySignal(SIGTERM), "^$");
}

TEST(PluginProcess, EndsAsItsChildWhoseOutputIsNotRead) {
  EXPECT_EXIT((void)watched([] {
                std::raise(SIGPIPE);
                return 0;
              }),
              testing::KilledBySignal(SIGPIPE), "^$");
  const WatchedWork in_call = watched([] {
    const PluginCall call(kRidges, PluginFunction::tick);
    std::raise(SIGPIPE);
    return 0;
  });
  EXPECT_EQ(in_call.status, 1);
  EXPECT_THAT(in_call.told, testing::ElementsAre(HasSubstr("in its function tick")));
}

}  // namespace
}  // namespace asperity
