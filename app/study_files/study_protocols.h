// The protocol files of a study: copied, renamed, deleted.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

class Study;

/// What the text states as its own "name"; nothing where it is not JSON or states none.
std::optional<std::string> protocol_name(const std::string& text);
/// The text with this name in place of its own; everything else stays byte for byte. A text that states no
/// name is returned unchanged.
std::string with_protocol_name(std::string text, const std::string& name);

/// Sessions of any mode that were begun with the file's text, or with a protocol of its name. Such a protocol
/// keeps its name and its file: rows of the store refer to both.
///
/// Errors: ResultsError as Study's, and when there is no such file.
int sessions_of_protocol(const Study& study, const std::filesystem::path& file);

/// Writes NAME_2.json (or _3, …) beside the file, with that name in the text, and returns it. A name that
/// the study has sessions of is not taken.
///
/// Errors: ResultsError as Study's, and when the file cannot be read or written.
std::filesystem::path duplicate_protocol(const Study& study, const std::filesystem::path& file);

/// Gives the protocol this name, in its text and as NAME.json, and returns the file.
///
/// Errors: PhrasedError for a name that no protocol may have, that another file has or that sessions have,
/// and for a protocol that was run; otherwise as above.
std::filesystem::path rename_protocol(const Study& study, const std::filesystem::path& file,
                                      const std::string& name);

/// Errors: PhrasedError for a protocol that was run; otherwise as above.
void delete_protocol(const Study& study, const std::filesystem::path& file);

/// The file that a changed text of `file` belongs in: NAME.json beside it where the file was called after
/// the name that the text had before, and nothing else is called so; otherwise `file`.
std::filesystem::path file_for_text(const std::filesystem::path& file, const std::string& before,
                                    const std::string& after);

}  // namespace asperity
