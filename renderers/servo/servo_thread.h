// Declares the thread that paces the servo loop in real time.

#pragma once

#include <memory>
#include <string>
#include <thread>

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
/// control of this class. Each tick is due one period after the previous one began.
///
/// A separate thread watches the ticks (tick_watch.h), with a higher priority than the servo thread where permitted. Where a
/// tick does not return, it raises `standstill`, and from 5 ms later on sets the force to zero from outside
/// (HapticDevice::zero_force_from_outside) every 5 ms until a tick returns. Where a device with its own pacing makes no call,
/// it raises `device_lost` in the same way. Both are raised again after each `clear_fault` while the cause lasts.
///
/// Errors: the constructor throws std::runtime_error if `fifo` is demanded and refused, naming the limit to raise, or
/// is demanded of a device's own thread; and in the cases of HapticDevice::start_calls.
///
/// Threads: owns two. The destructor stops them, joins them, and leaves the device at zero force. It does not wait for a
/// device's own thread that does not respond. With `kept` it waits for a tick for one second only (TickWatch::kWithoutSurface
/// times ServoSettings::standstill_to_fault_s): a tick that does not return is left behind, with the watch, which still sets
/// the force to zero, and ends the thread and releases `kept` if the tick returns after all. A watch to which the driver does
/// not return is left behind after the same time, and releases `kept` once it returns. Without `kept` it waits until they
/// return.
class ServoThread final {
 public:
  /// `kept` owns the loop, the device, and everything that they use; null: they outlive this object.
  ServoThread(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
              std::shared_ptr<void> kept = {});
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// The obtained scheduling, for the session's row: "SCHED_FIFO 80, memory locked" or "called by the thread of
  /// openhaptics, memory locked".
  const std::string& scheduling() const noexcept { return scheduling_; }

  /// Raises `emergency_stop` in every servo thread of the process, now and in future, and sets its force to zero, within a
  /// tick, or three looks of the watch where no tick ends: the program is about to end. Returns whether there is one. Async-signal-safe.
  static bool end_all_forces() noexcept;

 private:
  struct Ticks;
  struct Pacer;
  struct Called;
  void start_pacing(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
                    std::shared_ptr<void> kept);
  void start_being_called(ServoLoop& loop, HapticDevice& device, Scheduling scheduling,
                          std::shared_ptr<void> kept);

  std::shared_ptr<Ticks> ticks_;  // shared with the watch
  std::thread watch_{};
  bool locked_memory_ = false;
  std::string scheduling_{};
};

}  // namespace asperity
