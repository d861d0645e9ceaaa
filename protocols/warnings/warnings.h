// Declares warnings about valid protocols that may not specify what the author intended.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Lists what is permitted but questionable: bands without a consequence of leaving them, strokes that do not fit into
/// the contact, speeds that hands do not reach, a force that exceeds the device's limit with the texture, explorations
/// that no block uses, groups that read no screen while others do, texts that mention bars where tones guide, or tones
/// where bars do, staircases that do not approach the estimated point, feedback at measured levels, and a selection among the levels
/// of one parameter, which analyses preference and not discrimination. No protocol is rejected for these.
///
/// `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about(const Protocol& protocol, const std::string& file_name);

}  // namespace asperity
