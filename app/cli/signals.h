// Signals: zero force before any of them ends the program; Ctrl-C and its like as a request that the work can hear.

#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace asperity {

/// For the life of the program, in windows and at a terminal:
/// - A write into a pipe without a reader, or beyond the size that files may have, fails with an error and does not end
///   the program (SIGPIPE, SIGXFSZ). Programs that this one starts have the default actions (ChildProcess).
/// - Every other signal that would end the program, in any of its threads, first sets the force of every servo loop to zero
///   (ServoThread::end_all_forces) and, where there is one, waits `InterruptWatch::kForZero`. Not handled are SIGKILL, and
///   the SIGSEGV of a stack that is full: no thread has another stack for the handler.
///
/// Signals that are handled or ignored already are left unchanged.
void handle_signals();

/// While it lives, the first interrupt asks `token()` to stop: SIGINT, SIGTERM and SIGQUIT (Ctrl-C, kill, Ctrl-\), and every
/// other signal whose default action ends a program and that is not raised by an error in it (SIGALRM, SIGUSR1, SIGXCPU, …). The
/// second one ends the program: `at_once` is called, which asks a device for zero force and
/// returns; after `kForZero`, where a servo loop runs, the program is gone, whatever it was doing. A third one waits for zero
/// force only. While there is a `Hold`, both wait for its end.
///
/// Ctrl-Z does nothing meanwhile, and neither does what else stops a program in the background of a terminal: motors keep
/// their last force while a program stands still.
///
/// Threads: owns one, which watches, and calls `at_once`; `will_say` from any. One object at a time.
class InterruptWatch final {
 public:
  static constexpr std::chrono::milliseconds kForZero{100};

  /// While it lives, the program does not die of an interrupt with what must be let go of in order, such as an arm
  /// that moves by itself; whoever holds hears `token()`. The second one waits for the end of the last of them, and
  /// then `kForZero` for the program to end by itself; it ends the program `kLongestHold` after it came at the latest.
  class Hold final {
   public:
    Hold() noexcept;
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;
  };
  static constexpr std::chrono::seconds kLongestHold{3};

  /// `message` is told once, when the first one comes; where the second one comes with it, only where there is a `Hold`.
  explicit InterruptWatch(std::string message, std::function<void()> at_once = {});
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// Instead of what was to be said until now: what a stop does may change as the work goes on.
  void will_say(std::string message);

  std::stop_token token() const noexcept { return source_.get_token(); }

 private:
  void watch(const std::stop_token& ended);
  void ask_to_stop(const char* when);
  bool ends_in_order(const std::stop_token& ended);

  std::mutex mutex_{};
  std::string message_{};  ///< under `mutex_`
  std::function<void()> at_once_{};
  std::stop_source source_{};
  std::vector<std::pair<int, void (*)(int)>> former_handlers_{};
  std::jthread watcher_{};
};

}  // namespace asperity
