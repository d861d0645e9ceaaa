// Adds the output before it is written and completes it afterwards, and finds those with a participant.

#include "app/study_files/study_outputs.h"

#include <algorithm>
#include <cerrno>
#include <sys/stat.h>
#include <utility>

#include "app/study_files/program.h"
#include "app/study_files/study_condition.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/table.h"

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
  // What is being made takes the place of another one at the end; a path that was blanked leads nowhere.
  if (output.made_utc.empty() || path.empty()) return false;
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
      case OutputKind::merge: {
        if (!Study::exists(path)) return false;
        // There the label can have a prefix.
        const std::vector<ParticipantRow> there =
            Study::open(path, Access::read_only).participants();
        return std::none_of(there.begin(), there.end(), [&label](const ParticipantRow& row) {
          return row.label.ends_with(label);
        });
      }
      case OutputKind::report:
        return false;
    }
  } catch (const std::exception&) {
    return false;  // the content has changed and is unknown
  }
  return false;
}

/// Of a folder whose program was killed, the folder NAME.part in which it was being made, if that is there.
void name_remains(OutputRow& output) {
  if (!output.made_utc.empty() || output.path.empty()) return;
  std::string part = output.path;
  while (part.ends_with('/')) part.pop_back();
  part += ".part";
  std::error_code unreadable;
  if (std::filesystem::exists(part, unreadable)) output.path = part;
}

/// Which file or folder is at a path; 0 and 0 for none, nothing where that is unknown.
std::optional<std::pair<dev_t, ino_t>> identity_at(const std::filesystem::path& path) {
  struct stat status = {};
  if (::lstat(path.c_str(), &status) == 0) return {{status.st_dev, status.st_ino}};
  if (errno == ENOENT || errno == ENOTDIR) return {{0, 0}};
  return {};
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
    case OutputKind::merge:
      return phrase("StudyOutputs", "merged study");
  }
  return {};
}

ListedOutput::ListedOutput(const Study& study, OutputKind kind, const std::filesystem::path& path)
    : study_(study.folder()),
      path_(std::filesystem::absolute(path).lexically_normal()),
      before_(identity_at(path_)) {
  if (!Study::can_be_written(study_)) {
    unlisted_ = phrase("StudyOutputs",
                       "The study is read-only: it does not list %1 among its outputs. Keep a note "
                       "of it in case a participant withdraws.")
                    .with(path.string());
    return;
  }
  try {
    // Found before the writer, which leaves a checksum of what it finds.
    refuse_if_broken(study);
    entry_ = Study::open(study_, Access::read_write)
                 .begin_output(
                     {.kind = kind, .path = path_.string(), .program_version = program_version()});
  } catch (const std::exception& error) {
    unlisted_ = phrase("StudyOutputs",
                       "%1 is complete, but the study does not list it; keep a note of it in case "
                       "a participant withdraws. The reason is: %2")
                    .with(path.string(), phrase_of(error));
  }
}

ListedOutput::~ListedOutput() {
  if (!entry_) return;
  // An output that took its place and failed after that, for example when it was synced, exists.
  const auto now = identity_at(path_);
  if (!now || now != before_) return;
  try {
    Study::open(study_, Access::read_write).remove_output(*entry_);
  } catch (const std::exception&) {
    // Then it stays listed as incomplete.
  }
}

std::optional<Phrase> ListedOutput::complete() {
  if (!entry_) return unlisted_;
  const std::int64_t entry = *entry_;
  entry_.reset();
  try {
    Study::open(study_, Access::read_write).end_output(entry);
  } catch (const std::exception&) {
    // It is listed, which is what counts when a participant withdraws, although as incomplete.
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
  return outputs_of_withdrawal(
      {.row = {.is_virtual = participant->is_virtual}, .outputs = study.outputs_since_added(label)},
      label);
}

std::vector<OutputRow> outputs_of_withdrawal(const Withdrawal& withdrawal,
                                             const std::string& label) {
  std::vector<OutputRow> outputs = withdrawal.outputs;
  // The dates of a virtual participant are those of a simulated calendar: the content of the output decides.
  if (withdrawal.row.is_virtual) {
    std::erase_if(outputs, [&label](const OutputRow& output) { return is_without(output, label); });
  }
  for (OutputRow& output : outputs) name_remains(output);
  return outputs;
}

}  // namespace asperity
