// Declares the thread that paces the servo loop in real time.

#pragma once

#include <memory>
#include <string>

#include "device/monotonic_clock.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

/// The scheduling that is requested for the thread.
enum class Scheduling { normal, fifo, fifo_if_permitted };

/// Calls ServoLoop::tick at absolute deadlines of the monotonic clock (monotonic_clock.h) until it is destroyed.
///
/// After an overrun the thread resumes at the next period of the original grid and never bursts. Memory is locked and
/// the stack is touched where permitted.
///
/// A device with Pacing::theirs is not paced: its own thread runs the tick, and that thread's scheduling is outside the
/// control of this class. Each tick is due one period after the previous one began. A separate watch thread raises
/// `device_lost` if no call has begun for ServoSettings::silence_to_fault_s, and raises it again after each
/// `clear_fault` while the silence lasts. Zero force is then sent with the next call; until then only the device itself
/// can switch its force off.
///
/// Errors: the constructor throws std::runtime_error if `fifo` is demanded and refused, naming the limit to raise, or
/// is demanded of a device's own thread; and in the cases of HapticDevice::start_calls.
///
/// Threads: owns one. The destructor stops it, joins it, and leaves the device at zero force. It does not wait for a
/// device's own thread that does not respond.
class ServoThread final {
 public:
  ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// The obtained scheduling, for the session's row: "SCHED_FIFO 80, memory locked" or "called by the thread of
  /// openhaptics, memory locked".
  const std::string& scheduling() const noexcept { return scheduling_; }

 private:
  struct Pacer;
  struct Called;
  void start_pacing(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);
  void start_being_called(ServoLoop& loop, HapticDevice& device, Scheduling scheduling);

  std::unique_ptr<Pacer> pacer_;    // for a device that is paced
  std::unique_ptr<Called> called_;  // for Pacing::theirs; the other one is null
  bool locked_memory_ = false;
  std::string scheduling_{};
};

}  // namespace asperity
