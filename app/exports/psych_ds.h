// Writes the responses of one kind of sessions as a dataset of Psych-DS.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/export_folder.h"
#include "app/exports/made_by.h"

namespace asperity {

/// Writes below `root` of an export: dataset_description.json, which describes every column, and
/// per session `data/subject-…_session-…_task-…_data.csv`.
class PsychDataset final {
 public:
  PsychDataset(ExportFolder& folder, std::string root, const std::string& study_name,
               const StudyVocabulary& vocabulary, ExportAudience audience, const MadeBy& made_by);

  void begin_session(const ExportPlace& at);
  /// Adds the cells of answered_trial_columns for this audience.
  void add_row(const std::vector<Cell>& row);
  void end_session();
  void finish();

 private:
  ExportFolder& folder_;
  std::string root_{};
  std::string study_name_{};
  MadeBy made_by_{};
  std::vector<std::string> left_out_{};
  std::vector<ExportColumn> columns_{};
  std::string file_{};
  std::optional<TableFile> table_{};
};

}  // namespace asperity
