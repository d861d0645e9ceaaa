// A column of an exported table: its documentation, and the function that computes its cells.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "results_schema/rows.h"
#include "results_schema/tables/table.h"

namespace asperity {

class EyeMask;
struct RecordedStretch;
struct TimedEvent;

/// The rows of a study from which a row of an exported table is made. Members that do not apply to a table
/// are null.
struct ExportPlace {
  const ParticipantRow* participant = nullptr;
  const std::string* participant_mode = nullptr;       ///< of all sessions together
  const std::string* participant_groups = nullptr;     ///< of all sessions; empty: none
  const std::string* participant_languages = nullptr;  ///< the same
  const SessionRow* session = nullptr;
  const ProtocolRow* protocol = nullptr;
  const PlannedTrialRow* trial = nullptr;
  const AttemptRow* attempt = nullptr;
  const PresentationRow* presentation = nullptr;
  const ResponseRow* response = nullptr;
  /// In a public export: a response to a questionnaire, or free text.
  bool response_is_withheld = false;
  /// The first estimate of the attempt, if the magnitude was re-elicited.
  std::optional<double> doubted_estimate{};
  /// The factor that removes the participant's own scale from an estimate (ParticipantResult).
  std::optional<double> own_scale{};
  /// Of the session: its stretches of uninterrupted running, and when the eye mask was worn.
  const std::vector<RecordedStretch>* stretches = nullptr;
  const EyeMask* eye_mask = nullptr;
  /// Of the session: whether the declared rule excludes the participant by errors in catch trials (ParticipantResult).
  std::optional<bool> is_excluded_by_catch{};
  std::size_t attempts_of_trial = 0;
  // The JSON of these rows, parsed.
  const nlohmann::json* answers = nullptr;     ///< of the participant
  const nlohmann::json* factors = nullptr;     ///< of the trial
  const nlohmann::json* plan = nullptr;        ///< the complete trial
  const nlohmann::json* parameters = nullptr;  ///< of the presentation
  const ServoQualityRow* servo = nullptr;
  const VisitRow* visit = nullptr;
  int visit_number = 0;  ///< of the surface, from 1
  const ComplianceRow* compliance = nullptr;
  const TimedEvent* event = nullptr;
};

enum class ExportAudience {
  own,
  /// Without dates, without free text, and without responses to questionnaires except those that are named
  /// (StudyVocabulary::for_public).
  published,
  /// The same, and the participants have new labels: also without what indicates when, or in which order, the
  /// sessions were run.
  relabelled,
};
constexpr bool is_public(ExportAudience audience) noexcept {
  return audience != ExportAudience::own;
}

/// How a column appears in a public export.
enum class Publication {
  kept,
  without_questionnaires,   ///< kept, but n/a for a response to a questionnaire and for free text
  without_free_text,        ///< kept, but without typed text and without identifiers of a machine
  dropped_unless_named,     ///< responses to a questionnaire
  dropped_with_new_labels,  ///< left out with new labels, otherwise kept
  dropped,                  ///< dates, free text, identifiers of a machine
};

/// The meaning of one level of a column.
struct LevelMeaning {
  std::string description{};
  std::string hed{};  ///< its HED tags (www.hedtags.org), if any
};

/// One column, declared once for its table and for the codebook.
struct ExportColumn {
  std::string name{};
  std::string description{};
  std::string type{};  ///< "text", "integer", "number", "boolean", "utc_time", "json"
  std::string unit{};  ///< SI; "1" if dimensionless; empty if not a quantity
  std::vector<std::string> levels{};
  std::map<std::string, LevelMeaning>
      level_meanings{};  ///< of the levels that have more than a name
  std::string hed{};     ///< HED tags of every value, with # in place of the value
  std::optional<double> minimum{};
  std::optional<double> maximum{};
  std::string missing = "never";   ///< the condition under which the cell is n/a
  std::string source = "program";  ///< of the documentation: the program, a protocol, a force model
  Publication publication = Publication::kept;
  std::function<Cell(const ExportPlace&)> cell{};
  /// The cell in a public export, if it differs.
  std::function<Cell(const ExportPlace&)> published_cell{};
  /// The cell in a public export with new labels, if it differs from `published_cell`.
  std::function<Cell(const ExportPlace&)> relabelled_cell{};
};

std::vector<std::string> column_names(const std::vector<ExportColumn>& columns);

struct ExportFile {
  std::string name{};  ///< without ".tsv"
  std::vector<ExportColumn> columns{};
};

/// Whether this audience does not receive a column.
bool is_left_out(Publication publication, ExportAudience audience) noexcept;
/// The cell of one column for this audience. Empty text counts as missing.
Cell cell_for(ExportAudience audience, const ExportColumn& column, const ExportPlace& at);
/// The columns without those that this audience does not receive; the names of these are added to `left_out`.
std::vector<ExportColumn> columns_for(ExportAudience audience, std::vector<ExportColumn> columns,
                                      std::vector<std::string>& left_out);

}  // namespace asperity
