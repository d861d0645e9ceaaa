// The door through which a maker's thread comes in to run a tick.

#include "device/call_gate.h"

#include <chrono>
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

void CallGate::close() noexcept {
  for (;;) {
    State seen = State::open;
    if (state_.compare_exchange_strong(seen, State::closed, std::memory_order_acq_rel) ||
        seen == State::closed) {
      return;
    }
    if (seen == State::passing) {
      state_.compare_exchange_strong(seen, State::closing, std::memory_order_acq_rel);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
}

}  // namespace asperity
