// Reads protocol files.

#pragma once

#include <filesystem>
#include <optional>

#include "app/session/rehearsal/rehearsal_memory.h"
#include "app/session/stimulus_builder.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// A name without a file is looked up in the study's `protocols/`; without a file there, the name itself.
std::filesystem::path found_protocol(const std::filesystem::path& file,
                                     const std::optional<std::filesystem::path>& study);

/// Reads and checks the protocol that `found_protocol` finds; for the file of a translation, the protocol in its language
/// (protocol_languages.h).
///
/// Errors: ProtocolError; ResultsError when there is no such file.
Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study);

/// The same for a protocol that is about to run: the files that it names are checked as well, and
/// its stimuli are rehearsed.
///
/// Errors: ProtocolError with every file that does not exist, is not in the study (through a link),
/// or is not a height field, picture or WAV as required, or otherwise with the problems found by
/// `problems_of_plugin_stimuli` or `rehearse`; other errors as for `load_protocol`. Stimuli that `memory` (null: none) has as free
/// of problems are not rehearsed again.
Protocol load_protocol_to_run(const std::filesystem::path& file, const std::filesystem::path& study,
                              StimulusBuilder& builder, RehearsalMemory* memory = nullptr);

}  // namespace asperity
