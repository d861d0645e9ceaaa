// The positions of two surfaces in a trial, for the kinds that compare them.

#pragma once

#include "protocols/kinds/experiment_kind.h"

namespace asperity {

/// Whether the surfaces of the main block change their positions: otherwise an order effect is taken for a difference.
void check_positions(const BlockOfKind& checked, ProblemSink& problems);

}  // namespace asperity
