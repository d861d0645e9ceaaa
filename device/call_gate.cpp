// The door through which a maker's thread comes in to run a tick.

#include "device/call_gate.h"

#include <thread>

namespace asperity {

void CallGate::open(const TickCall& call) noexcept {
  call_ = call;
  state_.store(State::open, std::memory_order_release);
}

bool CallGate::pass() noexcept {
  State seen = State::open;
  if (!state_.compare_exchange_strong(seen, State::passing, std::memory_order_acq_rel))
    return false;
  call_.function(call_.argument);
  seen = State::passing;
  if (!state_.compare_exchange_strong(seen, State::open, std::memory_order_acq_rel)) {
    state_.store(State::closed, std::memory_order_release);
  }
  return true;
}

bool CallGate::close(std::chrono::milliseconds patience) noexcept {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    State seen = State::open;
    if (state_.compare_exchange_strong(seen, State::closed, std::memory_order_acq_rel) ||
        seen == State::closed) {
      return true;
    }
    if (seen == State::passing) {
      state_.compare_exchange_strong(seen, State::closing, std::memory_order_acq_rel);
    }
    if (std::chrono::steady_clock::now() >= until) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

}  // namespace asperity
