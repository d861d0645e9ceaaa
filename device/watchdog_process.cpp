// A second process, which sets motors to zero when this one no longer can.

#include "device/watchdog_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sched.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include <poll.h>
#include <time.h>

#include "device/monotonic_clock.h"

namespace asperity {
namespace {

constexpr int kBetweenLooks_ms = 50;
// A library that stands between this process and the system calls may have one of its locks held by another thread when
// the process is forked, which no thread of the fork ever releases. Such a fork never says that it watches.
constexpr std::array kToStart_ms{100, 100, 100, 200, 200, 200, 400, 400, 800, 800, 1600, 1600};
// To act after its last word: more than any driver takes.
constexpr int kToEnd_ms = 5000;
constexpr timespec kBetweenWaits{0, 1'000'000};

// What it says when it watches.
constexpr char kReady = 3;
// What the destructor says.
constexpr char kFarewell = 1;
constexpr char kLastWord = 2;

using StatusPath = std::array<char, 32>;

void close_from_to(unsigned first, unsigned last) noexcept {
  if (close_range(first, last, 0) == 0) return;
  // A kernel or a container that does not have the call: one by one, as far as files can go.
  rlimit most{};
  if (getrlimit(RLIMIT_NOFILE, &most) != 0) return;
  for (rlim_t file = first; file <= last && file < most.rlim_cur; ++file) {
    close(static_cast<int>(file));
  }
}

// All but the two, of which one may be −1.
void close_others(int one, int other) noexcept {
  const auto [low, high] = std::minmax(one, other);
  unsigned first = 0;
  for (const int kept : {low, high}) {
    if (kept < 0) continue;
    if (static_cast<unsigned>(kept) > first) close_from_to(first, static_cast<unsigned>(kept) - 1);
    first = static_cast<unsigned>(kept) + 1;
  }
  close_from_to(first, std::numeric_limits<unsigned>::max());
}

// Whether no thread of the process gets on: it is stopped, traced at a stop, or its core is written.
bool stands_still(const StatusPath& status) noexcept {
  const int file = open(status.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  std::array<char, 8192> text{};
  const ssize_t length = read(file, text.data(), text.size());
  close(file);
  if (length <= 0) return false;
  const auto says = [&](const char* line) {
    return memmem(text.data(), static_cast<std::size_t>(length), line, std::strlen(line)) !=
           nullptr;
  };
  return says("\nState:\tT") || says("\nState:\tt") || says("\nCoreDumping:\t1");
}

[[noreturn]] void watch(int leash, const StatusPath& status, WatchdogProcess::Act act,
                        const void* about) noexcept {
  // Opens and closes a file, as what follows does.
  stands_still(status);
  if (send(leash, &kReady, 1, MSG_NOSIGNAL) != 1) _exit(1);
  for (;;) {
    pollfd end{leash, POLLIN, 0};
    const int ready = poll(&end, 1, kBetweenLooks_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready == 0) {
      if (stands_still(status)) act(WatchdogProcess::Cause::stopped, about);
      continue;
    }
    char said = 0;
    if (read(leash, &said, 1) != 1) {
      act(WatchdogProcess::Cause::ended, about);
    } else if (said == kLastWord) {
      act(WatchdogProcess::Cause::left, about);
    }
    _exit(0);
  }
}

[[noreturn]] void refuse_to_start(const char* what, int error) {
  throw std::runtime_error(
      std::string(
          "the process that sets the force to zero if this program crashes cannot be started (") +
      what + ": " + std::generic_category().message(error) +
      "); close other programs, then try again");
}

}  // namespace

WatchdogProcess::WatchdogProcess(Act act, const void* about, int keep_open) {
  // A busy machine may keep every try from its cores as long.
  for (const int limit_ms : kToStart_ms) {
    start(act, about, keep_open);
    if (says_that_it_watches(limit_ms)) return;
    close(leash_);
    end_by_force();
  }
  refuse_to_start("it does not answer", ETIMEDOUT);
}

void WatchdogProcess::start(Act act, const void* about, int keep_open) {
  std::array<int, 2> ends{};
  // Sockets, and no pipe: writing to a watchdog that is dead is an error then, and no SIGPIPE.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    refuse_to_start("socketpair", errno);
  }
  StatusPath status{};
  std::snprintf(status.data(), status.size(), "/proc/%d/status", static_cast<int>(getpid()));
  // No handler of this process may run in the other one, not even before it has closed its files.
  sigset_t all{};
  sigset_t before{};
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  // Not fork(), which runs what every library of this process wants done in a child, with its locks.
  process_ = _Fork();
  const int error = errno;
  if (process_ == 0) {
    const sched_param none{};
    sched_setscheduler(0, SCHED_OTHER, &none);
    setsid();
    prctl(PR_SET_NAME, "watchdog");
    close(ends[1]);  // whatever else fails: with it open the end of the other would not be seen
    close_others(ends[0], keep_open);
    watch(ends[0], status, act, about);
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  close(ends[0]);
  leash_ = ends[1];
  if (process_ < 0) {
    close(leash_);
    refuse_to_start("fork", error);
  }
}

bool WatchdogProcess::says_that_it_watches(int limit_ms) const noexcept {
  pollfd word{leash_, POLLIN, 0};
  const std::int64_t until_ns = monotonic_now_ns() + std::int64_t{limit_ms} * 1'000'000;
  int ready = 0;
  do {  // again where a signal came
    const std::int64_t left_ms = (until_ns - monotonic_now_ns()) / 1'000'000;
    ready = poll(&word, 1, static_cast<int>(std::max<std::int64_t>(left_ms, 0)));
  } while (ready < 0 && errno == EINTR);
  char said = 0;
  return ready == 1 && read(leash_, &said, 1) == 1 && said == kReady;
}

void WatchdogProcess::end_by_force() const noexcept {
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool WatchdogProcess::is_there() const noexcept {
  // Nobody but it has the other end, so that its end is the end of the line.
  pollfd end{leash_, 0, 0};
  return poll(&end, 1, 0) <= 0;
}

WatchdogProcess::~WatchdogProcess() {
  const char word = is_left_to_act_ ? kLastWord : kFarewell;
  // It only fails when the other process is gone already.
  [[maybe_unused]] const ssize_t written = send(leash_, &word, 1, MSG_NOSIGNAL);
  close(leash_);
  for (int waited_ms = 0; waited_ms < kToEnd_ms; ++waited_ms) {
    if (waitpid(process_, nullptr, WNOHANG) != 0) return;
    nanosleep(&kBetweenWaits, nullptr);
  }
  end_by_force();
}

}  // namespace asperity
