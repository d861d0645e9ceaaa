// Copies a protocol of the library into a study, as a starting point.

#pragma once

#include <filesystem>
#include <string_view>

namespace asperity {

/// Writes the library's protocol, in the language "en" or "de", into the study's `protocols/` and
/// returns the file. Where the study has a file of that name, the new one, and the protocol in it,
/// is named NAME_2, NAME_3, …, so that sessions of the two are not mixed up.
///
/// Errors: std::invalid_argument for a name that is not in the library or not in this language; ResultsError when the file
/// cannot be written.
std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             std::string_view name,
                                             std::string_view language = "en");

}  // namespace asperity
