// Copies, renames and deletes the protocol files of a study, each with its translations.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace asperity {

class Study;

/// The "name" in the text; nothing where the text is not JSON or has no name.
std::optional<std::string> protocol_name(const std::string& text);
/// Replaces the name in the text; everything else is unchanged byte for byte. A text without a name
/// is returned unchanged.
std::string with_protocol_name(std::string text, const std::string& name);

/// The number of sessions of any mode that were begun with the file's text, or with a protocol of
/// its name. Such a protocol keeps its name and its file: rows of the store refer to both.
///
/// Errors: ResultsError as for Study, and when there is no such file.
int sessions_of_protocol(const Study& study, const std::filesystem::path& file);

/// Writes NAME_2.json (or _3, …) next to the file, with that name in the text, and returns it.
/// Names with sessions in the study are not used.
///
/// Errors: ResultsError as for Study, and when the file cannot be read or written.
std::filesystem::path duplicate_protocol(const Study& study, const std::filesystem::path& file);

/// Gives the protocol this name, in its text and as NAME.json, and returns the file.
///
/// Errors: PhrasedError for a name that is not valid, that another file has or that sessions have,
/// and for a protocol that was run; otherwise as for `duplicate_protocol`.
std::filesystem::path rename_protocol(const Study& study, const std::filesystem::path& file,
                                      const std::string& name);

/// Writes the text, which replaces that of the protocol in the file `from`, to the new file `to` in the same folder, and names
/// its translations after it. Errors: ResultsError if a file of one of these names exists or cannot be written; then
/// everything is as before.
void move_protocol(const std::filesystem::path& from, const std::filesystem::path& to,
                   const std::string& text);

/// Errors: PhrasedError for a protocol that was run; otherwise as for `duplicate_protocol`.
void delete_protocol(const Study& study, const std::filesystem::path& file);

/// The file in which to save a changed text of `file`: NAME.json next to it where the file had the
/// name that the text contained before, and no other file has the new name or that of one of its translations; otherwise
/// `file`.
std::filesystem::path file_for_text(const std::filesystem::path& file, const std::string& before,
                                    const std::string& after);

}  // namespace asperity
