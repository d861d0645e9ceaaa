// Checks whether the protocol file is still the one that was shown or checked.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/tasks/checks/session_check.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"

namespace asperity {

SessionCheck protocol_check(const CheckInputs& inputs, const Protocol& protocol);

/// What `check` warns of (ProtocolCheck::warnings, warnings_about_sessions): `look` with all of them;
/// nothing where there is none.
std::optional<SessionCheck> protocol_warnings_check(const CheckInputs& inputs,
                                                    const Protocol& protocol,
                                                    const ModelRegistry& models);

/// The warnings of an examination of the stimuli (stimulus_examination.h): a line "stimulus_warnings" with the state
/// `look` and all of them; nothing where there is none.
std::optional<SessionCheck> stimulus_warnings_check(const std::vector<Diagnostic>& warnings);

/// The protocol file differs from the one that was checked.
class ProtocolChangedSinceCheck final : public PhrasedError {
  using PhrasedError::PhrasedError;
};

/// Compares the file with the SHA-256 of its content at the time of the check.
///
/// Errors: ProtocolChangedSinceCheck; ResultsError if there is no such file.
void require_unchanged(const std::filesystem::path& protocol, const std::string& sha256);

}  // namespace asperity
