// The files for direct analysis of one group of sessions: human participants, pilot sessions, or virtual participants.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/exports/bids.h"
#include "app/exports/codebook_file.h"
#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/detection_table.h"
#include "app/exports/export_options.h"
#include "app/exports/fit_table.h"
#include "app/exports/psych_ds.h"
#include "app/exports/sav_table.h"
#include "app/exports/wide_table.h"
#include "app/records/session_timeline.h"
#include "results_schema/study.h"

namespace asperity {

/// A group of sessions that are not analysed together with others.
enum class SessionGroup { run, pilot, virtual_participants };
SessionGroup session_group_of(const ParticipantRow& participant, const SessionRow& session);

/// Writes the requested formats for the sessions of one group. Rows are added in the order of participants, sessions and
/// attempts.
class GroupFiles final {
 public:
  GroupFiles(ExportFolder& folder, SessionGroup group, const std::string& study_name,
             const StudyMetadata& metadata, const StudyVocabulary& vocabulary,
             const ExportOptions& options);

  void begin_participant(const ExportPlace& at);
  void begin_session(const ExportPlace& at, const std::vector<PlannedTrialRow>& plan,
                     const std::vector<AttemptRow>& attempts,
                     const std::vector<TimedEvent>& timeline);
  void end_session();
  void add_session_answer(const ExportPlace& at);
  void begin_attempt(const Study& study, const ExportPlace& at);
  /// With a response, or without one if the attempt has none.
  void add_row(const ExportPlace& at);
  /// Completes the files. `not_written` receives the formats without content.
  void finish(CodebookFile& codebook, std::vector<Phrase>& not_written);

 private:
  void finish_fit(CodebookFile& codebook, std::vector<Phrase>& not_written);
  void finish_wide(CodebookFile& codebook);

  ExportFolder& folder_;
  std::string root_{};
  std::string title_{};
  ExportOptions options_{};
  std::vector<ExportColumn> columns_{};
  std::vector<std::string> left_out_{};
  std::optional<WideTable> wide_{};
  std::optional<FitTable> fit_{};
  std::optional<DetectionTable> detection_{};
  std::optional<SavTable> trials_{};
  std::optional<BidsDataset> bids_{};
  std::optional<PsychDataset> psych_{};
};

}  // namespace asperity
