// Writes the responses of one kind of sessions as a dataset of the Brain Imaging Data Structure
// (BIDS 1.10.0).

#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/exports/codebook_file.h"
#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/export_folder.h"
#include "app/exports/made_by.h"
#include "app/records/session_timeline.h"
#include "results_schema/study.h"

namespace asperity {

/// Writes below `root` of an export: dataset_description.json, README, CHANGES, participants.tsv
/// and .json, per session `sub-…/ses-…/beh/sub-…_ses-…_task-…_beh.tsv` and `…_events.tsv`, each
/// with its .json, and, where recordings are requested, per recorded attempt
/// `…_run-…_recording-haptic_physio.tsv.gz` and .json.
///
/// BIDS requires a recording to be a single regular stream. This holds within an attempt, at the
/// rate of the servo loop, but not between attempts; an attempt is therefore a run. A tick is in
/// the row nearest to its time, or in the next one where ticks were so irregular that two would
/// share a row; rows without a tick are n/a. The first column has the original time of each tick
/// since the session began, the origin of StartTime, `_beh.tsv` and `_events.tsv`.
///
/// The task is the protocol's name without characters other than letters and digits.
///
/// Participants need not have the same protocols, sessions or recorded attempts, and a study may have a single author. The
/// validator warns of each, unless the dataset states in its own configuration of the validator
/// (.bids-validator-config.json) that it is meant; the file is written only where it is.
class BidsDataset final {
 public:
  enum class Recordings { left_out, written };

  /// `vocabulary` must outlive the dataset. `made_by`: the participants of the dataset, where they are not people whose
  /// responses count.
  BidsDataset(ExportFolder& folder, std::string root, const std::string& study_name,
              const StudyMetadata& metadata, const StudyVocabulary& vocabulary,
              ExportAudience audience, Recordings recordings, const MadeBy& made_by);

  void add_participant(const ExportPlace& at);
  void begin_session(const ExportPlace& at);
  /// Adds all events of the session.
  void add_events(const ExportPlace& at, const std::vector<PlannedTrialRow>& plan,
                  const std::vector<AttemptRow>& attempts, const std::vector<TimedEvent>& timeline);
  /// Adds the cells of answered_trial_columns for this audience; an attempt without a response has
  /// one row as well.
  void add_row(const std::vector<Cell>& row);
  /// Adds the recording of an attempt, if it has one; called before its rows.
  void add_attempt(const Study& study, const ExportPlace& at);
  void end_session();
  void finish(CodebookFile& codebook);

 private:
  std::string task_of(const std::string& protocol);
  nlohmann::ordered_json description() const;
  std::string readme() const;
  std::string changes() const;
  /// The warnings of the validator that do not apply to this dataset.
  std::vector<std::string> intended() const;
  /// A file of the current session, by the part of its name that participants share.
  void note_file(const std::string& name);
  /// Describes the presentation of the session, and every column.
  nlohmann::ordered_json session_sidecar(const ExportPlace& at,
                                         const std::vector<ExportColumn>& columns) const;

  ExportFolder& folder_;
  std::string root_{};
  std::string study_name_{};
  StudyMetadata metadata_{};
  MadeBy made_by_{};
  const StudyVocabulary& vocabulary_;
  std::string last_ended_utc_{};  ///< of the sessions of the dataset; empty where none has ended
  ExportAudience audience_;
  Recordings recordings_;
  std::vector<std::string> left_out_{};
  std::vector<std::string> participants_left_out_{};
  std::vector<std::string> events_left_out_{};
  std::vector<ExportColumn> columns_{};
  std::vector<ExportColumn> event_columns_{};
  /// The index of the response time among the cells of an answered trial.
  std::size_t response_time_ = 0;
  std::vector<ExportColumn> participant_columns_{};
  std::vector<std::vector<Cell>> participants_{};
  std::map<std::string, std::string> tasks_{};               ///< protocol → label
  std::string start_{};                                      ///< of the file names of this session
  std::string participant_{};                                ///< of this session: "sub-…"
  std::map<std::string, std::set<std::string>> files_{};     ///< by participant
  std::map<std::string, std::set<std::string>> sessions_{};  ///< by participant
  std::string task_name_{};
  std::optional<TableFile> beh_{};
  std::int64_t run_ = 0;
  bool attempt_is_recorded_ = false;
};

}  // namespace asperity
