// What paces the servo loop in real time.

#pragma once

#include <memory>
#include <string>

#include "renderers/servo_loop.h"

namespace asperity {

/// How the thread asked to be scheduled, and what it got.
enum class Scheduling { normal, fifo, fifo_if_permitted };

/// Calls ServoLoop::tick at absolute deadlines of a monotonic clock until it is destroyed.
///
/// After an overrun it goes on at the next period on the original grid; it never bursts. Memory is
/// locked and the stack touched where permitted.
///
/// Errors: the constructor throws std::runtime_error when `fifo` is demanded and refused, naming
/// the limit to raise.
///
/// Threads: owns one. The destructor stops it, waits for it, and leaves the device at zero force.
class ServoThread final {
 public:
  ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// "SCHED_FIFO 80, memory locked", for the session's row.
  const std::string& scheduling() const noexcept { return scheduling_; }

 private:
  struct Pacer;
  std::unique_ptr<Pacer> pacer_;
  std::string scheduling_{};
};

/// Nanoseconds of the monotonic clock that ServoThread paces by.
std::int64_t monotonic_now_ns() noexcept;

}  // namespace asperity
