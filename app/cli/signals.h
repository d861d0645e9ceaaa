// Ctrl-C, as a request that the work can hear.

#pragma once

#include <stop_token>
#include <string>
#include <thread>

namespace asperity {

/// While it lives, the first interrupt (or termination) asks `token()` to stop; a second one ends
/// the program at once.
///
/// Threads: owns one, which watches. One object at a time.
class InterruptWatch final {
 public:
  /// `saying` is told once, when the first one comes.
  explicit InterruptWatch(std::string saying = "stopping after this trial");
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  std::stop_token token() const noexcept { return source_.get_token(); }

 private:
  std::string saying_{};
  std::stop_source source_{};
  std::jthread watcher_{};
};

}  // namespace asperity
