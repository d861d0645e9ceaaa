// What paces the servo loop in real time.

#pragma once

#include <memory>
#include <string>

#include "device/monotonic_clock.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

/// How the thread asked to be scheduled, and what it got.
enum class Scheduling { normal, fifo, fifo_if_permitted };

/// Calls ServoLoop::tick at absolute deadlines of the monotonic clock (monotonic_clock.h) until it is destroyed.
///
/// After an overrun it goes on at the next period on the original grid; it never bursts. Memory is
/// locked and the stack touched where permitted.
///
/// A device with Pacing::theirs is not paced: its own thread runs the tick, and how that thread is
/// scheduled is its own affair. Each tick is due one period after the last began. A watch in a thread of
/// its own raises `device_lost` when no call has begun for ServoSettings::silence_to_fault_s, and
/// again after somebody cleared the fault for as long as the silence lasts. Zero force is then sent with the
/// first call that comes; until then only the device itself can let go.
///
/// Errors: the constructor throws std::runtime_error when `fifo` is demanded and refused, naming
/// the limit to raise, or is demanded of a device's own thread; and as HapticDevice::start_calls.
///
/// Threads: owns one. The destructor stops it, waits for it, and leaves the device at zero force. It
/// does not wait for a device's own thread that is stuck.
class ServoThread final {
 public:
  ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// "SCHED_FIFO 80, memory locked" or "called by the thread of openhaptics, memory locked", for the
  /// session's row.
  const std::string& scheduling() const noexcept { return scheduling_; }

 private:
  struct Pacer;
  struct Called;
  void start_pacing(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);
  void start_being_called(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);

  std::unique_ptr<Pacer> pacer_;    // one of the two
  std::unique_ptr<Called> called_;  // for Pacing::theirs
  bool locked_memory_ = false;
  std::string scheduling_{};
};

}  // namespace asperity
