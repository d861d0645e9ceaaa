// Reads protocol files, the chosen protocol and the sessions of a study in one function.

#include "app/gui/start/start_facts.h"

#include <algorithm>
#include <exception>
#include <system_error>

#include "app/study_files/dealt_places.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/study_protocols.h"
#include "app/tasks/protocol_files.h"
#include "protocols/file/stored_protocol.h"
#include "protocols/plan/course.h"
#include "protocols/texts/protocol_texts.h"
#include "results_schema/error_text.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

StartFacts::ProtocolFile described(const std::filesystem::path& file) {
  StartFacts::ProtocolFile described{.file = file, .name = file.stem().string()};
  try {
    const std::string text = read_file(file, kProtocolFile);
    described.title = stored_protocol(text).protocol.title;
    described.name = protocol_name(text).value_or(described.name);
  } catch (const ResultsError&) {
    // It is listed by its file, and says why it cannot be read once it is chosen.
  }
  return described;
}

/// Empty if the file cannot be read, or is a translation with problems of its own.
std::string text_with_problems(const std::filesystem::path& file) {
  try {
    return protocol_source(file).text;
  } catch (const std::exception&) {
    return {};
  }
}

ChosenProtocol read_chosen(const std::filesystem::path& file, const std::filesystem::path& study,
                           const ModelRegistry& models) {
  ChosenProtocol chosen{.file = file};
  try {
    chosen.protocol = std::make_shared<const Protocol>(load_protocol(file, models, study));
    chosen.sha256 = sha256_of(chosen.protocol->source);
    chosen.cost = cost_of(*chosen.protocol, example_plan(*chosen.protocol, {1, 0}));
    chosen.consent = consent_as_read(*chosen.protocol);
  } catch (const ProtocolError& error) {
    chosen.problems = error.diagnostics();
    chosen.text = text_with_problems(file);
  } catch (const std::exception& error) {
    chosen.failure = message_of(error);
  }
  return chosen;
}

void read_sessions(StartFacts& facts, const Study& study) {
  const Protocol& protocol = *facts.chosen.protocol;
  std::map<std::int64_t, bool> is_this{};
  std::map<std::int64_t, std::string> languages{};  // of the protocols of this name
  for (const ProtocolRow& row : study.protocols()) {
    is_this[row.id] = row.source_sha256 == facts.chosen.sha256;
    if (row.name == protocol.name) languages[row.id] = language_of(row.source);
  }
  for (const SessionRow& row : study.sessions()) {
    const auto language = languages.find(row.protocol_id);
    const bool is_of_this_name = language != languages.end();
    facts.sessions.push_back(
        {.participant = row.participant,
         .mode = row.mode,
         .state = row.state,
         .of_this_protocol = is_this[row.protocol_id],
         .group = is_of_this_name ? row.group_level : std::nullopt,
         .language = is_of_this_name ? std::optional(language->second) : std::nullopt});
  }
  facts.unfinished = unfinished_sessions(study, protocol);
  facts.has_dealt_places = !dealt_places(study.folder()).empty();
  const int rows = counterbalance_rows(protocol);
  for (const SessionMode mode : {SessionMode::run, SessionMode::pilot, SessionMode::simulate}) {
    facts.rows_used[mode] = study.counterbalance_counts(protocol.name, rows, mode);
  }
}

}  // namespace

StartFacts read_start_facts(const std::filesystem::path& study, const ChosenProtocol& chosen,
                            const ModelRegistry& models) {
  StartFacts facts{};
  for (const std::filesystem::path& file : protocol_files(study)) {
    facts.files.push_back(described(file));
  }
  facts.chosen = chosen;
  if (chosen.file.empty() && facts.files.size() == 1) facts.chosen.file = facts.files.front().file;
  if (!facts.chosen.file.empty() && !facts.chosen.is_read()) {
    facts.chosen = read_chosen(facts.chosen.file, study, models);
  }
  if (!facts.chosen.file.empty()) facts.languages = languages_of_protocol(facts.chosen.file);
  const Study own = Study::open(study, Access::read_only);
  facts.people = own.participants();
  if (facts.chosen.protocol != nullptr) read_sessions(facts, own);
  return facts;
}

}  // namespace asperity
