// The quantity on the scale of a similarity.

#pragma once

#include "protocols/design/protocol.h"

namespace asperity {

/// What the scale of its question increases with; dissimilarity where the question does not state it.
RatedQuantity rated_quantity(const Protocol::TrialQuestionTemplate& question);

}  // namespace asperity
