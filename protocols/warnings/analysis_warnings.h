// Declares warnings about analyses of a valid protocol that its trials cannot support.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// A warning for every test of the declared family that no study with this protocol can have: thresholds compared between
/// conditions of which there is one, and the point of subjective equality where one response is correct; for a procedure that converges on a proportion of correct responses that
/// guessing attains; and for a similarity of fewer surfaces than two dimensions require (4·R + 1 for R dimensions
/// [Kruskal 1978]).
///
/// `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_analysis(const Protocol& protocol,
                                                const std::string& file_name);

}  // namespace asperity
