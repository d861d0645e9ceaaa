// The columns of an export, each declared once: the table and the codebook are both made of this.

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "protocols/design/analysis_declaration.h"
#include "results_schema/rows.h"
#include "results_schema/table.h"

namespace asperity {

struct TimedEvent;

/// Where in a study a row of an exported table stands. What does not apply to a table is null.
struct ExportPlace {
  const ParticipantRow* participant = nullptr;
  const std::string* participant_mode = nullptr;  ///< of all sessions together
  const SessionRow* session = nullptr;
  const ProtocolRow* protocol = nullptr;
  const PlannedTrialRow* trial = nullptr;
  const AttemptRow* attempt = nullptr;
  const PresentationRow* presentation = nullptr;
  const ResponseRow* response = nullptr;
  bool response_is_withheld = false;  ///< from the public: an answer to a questionnaire
  /// The number that the answer of the attempt took the place of, when it was asked for once more.
  std::optional<double> doubted_estimate{};
  /// What takes the participant's own scale out of the answer, where it is an estimate (OwnScales).
  std::optional<double> own_scale{};
  /// The JSON of those rows, read once.
  const nlohmann::json* answers = nullptr;     ///< of the participant
  const nlohmann::json* factors = nullptr;     ///< of the trial
  const nlohmann::json* parameters = nullptr;  ///< of the presentation
  const ServoQualityRow* servo = nullptr;
  const ComplianceRow* compliance = nullptr;
  const TimedEvent* event = nullptr;
};

/// `published`: without dates, without free text, and without answers to
/// questionnaires but for those that are named (StudyVocabulary::for_public).
enum class ExportAudience { own, published };

/// What becomes of a column in an export for the public.
enum class Publication {
  kept,
  without_questionnaires,  ///< kept, but n/a where the answer is one to a questionnaire
  without_free_text,       ///< kept, but without typed text and what identifies a machine
  dropped_unless_named,    ///< answers to a questionnaire
  dropped,                 ///< dates, free text, what tells one machine from others
};

/// What one level of a column stands for.
struct LevelMeaning {
  std::string description{};
  std::string hed{};  ///< its tags (www.hedtags.org), where there are any
};

/// One column: what the codebook says of it, and how to get a cell.
struct ExportColumn {
  std::string name{};
  std::string description{};
  std::string type{};  ///< "text", "integer", "number", "boolean", "utc_time", "json"
  std::string unit{};  ///< SI; empty for what is no quantity, "1" for a pure number
  std::vector<std::string> levels{};
  std::map<std::string, LevelMeaning> level_meanings{};  ///< of those that have more than a name
  std::string hed{};  ///< HED tags of every value, with # in the place of the value
  std::optional<double> minimum{};
  std::optional<double> maximum{};
  std::string missing = "never";   ///< when the cell is n/a
  std::string source = "program";  ///< who says so: the program, a protocol, a force model
  Publication publication = Publication::kept;
  std::function<Cell(const ExportPlace&)> cell{};
  /// What the public gets instead, where that differs.
  std::function<Cell(const ExportPlace&)> published_cell{};
};

std::vector<std::string> column_names(const std::vector<ExportColumn>& columns);

struct ExportFile {
  std::string name{};  ///< without ".tsv"
  std::vector<ExportColumn> columns{};
};

/// What differs from study to study: the names that its rows and protocols use, with what the
/// protocols and the force models declare of them.
struct StudyVocabulary {
  struct FactorMeaning {
    std::string meaning{};
    std::string unit{};
    std::string source = "plans of the trials";
    std::vector<std::string> levels{};
    std::map<std::string, LevelMeaning> level_meanings{};
    bool numeric = true;
  };
  struct ParameterMeaning {
    std::set<std::string> models{};    ///< that have it
    std::set<std::string> levels{};    ///< of one that is no number
    std::set<std::string> meanings{};  ///< as they declare it
    std::optional<std::string> unit{};
    std::optional<double> minimum{};
    std::optional<double> maximum{};
  };
  struct AnswerMeaning {
    std::string prompt{};
    bool free_text = true;      ///< unless a protocol declares a choice or a number
    bool questionnaire = true;  ///< about a person or a session, not about a trial
    std::vector<std::string> options{};
    std::map<std::string, LevelMeaning>
        option_meanings{};  ///< of those that were shown as another text
    std::optional<double> minimum{};
    std::optional<double> maximum{};
    std::string source{};
  };
  std::map<std::string, FactorMeaning> factors{};
  std::map<std::string, ParameterMeaning> parameters{};
  std::map<std::string, std::set<std::string>> limits{};  ///< kind → models that watch it
  /// What the protocol files that ask for magnitudes say of their textures' spacings, by SHA-256.
  std::map<std::string, EstimationDeclaration> estimations{};
  std::set<std::string> participant_answers{};
  std::map<std::string, AnswerMeaning> questions{};  ///< by name, whichever protocol asks it
  /// Those of questionnaires as each protocol file asks them, by its SHA-256 and their name.
  std::map<std::pair<std::string, std::string>, AnswerMeaning> questions_of_source{};
  /// By the SHA-256 of a protocol file, that of the first which differs from it in nothing but texts: the file itself
  /// where there is no such.
  std::map<std::string, std::string> first_wording{};
  /// Questions of questionnaires whose answers the public gets, because somebody named them.
  std::set<std::string> for_public{};

  /// Whether the public gets the answers to this question of a questionnaire. Never those that were
  /// typed freely, nor those to a question that no protocol declares.
  bool goes_to_public(const std::string& question) const;
};

/// Every table of an export, in the order in which they are documented.
std::vector<ExportFile> export_files(const StudyVocabulary& vocabulary);

/// One row per answer to a trial's question, and one for an attempt without any: what the trial was,
/// how the attempt went, what was felt and answered.
std::vector<ExportColumn> answered_trial_columns(const StudyVocabulary& vocabulary);

/// What stands in the list of columns that were left out for answers to this question.
std::string left_out_answers_to(const std::string& question);

/// The cell of one column, as this audience gets it. Empty text counts as missing.
Cell cell_for(ExportAudience audience, const ExportColumn& column, const ExportPlace& at);
/// Without those that this audience does not get; their names go to `left_out`.
std::vector<ExportColumn> columns_for(ExportAudience audience, std::vector<ExportColumn> columns,
                                      std::vector<std::string>& left_out);

/// The unit at the end of a name, spelt as the codebook spells it.
std::optional<std::string> unit_at_end_of(std::string_view name);

/// The columns of codebook.tsv itself.
const std::vector<std::string>& codebook_columns();
/// What the codebook says of one column, cell by cell as in `codebook_columns`.
std::vector<Cell> codebook_row(const std::string& file, const ExportColumn& column);

}  // namespace asperity
