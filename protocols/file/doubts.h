// What a valid protocol says that its author may not have meant.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Nothing is refused for these: bands that no failure follows from, strokes that do not fit into the
/// contact, speeds of no hand, a force that the texture takes to the device's limit, explorations that
/// no block asks for, texts that speak of bars where tones guide, or of tones where bars do, and a
/// selection among the levels of one parameter, which analyses preference and not discrimination.
///
/// `file_name` is what they are said to be in.
std::vector<Diagnostic> doubts_about(const Protocol& protocol, const std::string& file_name);

}  // namespace asperity
