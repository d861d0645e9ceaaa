#include <optional>
#include <string>
#include <utility>

#include "app/exports/columns/column_making.h"
#include "app/exports/columns/table_columns.h"
#include "app/words/coded_phrases.h"
#include "results_schema/analysis_use.h"

namespace asperity::export_columns {
namespace {

using Place = ExportPlace;

// The text as it was stored: in English if the program wrote it, otherwise as the experimenter typed it.
Cell text_cell_of(const std::optional<StoredWords>& words) {
  return words ? Cell{words->text} : Cell{};
}

// A reason as codes. A public export has the program's reasons, and "typed" for one that the experimenter typed.
ExportColumn codes_column(const char* name, const char* when_missing, const char* description,
                          std::optional<StoredWords> AttemptRow::*reason) {
  const auto cell = [reason](std::string (*codes)(const StoredWords&)) {
    return [reason, codes](const Place& at) {
      const std::optional<StoredWords>& words = at.attempt->*reason;
      return words ? Cell{codes(*words)} : Cell{};
    };
  };
  ExportColumn made = missing(when_missing, column(name, "text", "", description, cell(codes_of)));
  made.publication = Publication::without_free_text;
  made.published_cell = cell(published_codes_of);
  return made;
}

}  // namespace

Columns attempt_columns() {
  Columns columns = keys_to(Key::attempt);
  const auto add = [&columns](ExportColumn made) { columns.push_back(std::move(made)); };
  add(at_least(1, column("segment", "integer", "",
                         "number of the segment of the session; interruptions separate segments",
                         [](const Place& at) { return integer(at.attempt->segment); })));
  add(with_levels(column("outcome", "text", "", "how the attempt ended",
                         [](const Place& at) { return text_of(at.attempt->outcome); }),
                  {"answered", "timed_out", "not_compliant", "aborted", "device_fault",
                   "emergency_stop", "skipped"}));
  add(column("valid", "boolean", "", "1: the valid attempt of its trial; there is at most one",
             [](const Place& at) { return boolean(at.attempt->valid); }));
  add(dropped(
      missing("the attempt is valid",
              column("invalid_reason", "text", "",
                     "why the attempt does not count; may be in the experimenter's words",
                     [](const Place& at) { return text_cell_of(at.attempt->invalid_reason); }))));
  add(codes_column(
      "invalid_code", "the attempt is valid",
      "the reasons as codes, separated by semicolons; \"typed\" where the experimenter typed one",
      &AttemptRow::invalid_reason));
  add(column("excluded", "boolean", "",
             "1: the attempt or its session was excluded; the attempt does not count",
             [](const Place& at) { return boolean(at.attempt->excluded.has_value()); }));
  add(dropped(missing("not excluded",
                      column("exclusion_reason", "text", "", "reason for the exclusion, as entered",
                             [](const Place& at) { return text_cell_of(at.attempt->excluded); }))));
  add(codes_column("exclusion_code", "not excluded", "the reasons as codes, as in invalid_code",
                   &AttemptRow::excluded));
  add(column("counts_in_analyses", "boolean", "",
             "1: the attempt counts in analyses: the trial belongs to the main phase and is not an "
             "anchor, and the attempt is answered, valid and not excluded",
             [](const Place& at) {
               return boolean(use_in_analyses(*at.trial, *at.attempt) == AnalysisUse::counted);
             }));
  add(column("flagged", "boolean", "", "1: the attempt should be inspected; it counts nevertheless",
             [](const Place& at) { return boolean(at.attempt->flagged); }));
  add(dropped(
      missing("not flagged",
              column("flag_reason", "text", "",
                     "what to inspect, in the words of the program or of the experimenter",
                     [](const Place& at) { return text_cell_of(at.attempt->flag_reason); }))));
  add(codes_column("flag_code", "not flagged", "the reasons as codes, as in invalid_code",
                   &AttemptRow::flag_reason));
  add(column("onset_s", "number", "s", "time of the beginning, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.attempt->onset_ns); }));
  add(column("offset_s", "number", "s", "time of the end, since the session began",
             [](const Place& at) { return seconds_in_session(at, at.attempt->offset_ns); }));
  const auto of_recording = [](auto member) {
    return [member](const Place& at) -> Cell {
      return at.attempt->recording ? Cell{(*at.attempt->recording).*member} : Cell{};
    };
  };
  const auto recording = [&](const char* name, const char* type, const char* unit,
                             const char* description, auto member) {
    add(missing("the attempt was not recorded",
                column(name, type, unit, description, of_recording(member))));
  };
  recording("recording_path", "text", "", "file of the tick records, within the study",
            &RecordingRow::path);
  recording("recording_format", "text", "", "format of that file", &RecordingRow::format);
  recording("recording_sha256", "text", "", "SHA-256 of that file", &RecordingRow::sha256);
  recording("recording_records", "integer", "1", "tick records in that file",
            &RecordingRow::records);
  return columns;
}

}  // namespace asperity::export_columns
