// Forks, passes signals on to the child, and names the plug-in whose call ended it or does not return.

#include "app/plugins/plugin_process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iostream>
#include <map>
#include <optional>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

#include "analysis/numbers/number_text.h"
#include "renderers/plugin/plugin_call.h"

namespace asperity {
namespace {

constexpr int kNotAcceptable = 1;
constexpr long kBetweenLooks_ns = 50'000'000;
// A longer time between two looks is one in which this process did not run.
constexpr double kLongestLook_s = 0.2;

// What a terminal or another process asks of a program. SIGCONT continues the child with the whole group.
constexpr std::array kPassedOn{SIGHUP,  SIGINT,  SIGQUIT, SIGTERM, SIGALRM,
                               SIGUSR1, SIGUSR2, SIGTSTP, SIGCONT};

// What the terminal sends to each process of the group.
constexpr std::array kOfTerminal{SIGHUP, SIGINT, SIGQUIT, SIGTSTP, SIGCONT};

// How the system ends a program whose output is not read, or that writes too large a file.
constexpr std::array kOfWrites{SIGPIPE, SIGXFSZ};

bool contains(const auto& numbers, int number) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

/// Blocks these signals and SIGCHLD in this thread, which then takes them one by one.
class TakenSignals final {
 public:
  TakenSignals() {
    sigemptyset(&taken_);
    for (const int number : kPassedOn) sigaddset(&taken_, number);
    sigaddset(&taken_, SIGCHLD);
    sigprocmask(SIG_BLOCK, &taken_, &before_);
  }
  ~TakenSignals() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  TakenSignals(const TakenSignals&) = delete;
  TakenSignals& operator=(const TakenSignals&) = delete;

  /// The next signal, after at most this time.
  std::optional<siginfo_t> next(long longest_wait_ns) const noexcept {
    siginfo_t info{};
    const timespec wait{.tv_sec = 0, .tv_nsec = longest_wait_ns};
    if (sigtimedwait(&taken_, &info, &wait) < 0) return {};
    return info;
  }
  void restore_in_child() const noexcept { sigprocmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t taken_{};
  sigset_t before_{};
};

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text{};
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string names_of(const std::vector<std::filesystem::path>& plugins) {
  std::vector<std::string> names{};
  for (const std::filesystem::path& file : plugins) names.push_back(file.filename().string());
  return joined(names, ", ");
}

[[noreturn]] void work_in_child(const PluginProcessInputs& inputs, PluginCallBoard& board,
                                const TakenSignals& signals, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kNotAcceptable);  // it was killed before
  show_plugin_calls_on(board);
  signals.restore_in_child();
  const int status = inputs.work();
  std::cout.flush();
  std::fflush(nullptr);
  board.finish(status);
  // What is left is the end of the program: destructors, also those of libraries that stay loaded until then.
  static const std::string names = names_of(inputs.plugins);
  const PluginCall call(names.c_str(), PluginFunction::finalisation);
  std::exit(status);
}

/// The calls that last longer than they may.
class CallTimes final {
 public:
  explicit CallTimes(const PluginCallLimits& limits) : limits_(limits) {}

  double limit_s(PluginFunction function) const noexcept {
    const bool is_real_time = function == PluginFunction::reset || function == PluginFunction::tick;
    return is_real_time ? limits_.real_time_s : limits_.preparing_s;
  }

  /// `passed_s`: since the last time.
  std::vector<PluginCallBoard::Call> overdue(const std::vector<PluginCallBoard::Call>& running,
                                             double passed_s) {
    std::map<std::size_t, Since> still{};
    std::vector<PluginCallBoard::Call> found{};
    for (const PluginCallBoard::Call& call : running) {
      const auto before = since_.find(call.place);
      const bool is_same = before != since_.end() && before->second.number == call.number;
      const double lasts_s = is_same ? before->second.lasts_s + passed_s : 0.0;
      still[call.place] = {call.number, lasts_s};
      if (lasts_s > limit_s(call.function)) found.push_back(call);
    }
    since_ = std::move(still);
    return found;
  }

