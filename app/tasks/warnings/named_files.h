// Checks the files that a protocol names, and whether shapes and assets can be made from them.

#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "app/session/stimulus_builder.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// Problems of the files that a protocol names: those that do not exist, are not in the study (through a link), or are not a height
/// field, picture or WAV as required. `is_looked_at` selects the files, by their place.
std::vector<Diagnostic> problems_of_named_files(
    const Protocol& protocol, const std::string& file_name, const std::filesystem::path& study,
    StimulusBuilder& builder, const std::function<bool(const Diagnostic& place)>& is_looked_at);

/// The same of all its files; without such a problem, those of shapes that cannot be made from them, then those of assets that
/// their model refuses.
std::vector<Diagnostic> problems_of_files(const CheckedProtocol& checked,
                                          const std::filesystem::path& study,
                                          StimulusBuilder& builder);

}  // namespace asperity
