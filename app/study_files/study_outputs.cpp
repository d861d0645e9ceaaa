#include "app/study_files/study_outputs.h"

#include <algorithm>

#include "app/study_files/program.h"
#include "results_schema/atomic_file.h"
#include "results_schema/table.h"

namespace asperity {

namespace {

/// With new labels an export has no seeds of sessions, and a participant cannot be found in it by the label.
bool has_labels_of_study(const std::filesystem::path& path) {
  const std::filesystem::path file = path / "sessions.tsv";
  const std::vector<std::string> columns = read_tsv(read_file(file), file.string()).columns;
  return std::find(columns.begin(), columns.end(), "seed") != columns.end();
}

/// Whether the current file contains no row of the participant. An export lists its participants; a
/// report does not list all of them, and a file that was moved cannot be read.
bool is_without(const OutputRow& output, const std::string& label) {
  const std::filesystem::path path = output.path;
  try {
    switch (output.kind) {
      case OutputKind::export_:
      case OutputKind::public_export: {
        const std::filesystem::path file = path / "participants.tsv";
        if (!std::filesystem::exists(file) || !has_labels_of_study(path)) return false;
        const Table table = read_tsv(read_file(file), file.string());
        return std::none_of(table.rows.begin(), table.rows.end(),
                            [&](const auto& row) { return row.front() == Cell{label}; });
      }
      case OutputKind::copy:
        return Study::exists(path) && !Study::open(path, Access::read_only).participant(label);
      case OutputKind::report:
        return false;
    }
  } catch (const std::exception&) {
    return false;  // the content has changed and is unknown
  }
  return false;
}

}  // namespace

Phrase kind_words(OutputKind kind) {
  switch (kind) {
    case OutputKind::export_:
      return phrase("StudyOutputs", "export");
    case OutputKind::public_export:
      return phrase("StudyOutputs", "public export");
    case OutputKind::report:
      return phrase("StudyOutputs", "report");
    case OutputKind::copy:
      return phrase("StudyOutputs", "copy of the study");
  }
  return {};
}

std::optional<Phrase> record_output(const Study& study, OutputKind kind,
                                    const std::filesystem::path& path) {
  if (!Study::can_be_written(study.folder())) {
    return phrase("StudyOutputs",
                  "The study is read-only: it does not list %1 among its outputs. Keep a note of "
                  "it in case a participant withdraws.")
        .with(path.string());
  }
  try {
    Study::open(study.folder(), Access::read_write)
        .add_output({.kind = kind,
                     .path = std::filesystem::absolute(path).lexically_normal().string(),
                     .program_version = program_version()});
  } catch (const std::exception& error) {
    return phrase("StudyOutputs",
                  "%1 is complete, but the study does not list it; keep a note of it in case a "
                  "participant withdraws. The reason is: %2")
        .with(path.string(), phrase_of(error));
  }
  return {};
}

std::vector<OutputRow> outputs_of_participant(const Study& study, const std::string& label) {
  const std::optional<ParticipantRow> participant = study.participant(label);
  if (!participant) {
    throw ResultsError(
        "the study " + study.folder().string() + " has no participant " + label +
            "; use a label from the page Participants or from participants.tsv of an export",
        study.folder());
  }
  // The dates of a virtual participant are those of a simulated calendar.
  const std::string& since = participant->created_utc;
  const bool is_dated = !participant->is_virtual;
  std::vector<OutputRow> outputs{};
  for (OutputRow& output : study.outputs()) {
    const bool may_hold_them = is_dated ? output.made_utc >= since : !is_without(output, label);
    if (may_hold_them) outputs.push_back(std::move(output));
  }
  return outputs;
}

}  // namespace asperity
