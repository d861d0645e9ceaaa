// Copies a protocol of the library into a study, as a starting point.

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "protocols/file/library_protocols.h"

namespace asperity {

/// Writes the library's protocol and its translations into the study's `protocols/` and returns the protocol's file. Where
/// the study has a file of that name, the new one, and the protocol in it, is named NAME_2, NAME_3, …, so that sessions of
/// the two are not mixed up.
///
/// Errors: std::invalid_argument for a name that is not in the library; ResultsError when a file cannot be written.
std::filesystem::path protocol_from_template(const std::filesystem::path& study,
                                             std::string_view name);

/// The same under a name that the study does not have. Errors: ResultsError when a file cannot be written.
std::filesystem::path write_library_protocol(const std::filesystem::path& study,
                                             const LibraryProtocol& protocol,
                                             const std::string& name);

}  // namespace asperity
