// Restores the echo in handlers of all signals that would end the program.

#include "app/session/respondents/unechoed_input.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
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

/// What each signal did before; written before the handler is installed.
constinit std::array<struct sigaction, kEndingSignals.size()> former_actions{};

extern "C" void restore_echo_and_end(int number) {
  restore_echo();
  for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
    if (kEndingSignals[i] == number) ::sigaction(number, &former_actions[i], nullptr);
  }
  std::raise(number);
}

/// Of an error in the program, after which no handler resumes it: it can be handled in turn.
bool is_of_an_error(int number) {
  return number == SIGABRT || number == SIGBUS || number == SIGFPE || number == SIGILL ||
         number == SIGSEGV;
}

/// Handles the signals that would end the program. Other signals that are handled elsewhere, or ignored, are left
/// unchanged.
void handle_ending_signals() {
  struct sigaction own {};
  own.sa_handler = restore_echo_and_end;
  own.sa_flags = SA_ONSTACK;
  sigemptyset(&own.sa_mask);
  for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
    const int number = kEndingSignals[i];
    struct sigaction now {};
    if (::sigaction(number, nullptr, &now) != 0) continue;
    if (now.sa_handler != SIG_DFL && !is_of_an_error(number)) continue;
    if (now.sa_handler == restore_echo_and_end) continue;
    former_actions[i] = now;
    ::sigaction(number, &own, nullptr);
  }
}

void leave_ending_signals() {
  for (std::size_t i = 0; i < kEndingSignals.size(); ++i) {
    struct sigaction now {};
    if (::sigaction(kEndingSignals[i], nullptr, &now) != 0) continue;
    if (now.sa_handler != restore_echo_and_end) continue;
    ::sigaction(kEndingSignals[i], &former_actions[i], nullptr);
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
  handle_ending_signals();
  ::tcsetattr(input, TCSANOW, &silent);
}

UnechoedInput::~UnechoedInput() {
  restore_echo();
  leave_ending_signals();
}

}  // namespace asperity
