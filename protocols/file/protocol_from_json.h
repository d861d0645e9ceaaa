// Declares the conversion of a document that has the form of a protocol to a Protocol.

#pragma once

#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/protocol.h"

namespace asperity {

/// Converts a document that has the form of a protocol, without checking its meaning. `models` declare the units of varied
/// parameters.
Protocol protocol_from_json(const nlohmann::json& root,
                            const std::vector<ModelDeclaration>& models);

/// Completes a block by what its kind, the presented stimuli and its procedure determine. A kind that is not known
/// determines nothing. `stated`: the block of the document; its procedure, if it has one, has the form.
void complete_block(Protocol::Block& block, const nlohmann::json& stated, const Protocol& protocol,
                    const std::vector<ModelDeclaration>& models);

}  // namespace asperity
