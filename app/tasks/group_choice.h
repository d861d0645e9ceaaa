// Whether the group that an experimenter states for a new session is acceptable.

#pragma once

#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// The problem of the stated group; nothing when it is acceptable. `before`: the group of the
/// participant's earlier sessions of the protocol, which may be stated again or left out.
std::optional<Phrase> complaint_about_group(const Protocol& protocol,
                                            const std::optional<std::string>& before,
                                            const std::optional<std::string>& stated);

}  // namespace asperity
