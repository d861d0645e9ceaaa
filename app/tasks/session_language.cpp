#include "app/tasks/session_language.h"

#include <map>

#include "app/study_files/protocol_languages.h"
#include "app/study_files/study_protocols.h"
#include "protocols/file/stored_protocol.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

std::optional<std::string> language_before(const Study& study, const std::string& protocol,
                                           const std::string& participant,
                                           std::optional<SessionMode> mode) {
  std::map<std::int64_t, std::string> languages{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == protocol) languages[row.id] = language_of(row.source);
  }
  std::optional<std::string> latest{};
  for (const SessionRow& row : study.sessions()) {
    if (row.participant != participant) continue;
    if (mode ? row.mode != *mode : row.state == SessionState::completed) continue;
    if (const auto found = languages.find(row.protocol_id); found != languages.end()) {
      latest = found->second;
    }
  }
  return latest;
}

std::filesystem::path protocol_for_participant(const Study& study,
                                               const std::filesystem::path& file,
                                               const std::string& participant,
                                               std::optional<SessionMode> mode,
                                               const std::optional<std::string>& stated) {
  if (stated) return protocol_in_language(file, *stated);
  const std::filesystem::path own = protocol_of(file);
  if (own != file) return file;
  const std::string text = read_file(own, kProtocolFile);
  const std::string name = protocol_name(text).value_or("");
  const std::optional<std::string> before = language_before(study, name, participant, mode);
  return before && *before != language_of(text) ? protocol_in_language(file, *before) : file;
}

std::optional<Phrase> complaint_about_language(const Study& study, const Protocol& protocol,
                                               const std::string& participant, SessionMode mode) {
  const std::optional<std::string> before =
      language_before(study, protocol.name, participant, mode);
  if (!before || *before == protocol.language) return {};
  return phrase("SessionLanguage",
                "the earlier sessions of participant %1 were in the language \"%2\" and this one "
                "would be in \"%3\"; all sessions of a participant are in one language: choose "
                "\"%2\", or another participant")
      .with(participant, *before, protocol.language);
}

}  // namespace asperity
