#include "app/session/respondents/unechoed_input.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <pthread.h>

#include <termios.h>

namespace asperity {

namespace {

constexpr int kNoTerminal = -1;
// Every standard signal whose default action ends a program (signal(7)), except SIGKILL, which cannot be handled.
constexpr std::array kEndingSignals{SIGABRT, SIGALRM,   SIGBUS,  SIGFPE,  SIGHUP,  SIGILL,
                                    SIGINT,  SIGIO,     SIGPIPE, SIGPROF, SIGPWR,  SIGQUIT,
                                    SIGSEGV, SIGSTKFLT, SIGSYS,  SIGTERM, SIGTRAP, SIGUSR1,
                                    SIGUSR2, SIGVTALRM, SIGXCPU, SIGXFSZ};

// Data that a signal handler may use; `echoing` is written before `silent_terminal` is set, and not
// after.
static_assert(std::atomic<int>::is_always_lock_free);
std::atomic<int> silent_terminal{kNoTerminal};
termios echoing{};

extern "C" void restore_echo_and_end(int number) {
  restore_echo();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

/// Replaces the handlers of the signals that would end the program. Signals that are handled
/// elsewhere, or ignored, are left unchanged.
void handle_ending_signals(void (*from)(int), void (*to)(int)) {
  for (const int number : kEndingSignals) {
    struct sigaction now {};
    if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler == from) std::signal(number, to);
  }
}

}  // namespace

void restore_echo() noexcept {
  const int terminal = silent_terminal.load();
  if (terminal == kNoTerminal) return;
  const int error = errno;
  // In the background either call would stop the program instead of restoring the terminal.
  sigset_t stopping{};
  sigset_t before{};
  sigemptyset(&stopping);
  sigaddset(&stopping, SIGTTOU);
  ::pthread_sigmask(SIG_BLOCK, &stopping, &before);
  // Not TCSAFLUSH, which waits until the terminal has taken all output: a stopped terminal never
  // does.
  ::tcsetattr(terminal, TCSANOW, &echoing);
  ::tcflush(terminal, TCIFLUSH);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  // Last: a handler in another thread that finds no silent terminal ends the program at once.
  // Restoring twice is harmless.
  silent_terminal.store(kNoTerminal);
  errno = error;
}

UnechoedInput::UnechoedInput(int input) {
  if (::tcgetattr(input, &echoing) != 0 || (echoing.c_lflag & ECHO) == 0) return;
  termios silent = echoing;
  silent.c_lflag &= ~static_cast<tcflag_t>(ECHO | ECHONL);
  silent_terminal = input;
  handle_ending_signals(SIG_DFL, restore_echo_and_end);
  ::tcsetattr(input, TCSANOW, &silent);
}

UnechoedInput::~UnechoedInput() {
  restore_echo();
  handle_ending_signals(restore_echo_and_end, SIG_DFL);
}

}  // namespace asperity