 private:
  struct Since {
    std::uint64_t number = 0;
    double lasts_s = 0.0;
  };
  PluginCallLimits limits_{};
  std::map<std::size_t, Since> since_{};  ///< of each place
};

/// "the plug-in ridges (ridges.so)" and "its function tick", with "or" between several.
struct CalledCode {
  std::string plugins{};
  std::string functions{};
};
CalledCode code_of(const std::vector<PluginCallBoard::Call>& calls) {
  std::vector<std::string> plugins{};
  std::vector<std::string> functions{};
  const auto add = [](std::vector<std::string>& words, const std::string& word) {
    if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  };
  for (const PluginCallBoard::Call& call : calls) {
    add(plugins, "the plug-in " + call.name);
    add(functions, text_of(call.function));
  }
  return {joined(plugins, " or "), joined(functions, " or ")};
}

/// "exit status 0", "an invalid memory access (SIGSEGV)". `noted`: the signal that the call raised, after which a handler may
/// have ended the process with a status.
std::string text_of_ending(int status, const std::optional<PluginCallBoard::Signal>& noted) {
  if (!noted && WIFEXITED(status)) return "exit status " + std::to_string(WEXITSTATUS(status));
  const int number = noted ? noted->number : WTERMSIG(status);
  if (const char* const meaning = meaning_of_ending_signal(number)) return meaning;
  return "signal " + std::to_string(number) + " (" + strsignal(number) + ')';
}

std::string text_of_kill(const PluginCallBoard& board) {
  const CalledCode code = code_of(board.running());
  return "asperity: the program was killed, by the user or because memory ran out" +
         (code.plugins.empty() ? std::string()
                               : ", while " + code.plugins + " ran " + code.functions) +
         "; make sure that enough memory is free, then try again";
}

/// Why the child ended although its work was not done.
std::string text_of_early_end(const PluginCallBoard& board,
                              const std::vector<std::filesystem::path>& plugins, int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return text_of_kill(board);
  const std::optional<PluginCallBoard::Signal> noted = board.signal();
  std::vector<PluginCallBoard::Call> calls = board.running();
  if (noted) {
    std::erase_if(
        calls, [&noted](const PluginCallBoard::Call& call) { return call.place != noted->place; });
  }
  const std::string ending = text_of_ending(status, noted);
  if (calls.empty()) {
    return "asperity: the program ended with " + ending +
           " outside of the functions of its plug-ins (" + names_of(plugins) +
           "); a thread or a signal handler of a plug-in can be the cause, or memory that one has "
           "damaged; " +
           kCorrectPlugin;
  }
  const CalledCode code = code_of(calls);
  return "asperity: " + code.plugins + " ended the program with " + ending + " in " +
         code.functions + "; " + kCorrectPlugin;
}

class WatchedChild final {
 public:
  WatchedChild(pid_t process, const PluginProcessInputs& inputs, const PluginCallBoard& board,
               const TakenSignals& signals)
      : process_(process),
        inputs_(inputs),
        board_(board),
        signals_(signals),
        times_(inputs.limits) {}

  /// The exit status, once it has ended.
  int watch() {
    using Clock = std::chrono::steady_clock;
    Clock::time_point last = Clock::now();
    for (;;) {
      pass_on_signals(kBetweenLooks_ns);
      int status = 0;
      const pid_t changed = waitpid(process_, &status, WNOHANG | WUNTRACED);
      if (changed == process_ && WIFSTOPPED(status)) {
        stop_with_child(WSTOPSIG(status));
      } else if (changed == process_) {
        return result_of(status);
      }
      const Clock::time_point now = Clock::now();
      const double passed_s = std::chrono::duration<double>(now - last).count();
      last = now;
      const auto overdue = times_.overdue(board_.running(), std::min(passed_s, kLongestLook_s));
      if (!overdue.empty()) return end(overdue);
    }
  }

 private:
  void pass_on_signals(long longest_wait_ns) {
    for (std::optional<siginfo_t> taken = signals_.next(longest_wait_ns); taken;
         taken = signals_.next(0)) {
      if (taken->si_signo == SIGCHLD) continue;
      received_.push_back(taken->si_signo);
      // Of the terminal's the child has its own; the kernel's others, as that of alarm(), are for this process alone.
      const bool is_of_terminal = taken->si_code > 0 && contains(kOfTerminal, taken->si_signo);
      if (!is_of_terminal) kill(process_, taken->si_signo);
    }
  }

  /// As the terminal has stopped it. A plug-in that stops its process is one that does not return.
  static void stop_with_child(int number) {
    if (number == SIGTSTP || number == SIGTTIN || number == SIGTTOU) raise(SIGSTOP);
  }

  /// Whether the signal would have ended the program without a plug-in as well.
  bool is_without_plugin(int number) const {
    // The limit of processor time is that of the program.
    return number == SIGXCPU || contains(received_, number) ||
           (contains(kOfWrites, number) && board_.running().empty());
  }

  int result_of(int status) {
    if (WIFEXITED(status) && board_.finished_with() == WEXITSTATUS(status)) {
      return WEXITSTATUS(status);
    }
    pass_on_signals(0);
    if (WIFSIGNALED(status) && is_without_plugin(WTERMSIG(status))) end_with(WTERMSIG(status));
    inputs_.report(text_of_early_end(board_, inputs_.plugins, status));
    return kNotAcceptable;
  }

  /// So that a shell sees what it would have seen of the program.
  static void end_with(int number) {
    std::signal(number, SIG_DFL);
    sigset_t one{};
    sigemptyset(&one);
    sigaddset(&one, number);
    raise(number);
    sigprocmask(SIG_UNBLOCK, &one, nullptr);
  }

  int end(const std::vector<PluginCallBoard::Call>& overdue) {
    kill(process_, SIGKILL);
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    const CalledCode code = code_of(overdue);
    const double limit_s = times_.limit_s(overdue.front().function);
    inputs_.report("asperity: " + code.plugins + " did not return from " + code.functions +
                   " within " + number_text(limit_s) +
                   " s, the limit of a call, and the command was ended; " + kCorrectPlugin);
    return kNotAcceptable;
  }

  pid_t process_ = -1;
  const PluginProcessInputs& inputs_;
  const PluginCallBoard& board_;
  const TakenSignals& signals_;
  CallTimes times_;
  std::vector<int> received_{};
};

}  // namespace

int in_plugin_process(const PluginProcessInputs& inputs) {
  PluginCallBoard board;
  // Both processes have what is not written yet.
  std::cout.flush();
  std::fflush(nullptr);
  // Where it is ignored, no status of a child is kept.
  std::signal(SIGCHLD, SIG_DFL);
  const TakenSignals signals;
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    throw std::system_error(errno, std::generic_category(),
                            "no process can be started that calls the plug-ins; close other "
                            "programs, then try again");
  }
  if (process == 0) work_in_child(inputs, board, signals, parent);
  return WatchedChild(process, inputs, board, signals).watch();
}

}  // namespace asperity
