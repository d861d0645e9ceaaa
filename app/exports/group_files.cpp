// Passes rows to the datasets, the wide tables and the tables of counts of one group.

#include "app/exports/group_files.h"

#include <utility>

#include "app/exports/columns/export_tables.h"
#include "app/exports/made_by.h"
#include "results_schema/tables/table_file.h"

namespace asperity {
namespace {

std::string folder_of(SessionGroup group) {
  switch (group) {
    case SessionGroup::run:
      return "";
    case SessionGroup::pilot:
      return "pilot/";
    case SessionGroup::virtual_participants:
      return "virtual/";
  }
  return "";
}

// A dataset states its group itself, because it may be passed on without the folder that contains it.
MadeBy made_by(SessionGroup group) {
  switch (group) {
    case SessionGroup::run:
      return {};
    case SessionGroup::pilot:
      return {" (pilot sessions)",
              "These are pilot sessions: they served to test the experiment and are not part of "
              "its data."};
    case SessionGroup::virtual_participants:
      return {" (virtual participants)",
              "The participants are virtual: a program simulated all responses; there were no "
              "human participants."};
  }
  return {};
}

std::vector<ExportColumn> renamed(std::vector<ExportColumn> columns,
                                  const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].name = names[i];
  return columns;
}

}  // namespace

SessionGroup session_group_of(const ParticipantRow& participant, const SessionRow& session) {
  if (participant.is_virtual || session.mode == SessionMode::simulate)
    return SessionGroup::virtual_participants;
  return session.mode == SessionMode::pilot ? SessionGroup::pilot : SessionGroup::run;
}

GroupFiles::GroupFiles(ExportFolder& folder, SessionGroup group, const std::string& study_name,
                       const StudyMetadata& metadata, const StudyVocabulary& vocabulary,
                       const ExportOptions& options)
    : folder_(folder), root_(folder_of(group)), title_(study_name), options_(options) {
  const auto wants = [&](ExportFormat format) { return options.formats.contains(format); };
  if (wants(ExportFormat::wide) || wants(ExportFormat::sav)) {
    wide_.emplace(vocabulary, options.audience);
  }
  if (wants(ExportFormat::fit)) {
    fit_.emplace(vocabulary);
    detection_.emplace(vocabulary);
  }
  columns_ = columns_for(options.audience, answered_trial_columns(vocabulary), left_out_);
  if (wants(ExportFormat::sav)) trials_.emplace(columns_, folder.path_of(""));
  if (wants(ExportFormat::bids) || wants(ExportFormat::physio)) {
    bids_.emplace(folder, root_ + "bids/", study_name, metadata, vocabulary, options.audience,
                  wants(ExportFormat::physio) ? BidsDataset::Recordings::written
                                              : BidsDataset::Recordings::left_out,
                  made_by(group));
  }
  if (wants(ExportFormat::psychds)) {
    psych_.emplace(folder, root_ + "psychds/", study_name, vocabulary, options.audience,
                   made_by(group));
  }
}

void GroupFiles::begin_participant(const ExportPlace& at) {
  if (wide_) wide_->begin_participant(at);
  if (bids_) bids_->add_participant(at);
}

void GroupFiles::begin_session(const ExportPlace& at, const std::vector<PlannedTrialRow>& plan,
                               const std::vector<AttemptRow>& attempts,
                               const std::vector<TimedEvent>& timeline) {
  if (wide_) wide_->begin_session(at);
  if (bids_) {
    bids_->begin_session(at);
    bids_->add_events(at, plan, attempts, timeline);
  }
  if (psych_) psych_->begin_session(at);
}

void GroupFiles::end_session() {
  if (bids_) bids_->end_session();
  if (psych_) psych_->end_session();
}

void GroupFiles::add_session_answer(const ExportPlace& at) {
  if (wide_) wide_->add_session_answer(at);
}

void GroupFiles::begin_attempt(const Study& study, const ExportPlace& at) {
  if (bids_) bids_->add_attempt(study, at);
}

void GroupFiles::add_row(const ExportPlace& at) {
  if (wide_ && at.response != nullptr) wide_->add_answer(at);
  if (fit_ && at.response != nullptr) fit_->add(at);
  if (detection_ && at.response != nullptr) detection_->add(at);
  if (!bids_ && !psych_ && !trials_) return;
  std::vector<Cell> row{};
  row.reserve(columns_.size());
  for (const ExportColumn& column : columns_) {
    row.push_back(cell_for(options_.audience, column, at));
  }
  if (bids_) bids_->add_row(row);
  if (psych_) psych_->add_row(row);
  if (trials_) trials_->add(std::move(row));
}

void GroupFiles::finish(CodebookFile& codebook, std::vector<Phrase>& not_written) {
  if (wide_) finish_wide(codebook);
  if (fit_) finish_fit(codebook, not_written);
  if (detection_ && !detection_->is_empty()) {
    const std::string name = root_ + "detection.tsv";
    detection_->write(folder_, name);
    codebook.add(name, DetectionTable::columns());
  }
  if (trials_) {
    const std::string name = root_ + "trials.sav";
    folder_.add(name, trials_->write(folder_.path_of(name), title_), left_out_);
    codebook.add(name, renamed(columns_, trials_->names()));
  }
  if (bids_) bids_->finish(codebook);
  if (psych_) {
    psych_->finish();
    codebook.add(root_ + "psychds/data/*_data.csv", columns_);
  }
}

void GroupFiles::finish_fit(CodebookFile& codebook, std::vector<Phrase>& not_written) {
  const std::string name = root_ + "fit.tsv";
  if (const auto why = fit_->why_empty(name)) {
    not_written.push_back(*why);
    return;
  }
  fit_->write(folder_, name);
  codebook.add(name, fit_->columns());
}

void GroupFiles::finish_wide(CodebookFile& codebook) {
  const WideTable::Made made = wide_->make();
  const WideColumns& table = made.table;
  if (options_.formats.contains(ExportFormat::wide)) {
    const std::string name = root_ + "wide.csv";
    TableFile file(folder_.path_of(name), TableFile::Format::csv, column_names(table.columns));
    for (const std::vector<Cell>& row : table.rows) file.add(row);
    folder_.add(name, file.finish(), made.left_out);
    codebook.add(name, table.columns);
  }
  if (options_.formats.contains(ExportFormat::sav)) {
    const std::string name = root_ + "wide.sav";
    SavTable file(table.columns, folder_.path_of(""));
    for (const std::vector<Cell>& row : table.rows) file.add(row);
    folder_.add(name, file.write(folder_.path_of(name), title_), made.left_out);
    codebook.add(name, renamed(table.columns, file.names()));
  }
}

}  // namespace asperity
