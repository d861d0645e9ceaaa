#include "app/cli/signals.h"

#include <chrono>
#include <csignal>
#include <utility>

#include "app/cli/terminal.h"

namespace asperity {

namespace {

// The only thing that a signal handler may touch.
volatile std::sig_atomic_t interrupts = 0;

extern "C" void note_interrupt(int number) {
  interrupts = interrupts + 1;
  if (interrupts > 1) {
    std::signal(number, SIG_DFL);
    std::raise(number);
  }
}

}  // namespace

InterruptWatch::InterruptWatch(std::string saying) : saying_(std::move(saying)) {
  interrupts = 0;
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  // A terminal that is closed shows as the end of its input, and the session ends in order.
  std::signal(SIGHUP, SIG_IGN);
  watcher_ = std::jthread([this](const std::stop_token& ended) {
    while (!ended.stop_requested()) {
      if (interrupts > 0) {
        say(saying_ + " (once more to end at once)");
        source_.request_stop();
        return;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  });
}

InterruptWatch::~InterruptWatch() {
  watcher_.request_stop();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGHUP, SIG_DFL);
}

}  // namespace asperity
