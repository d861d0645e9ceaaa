// Compares the text and the plug-ins of the study's sessions with those of a protocol.

#include "app/tasks/warnings/session_warnings.h"

#include <cstdint>
#include <exception>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/tasks/warnings/plugin_warnings.h"
#include "app/words/phrase_of_error.h"
#include "protocols/design/wording.h"
#include "protocols/file/json_document.h"
#include "protocols/file/stored_protocol.h"
#include "results_schema/study.h"

namespace asperity {

std::optional<VersionUse> other_text_of_version(const Study& study, const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object()) return {};
  const auto said = [&json](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string{};
  };
  const std::string name = said("name");
  VersionUse use{.version = said("version")};
  if (name.empty() || use.version.empty()) return {};
  std::set<std::int64_t> others{};
  for (const ProtocolRow& row : study.protocols()) {
    if (row.name == name && row.version == use.version && row.source != text &&
        count_protocols({row.source, text}) > 1) {
      others.insert(row.id);
    }
  }
  for (const SessionRow& session : study.sessions()) {
    if (!others.contains(session.protocol_id)) continue;
    ++use.sessions;
    if (session.mode != SessionMode::simulate) ++use.of_people;
  }
  if (use.sessions == 0) return {};
  return use;
}

std::optional<Diagnostic> warning_about_version(const Protocol& protocol,
                                                const std::string& file_name, const Study& study) {
  const auto use = other_text_of_version(study, protocol.source);
  if (!use) return {};
  const Phrase sessions =
      (use->sessions == 1 ? phrase("Protocols", "%1 session") : phrase("Protocols", "%1 sessions"))
          .with(std::to_string(use->sessions));
  return JsonDocument(protocol.source, file_name)
      .at_key("/version",
              (use->of_people > 0
                   ? phrase("Protocols",
                            "the study has %1 of %2 with another text of the protocol; their "
                            "responses would be analysed together with new ones; give the changed "
                            "protocol a new version")
                   : phrase("Protocols",
                            "the study has %1 of virtual participants with another text of %2; "
                            "their responses would be analysed together with new ones; remove the "
                            "virtual participants, or give the changed protocol a new version"))
                  .with(sessions, protocol.name + ' ' + use->version));
}

std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked, const Study& study,
                                                const ModelRegistry& models) {
  std::vector<Diagnostic> warnings = warnings_about_plugins(checked, study, models, std::nullopt);
  if (auto warning = warning_about_version(checked.protocol, checked.file_name, study)) {
    warnings.insert(warnings.begin(), std::move(*warning));
  }
  return warnings;
}

std::vector<Diagnostic> warnings_about_sessions(const CheckedProtocol& checked,
                                                const std::filesystem::path& study,
                                                const ModelRegistry& models) {
  try {
    if (!Study::exists(study)) return {};
    return warnings_about_sessions(checked, Study::open(study, Access::read_only), models);
  } catch (const std::exception& error) {
    return {JsonDocument(checked.protocol.source, checked.file_name)
                .at_key("/version", phrase("Protocols",
                                           "whether the study has sessions with another text of "
                                           "this version, or with another build of a plug-in, "
                                           "could not be determined: %1")
                                        .with(phrase_of(error)))};
  }
}

}  // namespace asperity
