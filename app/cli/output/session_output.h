// What a running session says on standard error.

#pragma once

#include "app/session/conductor.h"

namespace asperity {

/// Once the attempt is on disk: `done PARTICIPANT SESSION TRIAL ATTEMPT` where it counts, and otherwise
/// `stored PARTICIPANT SESSION TRIAL ATTEMPT OUTCOME`. A line that names these columns precedes the first. Threads: any.
void say_done(const AttemptDone& done);

}  // namespace asperity
