#include "app/study_files/protocol_languages.h"

#include <exception>
#include <optional>
#include <stdexcept>
#include <utility>

#include "protocols/design/wording.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/file/translation.h"
#include "protocols/keys/tables.h"
#include "protocols/keys/valid_part.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

/// "de" for NAME.de.json; empty for NAME.json.
std::string language_in_name(const std::filesystem::path& file) {
  const std::string ending = file.stem().extension().string();
  return file.extension() == ".json" && ending.size() > 1 ? ending.substr(1) : std::string{};
}

/// NAME.json for NAME.de.json.
std::filesystem::path translated_by(const std::filesystem::path& file) {
  return file.parent_path() / (file.stem().stem().string() + ".json");
}

/// The content of a file whose name is that of a translation, if it states this format, or next to its protocol whatever is
/// no protocol: a mistake in it is one of a translation.
std::optional<std::string> translation_in(const std::filesystem::path& file) {
  if (language_in_name(file).empty()) return {};
  try {
    std::string text = read_file(file, kProtocolFile);
    if (is_translation(text) ||
        (std::filesystem::exists(translated_by(file)) && !is_protocol(text))) {
      return text;
    }
  } catch (const std::exception&) {
    // Its reader reports it.
  }
  return {};
}

}  // namespace

std::vector<std::filesystem::path> protocol_files(const std::filesystem::path& study) {
  std::vector<std::filesystem::path> files{};
  std::error_code ignored{};
  for (const auto& entry : entries_in(study / "protocols")) {
    const std::filesystem::path& file = entry.path();
    if (file.extension() == ".json" && entry.is_regular_file(ignored) && !translation_in(file)) {
      files.push_back(file);
    }
  }
  return files;
}

std::filesystem::path protocol_of(const std::filesystem::path& file) {
  if (!translation_in(file)) return file;
  return translated_by(file);
}

std::vector<ProtocolInLanguage> languages_of_protocol(const std::filesystem::path& file) {
  const std::filesystem::path own = protocol_of(file);
  std::vector<ProtocolInLanguage> languages{};
  try {
    languages.push_back({language_of(read_file(own, kProtocolFile)), own});
    for (const auto& entry : entries_in(own.has_parent_path() ? own.parent_path() : ".")) {
      const std::filesystem::path name = entry.path().filename();
      if (name.stem().stem() != own.stem() || !translation_in(entry.path())) continue;
      languages.push_back({language_in_name(name), own.parent_path() / name});
    }
  } catch (const std::exception&) {
    // Its reader reports it.
  }
  return languages;
}

std::filesystem::path protocol_in_language(const std::filesystem::path& file,
                                           const std::string& language) {
  std::vector<std::string> known{};
  for (const ProtocolInLanguage& each : languages_of_protocol(file)) {
    if (each.language == language) return each.file;
    known.push_back(each.language);
  }
  if (known.empty()) read_file(protocol_of(file), kProtocolFile);  // which states why
  const std::string name = protocol_of(file).stem().string();
  throw std::invalid_argument("the protocol " + name + " is not available in the language " +
                              in_quotes(language) + "; choose " + one_of(known) +
                              ", or add the translation " + name + '.' + language + ".json");
}

ProtocolSource protocol_source(const std::filesystem::path& file) {
  const std::optional<std::string> translation = translation_in(file);
  if (!translation) return {.text = read_file(file, kProtocolFile), .file = file};
  const std::filesystem::path own = protocol_of(file);
  if (!std::filesystem::exists(own)) {
    throw ProtocolError({{file.string(), 1, 1, "",
                          phrase("Protocols",
                                 "this translation belongs to the protocol %1, which is not in the "
                                 "same folder")
                              .with(own.filename().string())}});
  }
  const std::string text = read_file(own, kProtocolFile);
  const std::string language = language_in_name(file);
  if (!valid_part(language, kProtocolTable.find("language")->shape, "", "").problems.empty()) {
    throw ProtocolError(
        {{file.string(), 1, 1, "",
          phrase("Protocols",
                 "%1 in the name of this file is not a language; name it by a BCP 47 tag, such as "
                 "%2.de.json")
              .with(in_quotes(language), own.stem().string())}});
  }
  if (language_of(text) == language) {
    throw ProtocolError(
        {{file.string(), 1, 1, "",
          phrase("Protocols",
                 "the protocol %1 is in the language %2 itself; name the translation after another "
                 "language")
              .with(own.filename().string(), in_quotes(language))}});
  }
  TranslatedProtocol made = translated(text, own.string(), {*translation, file.string(), language});
  if (!made.problems.empty()) throw ProtocolError(std::move(made.problems));
  return {.text = std::move(made.text), .file = own, .warnings = std::move(made.warnings)};
}

}  // namespace asperity
