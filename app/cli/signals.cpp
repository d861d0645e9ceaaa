// Ctrl-C and its like, as a request that the work can hear.

#include "app/cli/signals.h"

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <mutex>
#include <utility>

#include "app/cli/terminal.h"
#include "app/session/respondents/unechoed_input.h"

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{20};
constexpr std::array kInterrupts{SIGINT, SIGTERM, SIGQUIT};

// The only things that a signal handler may touch: it runs on whichever thread, while the watcher reads.
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> interrupts{0};
std::atomic<int> last_interrupt{SIGINT};
std::atomic<int> interrupt_holds{0};

void end_program(int number) noexcept {
  restore_echo();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

extern "C" void note_interrupt(int number) {
  last_interrupt = number;
  if (++interrupts > 2 && interrupt_holds == 0) end_program(number);
}

}  // namespace

InterruptWatch::InterruptWatch(std::string saying, std::function<void()> at_once)
    : saying_(std::move(saying)), at_once_(std::move(at_once)) {
  interrupts = 0;
  for (const int number : kInterrupts) std::signal(number, note_interrupt);
  // A terminal that is closed shows as the end of its input, and the session ends in order.
  std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGTSTP, SIG_IGN);
  watcher_ = std::jthread([this](const std::stop_token& ended) { watch(ended); });
}

void InterruptWatch::will_say(std::string saying) {
  const std::lock_guard lock(mutex_);
  saying_ = std::move(saying);
}

InterruptWatch::Hold::Hold() noexcept { ++interrupt_holds; }
InterruptWatch::Hold::~Hold() { --interrupt_holds; }

void InterruptWatch::ask_to_stop(const char* when) {
  source_.request_stop();
  const std::lock_guard lock(mutex_);
  say(saying_ + when);
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
      if (at_once_) {
        at_once_();
        std::this_thread::sleep_for(kForZero);
      }
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
  for (const int number : kInterrupts) std::signal(number, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
  std::signal(SIGTSTP, SIG_DFL);
}

}  // namespace asperity
