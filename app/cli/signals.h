// Ctrl-C, as a request that the work can hear.

#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace asperity {

/// While it lives, the first interrupt (SIGINT, SIGTERM or SIGQUIT: Ctrl-C, kill, Ctrl-\) asks `token()`
/// to stop. The second one ends the program: `at_once` is called, which asks a device for zero force and
/// returns; after `kForZero` the program is gone, whatever it was doing. A third one does not wait even
/// for that. While there is a `Hold`, both wait for its end.
///
/// Ctrl-Z does nothing meanwhile: motors keep their last force while a program stands still.
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

  /// `saying` is told once, when the first one comes; where the second one comes with it, only where there is a `Hold`.
  explicit InterruptWatch(std::string saying = "stopping after this trial",
                          std::function<void()> at_once = {});
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// Instead of what was to be said until now: what a stop does may change as the work goes on.
  void will_say(std::string saying);

  std::stop_token token() const noexcept { return source_.get_token(); }

 private:
  void watch(const std::stop_token& ended);
  void ask_to_stop(const char* when);
  bool ends_in_order(const std::stop_token& ended);

  std::mutex mutex_{};
  std::string saying_{};  ///< under `mutex_`
  std::function<void()> at_once_{};
  std::stop_source source_{};
  std::jthread watcher_{};
};

}  // namespace asperity
