// How long a test waits for what has to happen.

#pragma once

#include <chrono>

namespace asperity {

/// The longest wait for an event. It passes only where a test fails, so it is far beyond what a busy machine
/// takes; a test waits for events with it and never for time.
inline constexpr std::chrono::minutes kPatience{2};
/// The same for Qt.
inline constexpr int kPatience_ms = std::chrono::milliseconds(kPatience).count();

}  // namespace asperity
