// Declares warnings about texts for participants that contradict the design of their protocol.

#pragma once

#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// Whether a question shows pictures of textures, or a photograph is the standard of realism.
bool has_pictures(const Protocol& protocol);

/// Names the texts, in English and German, that state another number than the design ("eight scales" above four), or mention
/// what the protocol does not have (a scale, a line, a familiarisation, practice, pictures, breaks, an eye mask, “I cannot tell”).
/// A number is accepted where it is one of the design: of surfaces in a trial or in the study, of trials in a run, in the main
/// part or in the session. Minutes of the session may differ from the
/// estimate by a third, and trials by a tenth after "about".
///
/// `example` is a plan of a valid protocol, for its first group; minutes in a screen of other groups are compared with a plan of
/// these. `file_name` is the file in the diagnostics.
std::vector<Diagnostic> warnings_about_texts(const Protocol& protocol, const std::string& file_name,
                                             const Plan& example);

}  // namespace asperity
