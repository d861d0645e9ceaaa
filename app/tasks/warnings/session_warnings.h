// Warns about sessions of a study that would be analysed together with new ones.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/tasks/warnings/checked_protocol.h"
#include "protocols/design/protocol.h"
#include "protocols/file/diagnostic.h"
#include "renderers/force/force_model.h"

namespace asperity {

class Study;

/// Sessions that were run with this protocol's name and version, but with another text. The same
/// protocol in another language is not another text.
struct VersionUse {
  std::string version{};
  int sessions = 0;   ///< of people and of virtual participants
  int of_people = 0;  ///< of these
};
/// Nothing where there are none, or where the text contains no name and version. Errors:
/// ResultsError as for Study.
std::optional<VersionUse> other_text_of_version(const Study& study, const std::string& text);
/// The warning that such sessions, those of virtual participants included, are analysed together with
/// new ones, at the key "version": analyses select sessions by name and version, and only the SHA-256 of the
/// protocol distinguishes them. Errors as for `other_text_of_version`.
std::optional<Diagnostic> warning_about_version(const Protocol& protocol,
                                                const std::string& file_name, const Study& study);

/// The warnings about sessions of the study that are analysed together with new ones: of another text of this version, and
/// with another build of a plug-in. Errors: ResultsError as for Study.
std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked, const Study& study,
                                                const ModelRegistry& models);
/// The same for the study in a folder; none where there is no study. If it cannot be read, a warning at the key "version"
/// states this: the protocol can be checked all the same.
std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked,
                                                const std::filesystem::path& study,
                                                const ModelRegistry& models);

}  // namespace asperity
