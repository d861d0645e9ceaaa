// Signals: zero force before any of them ends the program; Ctrl-C and its like as a request that the work can hear.

#include "app/cli/signals.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <mutex>
#include <utility>

#include <time.h>

#include "app/cli/output/terminal.h"
#include "app/session/respondents/unechoed_input.h"
#include "renderers/servo/servo_thread.h"

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};

// Every signal whose default action ends a program is in one of these lists or a real-time signal, except SIGKILL.
constexpr std::array kInterrupts{SIGINT,  SIGTERM, SIGQUIT, SIGALRM, SIGVTALRM, SIGPROF,
                                 SIGUSR1, SIGUSR2, SIGIO,   SIGPWR,  SIGSTKFLT, SIGXCPU};
constexpr std::array kErrors{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};
constexpr std::array kOfWrites{SIGPIPE, SIGXFSZ};
// A terminal that is closed shows as the end of its input, and the session ends in order; the others stop a program.
constexpr std::array kIgnoredBySessions{SIGHUP, SIGTSTP, SIGTTIN, SIGTTOU};

template <typename Act>
void for_each_interrupt(const Act& act) {
  for (const int number : kInterrupts) act(number);
  for (int number = SIGRTMIN; number <= SIGRTMAX; ++number) act(number);
}

// The only things that a signal handler may touch: it runs on whichever thread, while the watcher reads.
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> interrupts{0};
std::atomic<int> last_interrupt{SIGINT};
std::atomic<int> interrupt_holds{0};

// Async-signal-safe functions only, from here on.

// Returns once the motors have had time to receive zero.
void end_forces() noexcept {
  if (!ServoThread::end_all_forces()) return;
  timespec left{.tv_sec = 0, .tv_nsec = std::chrono::nanoseconds(InterruptWatch::kForZero).count()};
  while (::nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
}

extern "C" void end_program(int number) {
  restore_echo();
  end_forces();
  // Sent again on the return from a handler of this signal.
  std::signal(number, SIG_DFL);
  std::raise(number);
}

extern "C" void note_interrupt(int number) {
  last_interrupt = number;
  if (++interrupts > 2 && interrupt_holds == 0) end_program(number);
}

}  // namespace

void handle_signals() {
  for (const int number : kOfWrites) std::signal(number, SIG_IGN);
  struct sigaction ending {};
  ending.sa_handler = end_program;
  ending.sa_flags = SA_ONSTACK;
  sigemptyset(&ending.sa_mask);
  const auto handle = [&ending](int number) {
    struct sigaction now {};
    const bool is_handled_elsewhere =
        ::sigaction(number, nullptr, &now) != 0 || now.sa_handler != SIG_DFL;
    if (!is_handled_elsewhere) ::sigaction(number, &ending, nullptr);
  };
  for_each_interrupt(handle);
  for (const int number : kErrors) handle(number);
  handle(SIGHUP);
}

InterruptWatch::InterruptWatch(std::string message, std::function<void()> at_once)
    : message_(std::move(message)), at_once_(std::move(at_once)) {
  interrupts = 0;
  const auto handle = [this](int number, void (*handler)(int)) {
    former_handlers_.emplace_back(number, std::signal(number, handler));
  };
  for_each_interrupt([&handle](int number) { handle(number, note_interrupt); });
  for (const int number : kIgnoredBySessions) handle(number, SIG_IGN);
  watcher_ = std::jthread([this](const std::stop_token& ended) { watch(ended); });
}

void InterruptWatch::will_say(std::string message) {
  const std::lock_guard lock(mutex_);
  message_ = std::move(message);
}

InterruptWatch::Hold::Hold() noexcept { ++interrupt_holds; }
InterruptWatch::Hold::~Hold() { --interrupt_holds; }

void InterruptWatch::ask_to_stop(const char* when) {
  source_.request_stop();
  const std::lock_guard lock(mutex_);
  say(message_ + when);
}

// Whether what is held, and the program with it, comes to its end in the time that it is given.
bool InterruptWatch::ends_in_order(const std::stop_token& ended) {
  if (interrupt_holds == 0) return false;
  // Where both came at once, nobody has yet.
  if (!source_.stop_requested()) ask_to_stop(" (within three seconds)");
  const auto latest = std::chrono::steady_clock::now() + kLongestHold;
  while (interrupt_holds > 0 && std::chrono::steady_clock::now() < latest) {
    std::this_thread::sleep_for(kBetweenLooks);
  }
  if (interrupt_holds == 0) std::this_thread::sleep_for(kForZero);
  return ended.stop_requested();
}

void InterruptWatch::watch(const std::stop_token& ended) {
  while (!ended.stop_requested()) {
    if (interrupts > 1) {
      if (at_once_) at_once_();
      if (ends_in_order(ended)) return;
      end_program(last_interrupt);
    }
    if (interrupts > 0 && !source_.stop_requested()) {
      ask_to_stop(interrupt_holds > 0 ? " (press Ctrl-C again to end within three seconds)"
                                      : " (press Ctrl-C again to end at once)");
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

InterruptWatch::~InterruptWatch() {
  watcher_.request_stop();
  for (const auto& [number, handler] : former_handlers_) std::signal(number, handler);
}

}  // namespace asperity
