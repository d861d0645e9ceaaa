// Whether a protocol that has the right form makes sense.

#pragma once

#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// Everything that no schema can say: references, ranges declared by the models, orders that cannot
/// be met, answers that cannot be right. The protocol was read from the document.
std::vector<Diagnostic> check_meaning(const Protocol& protocol, const JsonDocument& document,
                                      const std::vector<ModelDeclaration>& models);

}  // namespace asperity
