// Declares the measurement of how long a tick that does not return exerts its force.

#pragma once

#include <stop_token>

#include "renderers/offline/tick_times.h"

namespace asperity {

/// The times from the call of a renderer that does not return to zero force, set from outside (ServoThread), at 1 kHz with a
/// device that takes forces at once: what the watch adds to the time that a driver needs. As in an endless loop, the
/// renderer keeps its processor busy.
///
/// Each time takes about 0.1 s. `count.counted` and `count.longest` limit their number, and `busy_threads` keep other
/// processors busy meanwhile. The servo thread and its watch are scheduled as in a session.
TickTimes time_hung_ticks(const TickCount& count, unsigned busy_threads,
                          const std::stop_token& stop);

}  // namespace asperity
