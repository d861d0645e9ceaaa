// Declares warnings about rules of a valid protocol that its sessions never reach.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// A warning for every break within a block after more trials or more contact than the block has, and for more practice
/// trials at a resume than any practice has. `example` is an example plan of the protocol. Blocks whose number of trials
/// depends on the responses are not examined.
///
/// `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_plan(const Protocol& protocol, const std::string& file_name,
                                            const Plan& example);

}  // namespace asperity
