// The session's own clock, as a person reads it.

#pragma once

#include <cstdint>

#include <QtCore/QString>

#include "app/session/session_monitor.h"

namespace asperity {

/// The session's time now: in real time it goes on between two words of the conductor, on a
/// simulated clock only with them. `facts` may be null.
std::int64_t now_ns(const SessionSnapshot& snapshot, const SessionFacts* facts);

/// A moment of the session as time of day, "14:35".
QString text_of_clock(std::int64_t time_ns, const SessionSnapshot& snapshot,
                      const SessionFacts* facts);

}  // namespace asperity
