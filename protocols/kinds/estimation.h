// The checks of the key "estimation": the factors, the predictor and the modulus of magnitude estimates.

#pragma once

#include "protocols/design/problem_sink.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// Whether the estimates of a protocol can be analysed as it states (EstimationDeclaration), and its main blocks present
/// what that needs. Nothing where it states nothing.
void check_estimation(const Protocol& protocol, ProblemSink& problems);

}  // namespace asperity
