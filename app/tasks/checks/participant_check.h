// Checks whether this participant can start or resume a session.

#pragma once

#include "app/tasks/checks/session_check.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Refuses an invalid label, a participant in another session, of the other kind (human or virtual) or withdrawn, a
/// session to resume that does not exist, and a new one that the plan does not permit.
SessionCheck participant_check(const CheckInputs& inputs, const Protocol& protocol);

}  // namespace asperity
