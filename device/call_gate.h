// The door through which a maker's thread comes in to run a tick.

#pragma once

#include <atomic>
#include <chrono>

#include "device/haptic_device.h"

namespace asperity {

/// Lets a thread that is not ours run the tick, one call at a time, until it is closed.
///
/// Threads: `pass` belongs to the maker's thread; `open` and `close` to the driver's owner. A gate has
/// to outlive that thread's last `pass`: a driver whose thread did not come to an end leaves its closed
/// gate behind, on the heap, for ever.
///
/// Real-time: `pass` does not allocate, lock or throw.
class CallGate final {
 public:
  CallGate() = default;
  CallGate(const CallGate&) = delete;
  CallGate& operator=(const CallGate&) = delete;

  /// While it is closed only.
  void open(const TickCall& call) noexcept;
  /// Runs the tick; false, at once, when the gate is closed.
  bool pass() noexcept;
  /// No tick begins any more. Waits up to `patience` for the one under way; false when that is still
  /// running then.
  bool close(std::chrono::milliseconds patience) noexcept;

 private:
  enum class State : int { closed, open, passing, closing };
  std::atomic<State> state_{State::closed};
  TickCall call_{};
};

}  // namespace asperity
