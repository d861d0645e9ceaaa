// Declares a limit for calls into the drivers of devices.

#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace asperity {

/// Ends the program where a call into a driver does not return: the software of a manufacturer can hang, and then no other
/// call into it can be relied on. The device, the call and the remedy are stated on standard error; the status is 1, and the
/// program is left by _Exit. What another process sends to the device of a program that was killed, it sends then, too.
///
/// Threads: owns one; the others belong to one.
class CallLimit final {
 public:
  /// `device` is the name of the device in the sentence.
  explicit CallLimit(std::string device);
  ~CallLimit() = default;
  CallLimit(const CallLimit&) = delete;
  CallLimit& operator=(const CallLimit&) = delete;

  /// From now on a call runs that may take so long. `call` completes the sentence "the driver has not returned from …".
  void begin(std::string call, std::chrono::seconds limit);
  /// The call has returned, or waits for a person.
  void end();

 private:
  struct Call {
    std::string name{};
    std::chrono::seconds limit{};
    std::chrono::steady_clock::time_point latest{};
  };
  void watch(const std::stop_token& ended);

  std::string device_;
  std::mutex mutex_{};
  std::condition_variable_any changed_{};
  std::optional<Call> call_{};  ///< under `mutex_`
  std::jthread watcher_;        // last: it uses the others
};

}  // namespace asperity
