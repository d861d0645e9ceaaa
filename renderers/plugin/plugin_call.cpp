// Keeps the running call per thread, and prints it in handlers of the signals that end a program.

#include "renderers/plugin/plugin_call.h"

#include <array>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <mutex>
#include <unistd.h>
#include <vector>

namespace asperity {
namespace {

struct RunningCall {
  const char* plugin = nullptr;  ///< null where the thread runs no code of a plug-in
  PluginFunction function{};
};
// Constant-initialised and in the executable's own block: a signal handler may read it.
constinit thread_local RunningCall running_call{};

// Null in a process that is not watched. Set before there are calls.
constinit PluginCallBoard* board = nullptr;
// The present or the last place of the thread on the board.
constinit thread_local std::size_t place_on_board = 0;

struct EndingSignal {
  int number = 0;
  const char* meaning = nullptr;
};
constexpr std::array kEnding{EndingSignal{SIGSEGV, "an invalid memory access (SIGSEGV)"},
                             EndingSignal{SIGBUS, "an invalid memory access (SIGBUS)"},
                             EndingSignal{SIGFPE, "an integer division by zero (SIGFPE)"},
                             EndingSignal{SIGILL, "an invalid instruction (SIGILL)"},
                             EndingSignal{SIGABRT, "a call of abort (SIGABRT)"}};

/// What each signal did before.
constinit std::array<struct sigaction, kEnding.size()> former_actions{};

void write_text(const char* text) noexcept {
  std::size_t left = std::strlen(text);
  while (left > 0) {
    const ssize_t written = write(STDERR_FILENO, text, left);
    if (written <= 0) return;
    text += written;
    left -= static_cast<std::size_t>(written);
  }
}

// Async-signal-safe functions only.
extern "C" void name_plugin(int number) {
  for (std::size_t i = 0; i < kEnding.size(); ++i) {
    if (kEnding[i].number != number) continue;
    if (board != nullptr) {
      const bool is_called = running_call.plugin != nullptr;
      board->note_signal(is_called ? place_on_board : PluginCallBoard::kNone, number);
    } else if (running_call.plugin != nullptr) {
      write_text("asperity: the plug-in ");
      write_text(running_call.plugin);
      write_text(" ended the program with ");
      write_text(kEnding[i].meaning);
      write_text(" in ");
      write_text(text_of(running_call.function));
      write_text("; ");
      write_text(kCorrectPlugin);
      write_text("\n");
    }
    sigaction(number, &former_actions[i], nullptr);
  }
  // Sent again on the return from this handler, to the former action.
  raise(number);
}

/// A stack for the handler of a thread, whose own one may be used up by an endless recursion. Leaves one that exists.
class SignalStack final {
 public:
  SignalStack() {
    stack_t present{};
    if (sigaltstack(nullptr, &present) == 0 && (present.ss_flags & SS_DISABLE) == 0) return;
    constexpr std::size_t kSize_bytes = std::size_t{1} << 16;
    memory_.resize(kSize_bytes);
    stack_t stack{};
    stack.ss_sp = memory_.data();
    stack.ss_size = memory_.size();
    sigaltstack(&stack, nullptr);
  }
  ~SignalStack() {
    if (memory_.empty()) return;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
  }
  SignalStack(const SignalStack&) = delete;
  SignalStack& operator=(const SignalStack&) = delete;

 private:
  std::vector<std::byte> memory_{};
};

}  // namespace

PluginCall::PluginCall(const char* name, PluginFunction function) noexcept
    : outer_name_(running_call.plugin), outer_function_(running_call.function) {
  running_call = {name, function};
  if (board == nullptr) return;
  if (outer_name_ == nullptr) {
    place_on_board = board->begin(place_on_board, name, function);
  } else if (place_on_board != PluginCallBoard::kNone) {
    board->change(place_on_board, name, function);
  }
}

PluginCall::~PluginCall() {
  running_call = {outer_name_, outer_function_};
  if (board == nullptr || place_on_board == PluginCallBoard::kNone) return;
  if (outer_name_ == nullptr) {
    board->end(place_on_board);
  } else {
    board->change(place_on_board, outer_name_, outer_function_);
  }
}

void show_plugin_calls_on(PluginCallBoard& shared) noexcept { board = &shared; }

const char* meaning_of_ending_signal(int number) noexcept {
  for (const EndingSignal& each : kEnding) {
    if (each.number == number) return each.meaning;
  }
  return nullptr;
}

void name_plugins_that_end_the_program() {
  static const thread_local SignalStack of_this_thread{};
  static std::once_flag installed{};
  std::call_once(installed, [] {
    for (std::size_t i = 0; i < kEnding.size(); ++i) {
      struct sigaction action {};
      action.sa_handler = name_plugin;
      action.sa_flags = SA_ONSTACK;
      sigemptyset(&action.sa_mask);
      sigaction(kEnding[i].number, &action, &former_actions[i]);
    }
  });
}

}  // namespace asperity
