// Compares the checksum of the file with the one that was shown, and summarises warnings.

#include "app/tasks/checks/protocol_check.h"

#include <utility>
#include <vector>

#include "app/study_files/protocol_languages.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/warnings/session_warnings.h"
#include "protocols/file/protocol_problems.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/hashes/short_hash.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

/// Nothing where there is none.
std::optional<SessionCheck> check_of(std::vector<Diagnostic> warnings) {
  if (warnings.empty()) return {};
  sort_by_line(warnings);
  SessionCheck check{};
  check.state = State::look;
  check.warnings = std::move(warnings);
  check.remedy = phrase("SessionChecks", "The Protocols page lists all warnings.");
  return check;
}

}  // namespace

SessionCheck protocol_check(const CheckInputs& inputs, const Protocol& protocol) {
  SessionCheck check{};
  const std::string sha256 = sha256_of(protocol.source);
  if (!inputs.protocol_sha256.empty() && sha256 != inputs.protocol_sha256) {
    check.state = State::stop;
    check.text =
        phrase("SessionChecks",
               "The file has changed since it was chosen: its SHA-256 was %1 and is now %2.")
            .with(short_hash(inputs.protocol_sha256), short_hash(sha256));
    check.remedy =
        phrase("SessionChecks",
               "Choose the protocol again to read the new version, or restore the earlier file.");
    return check;
  }
  check.text = phrase("SessionChecks", "The protocol is valid: version %1, SHA-256 %2.")
                   .with(protocol.version, short_hash(sha256));
  return check;
}

std::optional<SessionCheck> protocol_warnings_check(const CheckInputs& inputs,
                                                    const Protocol& protocol,
                                                    const ModelRegistry& models) {
  const std::string file = inputs.protocol.string();
  // Without the study, whose files the session has read already.
  std::vector<Diagnostic> warnings =
      check_protocol_text(protocol.source, file, models, std::nullopt, std::nullopt).warnings;
  append(warnings, warnings_about_sessions({protocol, file},
                                           Study::open(inputs.study, Access::read_only), models));
  return check_of(std::move(warnings));
}

std::optional<SessionCheck> stimulus_warnings_check(const std::vector<Diagnostic>& warnings) {
  std::optional<SessionCheck> check = check_of(warnings);
  if (check) {
    check->id = "stimulus_warnings";
    check->title = phrase("SessionChecks", "Warnings about the stimuli");
  }
  return check;
}

void require_unchanged(const std::filesystem::path& protocol, const std::string& sha256) {
  const std::string now = sha256_of(protocol_source(protocol).text);
  if (now == sha256) return;
  throw ProtocolChangedSinceCheck(
      phrase("SessionChecks",
             "the protocol %1 has changed since it was checked: its SHA-256 was %2 and is now %3; "
             "choose it again to read and check the new version")
          .with(protocol.string(), short_hash(sha256), short_hash(now)));
}

}  // namespace asperity
