// What a running session says on standard error.

#pragma once

#include "app/conductor/conductor.h"

namespace asperity {

/// `done PARTICIPANT SESSION TRIAL ATTEMPT`, once the attempt is on disk. Threads: any.
void say_done(const AttemptDone& done);

}  // namespace asperity
