// Reads the files, and compares their checksums with those that a session to resume began with.

#include "app/tasks/checks/stimuli_check.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "app/session/session_setup.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/unfinished_session.h"
#include "app/tasks/warnings/plugin_warnings.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

Phrase files_text(std::size_t files, bool resume) {
  if (files == 0) return phrase("SessionChecks", "The protocol uses no files.");
  if (files == 1) {
    return resume
               ? phrase("SessionChecks",
                        "The protocol uses 1 file, which has not changed since the session began.")
               : phrase("SessionChecks",
                        "The protocol uses 1 file, which is present and has not changed since it "
                        "was made.");
  }
  return (resume
              ? phrase(
                    "SessionChecks",
                    "The protocol uses %1 files, which have not changed since the session began.")
              : phrase("SessionChecks",
                       "The protocol uses %1 files, which are present and have not changed since "
                       "they were made."))
      .with(std::to_string(files));
}

}  // namespace

SessionCheck stimuli_check(const CheckInputs& inputs, const Protocol& protocol,
                           const ModelRegistry& models) {
  SessionCheck check{.state = State::stop};
  try {
    StimulusBuilder builder(models, inputs.study);
    load_protocol_to_run(inputs.protocol, inputs.study, builder, inputs.rehearsal.get());
  } catch (const ProtocolError& error) {
    for (const Diagnostic& problem : error.diagnostics()) {
      const Phrase sentence = problem.message.as_sentence();
      check.text = check.text.empty() ? sentence : Phrase("%1 %2").with(check.text, sentence);
    }
    check.remedy = phrase("SessionChecks", "Restore the files in the study, or make them again.");
    return check;
  }
  const std::vector<StimulusFileRow> files = hash_files(protocol, inputs.study);
  const Study study = Study::open(inputs.study, Access::read_only);
  if (inputs.resume) {
    const SessionRow row =
        find_unfinished(study, protocol, inputs.participant, inputs.resumed_session);
    for (const StimulusFileRow& before : row.files) {
      const bool same = std::any_of(files.begin(), files.end(), [&before](const auto& file) {
        return file.path == before.path && file.sha256 == before.sha256;
      });
      if (same) continue;
      check.text = phrase("SessionChecks", "The file %1 has changed since session %2 began.")
                       .with(before.path, std::to_string(row.session));
      check.remedy =
          phrase("SessionChecks",
                 "Restore the earlier file; this session cannot be resumed with a different file.");
      return check;
    }
  }
  const std::vector<OtherBuild> builds = other_builds({protocol, {}}, study, models, inputs.mode);
  if (!builds.empty()) {
    check.state = State::look;
    check.text = builds.front().text().as_sentence();
    check.remedy = remedy_for_builds().as_sentence();
    return check;
  }
  check.state = State::fine;
  check.text = files_text(files.size(), inputs.resume);
  return check;
}

}  // namespace asperity
