// Declares the completion of the key "estimation" by the levels of its factors.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// The levels of a factor as text, in their order.
std::vector<std::string> level_texts(const Factor& factor);

/// Completes the estimation of a protocol, if it has one, by what its factors and textures state: the conditions, the
/// spacings, the items and their predictor. What they do not state is absent.
void complete_estimation(Protocol& protocol);

}  // namespace asperity
