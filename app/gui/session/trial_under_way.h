// The trial of a session that is under way or comes next.

#pragma once

#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"

namespace asperity {

bool is_in_trial(const SessionSnapshot& snapshot) noexcept;

/// The planned trial of that number; null before there is a plan. `facts` may be null.
const Trial* trial_now(const SessionSnapshot& snapshot, const SessionFacts* facts);

/// The number of the trial under way; between trials, that of the next one, unless the experimenter
/// has requested another. 0: none. `facts` may be null.
int trial_to_come(const SessionSnapshot& snapshot, const SessionFacts* facts,
                  const SessionRequests::Pending& pending);

}  // namespace asperity
