// Checks the files that a protocol uses.

#pragma once

#include "app/tasks/checks/session_check.h"
#include "protocols/design/protocol.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// Refuses missing and changed files, and in a session that is resumed files other than those with which it began. Warns of
/// attempts with another build of a plug-in (plugin_warnings.h).
SessionCheck stimuli_check(const CheckInputs& inputs, const Protocol& protocol,
                           const ModelRegistry& models);

}  // namespace asperity
