// A servo loop that a busy machine may starve.

#pragma once

#include "renderers/servo/servo_loop.h"

namespace asperity {

/// However often and however long this machine keeps the loop's thread or the test's from running, that is not what is
/// tested: neither late ticks nor a standstill nor a silent conductor is a fault.
inline ServoSettings patient_servo() {
  return {.heartbeat_timeout_s = 1e6, .misses_to_fault = 1'000'000, .standstill_to_fault_s = 1e6};
}

}  // namespace asperity
