// The arrangement of a block's trials, as the report states it.

#pragma once

#include <set>
#include <string>

#include "protocols/design/protocol.h"

namespace asperity {

/// Sentences, each with a blank in front; empty for the plain sequence of surfaces that can be felt again.
std::string arrangement_sentences(const Protocol::Block& block);

/// The same in the past tense, for a paper, without the arrangement's name and without a blank in front.
std::string past_arrangement_sentences(const Protocol::Block& block);

/// "500 N/m", "between 400 N/m and 600 N/m": the stiffness of the surfaces that were presented, or that of the protocol
/// for attempts of versions that did not store it.
std::string stiffness_text(const std::set<double>& presented_N_per_m, const Protocol& protocol);
/// The same of the coefficient of friction: "0.2", "between 0.1 and 0.4".
std::string friction_text(const std::set<double>& presented, const Protocol& protocol);

}  // namespace asperity
