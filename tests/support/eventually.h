// Waiting for another thread or process, where there are no Qt events.

#pragma once

#include <chrono>
#include <thread>

#include "tests/support/patience.h"

namespace asperity {

/// Looks again and again until `condition` holds; false where it did not within `kPatience`.
template <typename Condition>
bool eventually(const Condition& condition) {
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace asperity
