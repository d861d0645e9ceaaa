// Declares the check of the meaning of a protocol that follows the schema.

#pragma once

#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// Checks what the schema cannot express: references, ranges declared by the models, orders that cannot be met, correct
/// responses that are impossible. `protocol` was read from `document`.
std::vector<Diagnostic> check_meaning(const Protocol& protocol, const JsonDocument& document,
                                      const std::vector<ModelDeclaration>& models);

}  // namespace asperity
