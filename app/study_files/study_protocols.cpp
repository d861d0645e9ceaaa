// Edits the name in the text of the file, and refuses changes of a protocol that sessions ran.

#include "app/study_files/study_protocols.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <system_error>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/study_files/protocol_languages.h"
#include "app/words/phrase_of_error.h"
#include "protocols/editing/edits.h"
#include "protocols/file/diagnostic.h"
#include "protocols/file/json_document.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr const char* kNameKey = "/name";
constexpr std::size_t kLongestName = 64;  // as in the schema

std::filesystem::path file_called(const std::filesystem::path& beside, const std::string& name) {
  return beside.parent_path() / (name + ".json");
}

std::string text_of_file(const std::filesystem::path& file) {
  return read_file(file, kProtocolFile);
}

std::vector<ProtocolInLanguage> translations_of(const std::filesystem::path& file) {
  std::vector<ProtocolInLanguage> languages = languages_of_protocol(file);
  std::erase_if(languages, [&file](const ProtocolInLanguage& one) { return one.file == file; });
  return languages;
}

std::filesystem::path translation_called(const std::filesystem::path& protocol,
                                         const ProtocolInLanguage& translation) {
  return file_called(protocol, protocol.stem().string() + '.' + translation.language);
}

/// One of the files that the protocol `file` with its translations would have under another name.
std::optional<std::filesystem::path> file_in_the_way(const std::filesystem::path& file,
                                                     const std::filesystem::path& wanted) {
  if (std::filesystem::exists(wanted)) return wanted;
  for (const ProtocolInLanguage& each : translations_of(file)) {
    const std::filesystem::path translation = translation_called(wanted, each);
    if (std::filesystem::exists(translation)) return translation;
  }
  return {};
}

/// Writes the text and copies of the translations, or nothing.
void write_copy(const std::filesystem::path& file, const std::filesystem::path& copy,
                const std::string& text) {
  std::vector<std::filesystem::path> written{};
  const auto write = [&written](const std::filesystem::path& name, const std::string& content) {
    write_file(name, content, Overwrite::refuse);
    written.push_back(name);
  };
  try {
    write(copy, text);
    for (const ProtocolInLanguage& each : translations_of(file)) {
      write(translation_called(copy, each), text_of_file(each.file));
    }
  } catch (...) {
    std::error_code ignored{};
    for (const std::filesystem::path& name : written) std::filesystem::remove(name, ignored);
    throw;
  }
}

/// The schema's rule for a protocol's name.
bool is_name(const std::string& name) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && name.size() <= kLongestName && is_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&is_letter](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
         });
}

/// By name or by text; empty texts and names match no session.
int sessions_of(const Study& study, const std::string& name, const std::string& sha256) {
  std::set<std::int64_t> protocols{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == name || row.source_sha256 == sha256) protocols.insert(row.id);
  }
  const std::vector<SessionRow> sessions = study.sessions();
  return static_cast<int>(std::count_if(
      sessions.begin(), sessions.end(),
      [&protocols](const SessionRow& row) { return protocols.contains(row.protocol_id); }));
}

void require_never_run(const Study& study, const std::filesystem::path& file) {
  const int sessions = sessions_of_protocol(study, file);
  if (sessions == 0) return;
  throw PhrasedError(
      phrase("StudyProtocols",
             "Sessions of %1 are stored (number: %2); they refer to its name and its "
             "text. Duplicate the protocol, and change the copy.")
          .with(file.filename().string(), std::to_string(sessions)));
}

/// "height_3" → "height": the base name for the numbers of further copies.
std::string without_number(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last == std::string::npos || last == 0 || last + 1 == name.size() || name[last] != '_') {
    return name;
  }
  return name.substr(0, last);
}

}  // namespace

std::optional<std::string> protocol_name(const std::string& text) {
  try {
    const JsonDocument document(text, {});
    const auto name = document.root().find("name");
    if (name == document.root().end() || !name->is_string()) return {};
    return name->get<std::string>();
  } catch (const ProtocolError&) {
    return {};
  }
}

std::string with_protocol_name(std::string text, const std::string& name) {
  if (!protocol_name(text)) return text;
  return changed(text, set_value(JsonDocument(text, {}), kNameKey, json_string(name)));
}

int sessions_of_protocol(const Study& study, const std::filesystem::path& file) {
  const std::string text = text_of_file(file);
  return sessions_of(study, protocol_name(text).value_or(""), sha256_of(text));
}

std::filesystem::path duplicate_protocol(const Study& study, const std::filesystem::path& file) {
  const std::string text = text_of_file(file);
  const std::string base = without_number(protocol_name(text).value_or(file.stem().string()));
  std::string name{};
  for (int number = 2; name.empty(); ++number) {
    const std::string next = base + '_' + std::to_string(number);
    if (file_in_the_way(file, file_called(file, next))) continue;
    if (sessions_of(study, next, {}) == 0) name = next;
  }
  std::filesystem::path copy = file_called(file, name);
  write_copy(file, copy, with_protocol_name(text, name));
  return copy;
}

std::filesystem::path rename_protocol(const Study& study, const std::filesystem::path& file,
                                      const std::string& name) {
  if (!is_name(name)) {
    throw PhrasedError(phrase("StudyProtocols",
                              "“%1” cannot be the name of a protocol. Use lower-case letters, "
                              "digits and underscores, beginning with a letter.")
                           .with(name));
  }
  const std::string text = text_of_file(file);
  const std::filesystem::path wanted = file_called(file, name);
  if (wanted == file && protocol_name(text).value_or(name) == name) return file;
  require_never_run(study, file);
  const auto in_the_way = wanted == file ? std::nullopt : file_in_the_way(file, wanted);
  if (in_the_way) {
    throw PhrasedError(
        phrase("StudyProtocols", "The study already has a file %1. Choose another name.")
            .with(in_the_way->filename().string()));
  }
  if (sessions_of(study, name, {}) > 0) {
    throw PhrasedError(phrase("StudyProtocols",
                              "Sessions of a protocol called %1 are stored in this study. Choose "
                              "another name.")
                           .with(name));
  }
  if (wanted == file) {
    write_file(file, with_protocol_name(text, name), Overwrite::allow);
  } else {
    move_protocol(file, wanted, with_protocol_name(text, name));
  }
  return wanted;
}

void move_protocol(const std::filesystem::path& from, const std::filesystem::path& to,
                   const std::string& text) {
  write_copy(from, to, text);
  const std::vector<ProtocolInLanguage> translations = translations_of(from);
  std::filesystem::remove(from);
  for (const ProtocolInLanguage& each : translations) std::filesystem::remove(each.file);
}

void delete_protocol(const Study& study, const std::filesystem::path& file) {
  require_never_run(study, file);
  for (const ProtocolInLanguage& each : translations_of(file)) std::filesystem::remove(each.file);
  std::filesystem::remove(file);
}

std::filesystem::path file_for_text(const std::filesystem::path& file, const std::string& before,
                                    const std::string& after) {
  const std::optional<std::string> name = protocol_name(after);
  if (!name || !is_name(*name) || protocol_name(before) != file.stem().string()) return file;
  const std::filesystem::path wanted = file_called(file, *name);
  return file_in_the_way(file, wanted) ? file : wanted;
}

}  // namespace asperity
