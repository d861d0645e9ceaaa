// Finds protocols and their translations: NAME.json, and NAME.LANGUAGE.json next to it.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "protocols/file/diagnostic.h"

namespace asperity {

/// The protocol files of a study, by name, without the translations.
/// Errors: ResultsError for a folder that cannot be read.
std::vector<std::filesystem::path> protocol_files(const std::filesystem::path& study);

/// A language of a protocol, and the file that stands for the protocol in this language: that of the protocol, or of a
/// translation.
struct ProtocolInLanguage {
  std::string language{};
  std::filesystem::path file{};
};

/// The protocol's own language, then those of its translations. `file` is any of these files. Files that cannot be read
/// are left out.
std::vector<ProtocolInLanguage> languages_of_protocol(const std::filesystem::path& file);

/// The file of the protocol in a language. Errors: std::invalid_argument with the languages that there are; ResultsError if
/// the protocol cannot be read.
std::filesystem::path protocol_in_language(const std::filesystem::path& file,
                                           const std::string& language);

/// The file that a translation translates; another file itself. Errors: none.
std::filesystem::path protocol_of(const std::filesystem::path& file);

/// The text of the protocol that a file stands for.
struct ProtocolSource {
  std::string text{};  ///< of a translation: the protocol's with the translated texts
  /// The protocol's, on whose lines the text is: the places of its problems are in this file.
  std::filesystem::path file{};
  std::vector<Diagnostic> warnings{};  ///< of the translation
};
/// Errors: ResultsError for a file that cannot be read; ProtocolError with the problems of a translation.
ProtocolSource protocol_source(const std::filesystem::path& file);

}  // namespace asperity
