// The door through which a maker's thread comes in to run a tick.

#pragma once

#include <atomic>

#include "device/haptic_device.h"

namespace asperity {

/// Lets a thread that is not ours run the tick, one call at a time, until it is closed.
///
/// Two things can be stuck behind it. A tick is this program's own code, and what it works on is freed as soon as
/// the gate is closed: it is waited for, as long as it takes, as for a thread of our own. The maker's code around
/// it may hang for ever, and then comes back to a closed gate: a gate whose thread did not end is left behind, on the
/// heap, for ever.
///
/// Threads: `pass` belongs to the maker's thread; `open` and `close` to the driver's owner.
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
  /// No tick begins any more, and none is under way when it returns.
  void close() noexcept;
  /// Whether a tick is under way; from any thread.
  bool is_passing() const noexcept {
    const State now = state_.load(std::memory_order_acquire);
    return now == State::passing || now == State::closing;
  }

 private:
  enum class State : int { closed, open, passing, closing };
  std::atomic<State> state_{State::closed};
  TickCall call_{};
};

}  // namespace asperity
