#include "app/tasks/study_outputs.h"

#include <algorithm>

#include "app/program.h"

namespace asperity {

std::optional<Phrase> record_output(const Study& study, OutputKind kind,
                                    const std::filesystem::path& path) {
  if (study.schema_version() < Study::kSchemaVersion) {
    return phrase("StudyOutputs",
                  "The study is of an older version of Asperity and was not changed: it does not "
                  "list %1 among what was made of it. Keep a note of it for the case that a "
                  "participant withdraws.")
        .with(path.string());
  }
  if (!Study::can_be_written(study.folder())) {
    return phrase("StudyOutputs",
                  "The study can only be read here: it does not list %1 among what was made of it. "
                  "Keep a note of it for the case that a participant withdraws.")
        .with(path.string());
  }
  try {
    Study::open(study.folder(), Access::read_write)
        .add_output({.kind = kind,
                     .path = std::filesystem::absolute(path).lexically_normal().string(),
                     .program_version = program_version()});
  } catch (const std::exception& error) {
    return phrase("StudyOutputs", "%1 is complete, but the study does not list it: %2")
        .with(path.string(), phrase_of(error));
  }
  return {};
}

OutputsOfParticipant outputs_of_participant(const Study& study, const std::string& label) {
  const std::optional<ParticipantRow> participant = study.participant(label);
  if (!participant) {
    throw ResultsError("the study " + study.folder().string() + " has no participant " + label,
                       study.folder());
  }
  // A virtual participant is of a simulated calendar, and may be in all of them.
  const std::string& since = participant->created_utc;
  const bool is_dated = !participant->is_virtual;
  OutputsOfParticipant outputs{};
  for (OutputRow& output : study.outputs()) {
    if (!is_dated || output.made_utc >= since) outputs.recorded.push_back(std::move(output));
  }
  const std::string recorded_since = study.outputs_since_utc();
  if (is_dated && since < recorded_since) outputs.unknown_before_utc = recorded_since;
  return outputs;
}

}  // namespace asperity
