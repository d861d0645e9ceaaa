// The language of a participant's sessions of a protocol, which is the same in all of them.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// Of the participant's latest session of a protocol with this name, in this mode; without a mode, of the latest one that
/// is not completed, which can be resumed. Nothing without such a session.
std::optional<std::string> language_before(const Study& study, const std::string& protocol,
                                           const std::string& participant,
                                           std::optional<SessionMode> mode);

/// The file of the protocol in the language of the participant's next session: `stated`; otherwise that of the earlier
/// sessions (`mode` as in `language_before`); otherwise `file` itself, which may be a translation.
///
/// Errors: std::invalid_argument for a language that the protocol does not have; ResultsError as for Study.
std::filesystem::path protocol_for_participant(const Study& study,
                                               const std::filesystem::path& file,
                                               const std::string& participant,
                                               std::optional<SessionMode> mode,
                                               const std::optional<std::string>& stated);

/// Why the participant cannot begin a session in the protocol's language; nothing if it is that of the earlier ones.
std::optional<Phrase> complaint_about_language(const Study& study, const Protocol& protocol,
                                               const std::string& participant, SessionMode mode);

}  // namespace asperity
