// Ctrl-C, as a request that the work can hear.

#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

namespace asperity {

/// While it lives, the first interrupt (or termination) asks `token()` to stop. The second one ends the
/// program: `at_once` is called, which asks a device for zero force and returns; after `kForZero` the
/// program is gone, whatever it was doing. A third one does not wait even for that.
///
/// Ctrl-Z does nothing meanwhile: motors keep their last force while a program stands still.
///
/// Threads: owns one, which watches, and calls `at_once`; `will_say` from any. One object at a time.
class InterruptWatch final {
 public:
  static constexpr std::chrono::milliseconds kForZero{100};

  /// `saying` is told once, when the first one comes.
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

  std::mutex mutex_{};
  std::string saying_{};  ///< under `mutex_`
  std::function<void()> at_once_{};
  std::stop_source source_{};
  std::jthread watcher_{};
};

}  // namespace asperity
