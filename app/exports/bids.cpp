// Writes _beh, _events and physiological files with sidecars, and places recorded ticks in regular streams.

#include "app/exports/bids.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/bids_events.h"
#include "app/exports/columns/export_tables.h"
#include "app/exports/sidecar.h"
#include "app/records/attempt_detail.h"
#include "app/study_files/program.h"
#include "app/words/event_kinds.h"
#include "results_schema/recording.h"

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBidsVersion = "1.10.0";
constexpr const char* kResponseTime = "from_cue_s";

std::string two_digits(std::int64_t number) {
  const std::string digits = std::to_string(number);
  return digits.size() < 2 ? "0" + digits : digits;
}

/// Returns the row of a regular stream for each record, counted from the first record: the nearest
/// in time. Rows increase, and no record is omitted: where the nearest row is taken, the records
/// just before it move up by one if a free row is available and none of them is moved by a period
/// or more, which accommodates a late tick followed by one on time; otherwise the record takes the
/// next row, and the stream is in step again where a tick is missing.
std::vector<std::int64_t> stream_rows(const std::vector<std::int64_t>& time_ns, double rate_Hz) {
  std::vector<std::int64_t> rows{};
  rows.reserve(time_ns.size());
  std::size_t block = 0;  // the first record after the last free row
  bool may_move = false;  // every record of the block is earlier than the time of its row
  for (std::size_t i = 0; i < time_ns.size(); ++i) {
    const double exact = static_cast<double>(time_ns[i] - time_ns.front()) * 1e-9 * rate_Hz;
    const std::int64_t nearest = std::llround(exact);
    if (i == 0) {
      rows.push_back(0);
      continue;
    }
    if (nearest > rows.back() + 1) {
      block = i;
      may_move = true;
      rows.push_back(nearest);
    } else {
      if (nearest <= rows.back() && may_move) {
        for (std::size_t moved = block; moved < i; ++moved) --rows[moved];
        may_move = false;
      }
      rows.push_back(rows.back() + 1);
    }
    may_move = may_move && exact < static_cast<double>(rows.back());
  }
  return rows;
}

/// Those of an answered trial, `response_time` under its BIDS name, and `run`.
std::vector<ExportColumn> beh_columns(const StudyVocabulary& vocabulary, ExportAudience audience,
                                      BidsDataset::Recordings recordings,
                                      std::vector<std::string>& left_out) {
  std::vector<ExportColumn> columns =
      columns_for(audience, answered_trial_columns(vocabulary), left_out);
  ExportColumn time = *std::find_if(columns.begin(), columns.end(), [](const ExportColumn& each) {
    return each.name == kResponseTime;
  });
  time.name = "response_time";
  columns.push_back(std::move(time));
  if (recordings == BidsDataset::Recordings::left_out) return columns;
  ExportColumn run{};
  run.name = "run";
  run.type = "integer";
  run.description = "the run whose _physio.tsv.gz contains the ticks of this attempt";
  run.minimum = 1.0;
  run.missing = "no ticks were recorded in the attempt";
  columns.push_back(std::move(run));
  return columns;
}

std::vector<ExportColumn> participant_columns(const StudyVocabulary& vocabulary,
                                              ExportAudience audience,
                                              std::vector<std::string>& left_out) {
  std::vector<ExportColumn> columns =
      columns_for(audience, export_files(vocabulary).front().columns, left_out);
  ExportColumn& label = columns.front();
  label.name = "participant_id";
  label.description = "\"sub-\" and the label of the participant";
  label.cell = [](const ExportPlace& at) { return "sub-" + at.participant->label; };
  for (ExportColumn& column : columns) {
    if (column.name == "age_years") column.name = "age";
    if (column.name != "sex") continue;
    // BIDS 1.10 accepts only F, M and O: an X is an error of its validator.
    column.description = "reported sex";
    column.levels = {"F", "M", "O"};
    column.level_meanings = {
        {"F", {"female", ""}},
        {"M", {"male", ""}},
        {"O", {"neither female nor male: X in participants.tsv of the export", ""}}};
    column.cell = [told = std::move(column.cell)](const ExportPlace& at) -> Cell {
      const Cell cell = told(at);
      return cell == Cell{"X"} ? Cell{"O"} : cell;
    };
  }
  return columns;
}

}  // namespace

BidsDataset::BidsDataset(ExportFolder& folder, std::string root, const std::string& study_name,
                         const StudyMetadata& metadata, const StudyVocabulary& vocabulary,
                         ExportAudience audience, Recordings recordings, const MadeBy& made_by)
    : folder_(folder),
      root_(std::move(root)),
      study_name_(study_name),
      metadata_(metadata),
      made_by_(made_by),
      vocabulary_(vocabulary),
      audience_(audience),
      recordings_(recordings),
      columns_(beh_columns(vocabulary, audience, recordings, left_out_)),
      event_columns_(bids_event_columns(vocabulary, audience, events_left_out_)),
      participant_columns_(participant_columns(vocabulary, audience, participants_left_out_)) {
  const auto time = std::find_if(columns_.begin(), columns_.end(), [](const ExportColumn& column) {
    return column.name == kResponseTime;
  });
  response_time_ = static_cast<std::size_t>(time - columns_.begin());
}

std::string BidsDataset::task_of(const std::string& protocol) {
  const auto known = tasks_.find(protocol);
  if (known != tasks_.end()) return known->second;
  std::string label{};
  for (const char letter : protocol) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) label += letter;
  }
  if (label.empty()) label = "task";
  const auto is_taken = [this](const std::string& candidate) {
    return std::any_of(tasks_.begin(), tasks_.end(),
                       [&](const auto& task) { return task.second == candidate; });
  };
  std::string free = label;
  for (int number = 2; is_taken(free); ++number) free = label + std::to_string(number);
  return tasks_[protocol] = free;
}

void BidsDataset::add_participant(const ExportPlace& at) {
  std::vector<Cell>& row = participants_.emplace_back();
  for (const ExportColumn& column : participant_columns_) {
    row.push_back(cell_for(audience_, column, at));
  }
}

void BidsDataset::begin_session(const ExportPlace& at) {
  participant_ = "sub-" + at.participant->label;
  const std::string session = "ses-" + two_digits(at.session->session);
  start_ = root_ + participant_ + "/" + session + "/beh/" + participant_ + "_" + session +
           "_task-" + task_of(at.protocol->name);
  sessions_[participant_].insert(session);
  task_name_ = at.protocol->name;
  last_ended_utc_ = std::max(last_ended_utc_, at.session->ended_utc.value_or(""));
  run_ = 0;
  const std::string name = start_ + "_beh.tsv";
  note_file(name);
  beh_.emplace(folder_.path_of(name), TableFile::Format::tsv, column_names(columns_));
  Json sidecar{{"TaskName", task_name_}};
  if (const std::string& title = vocabulary_.titles.at(at.protocol->source_sha256);
      !title.empty()) {
    sidecar["TaskDescription"] = title;
  }
  sidecar.update(session_sidecar(at, columns_));
  folder_.write(start_ + "_beh.json", indented_text(sidecar));
}

Json BidsDataset::session_sidecar(const ExportPlace& at,
                                  const std::vector<ExportColumn>& columns) const {
  Json sidecar{};
  // The release of a kernel can identify a machine; the system's name does not.
  const std::string& os = at.session->os;
  Json& presentation = sidecar["StimulusPresentation"];
  presentation["OperatingSystem"] = is_public(audience_) ? os.substr(0, os.find(' ')) : os;
  presentation["SoftwareName"] = "Asperity";
  if (audience_ != ExportAudience::relabelled) {
    presentation["SoftwareVersion"] = at.session->program_version;
  }
  const StoredProtocol::Senses& senses = vocabulary_.senses.at(at.protocol->source_sha256);
  if (senses.vision && senses.noise) {
    // An object: BIDS takes every other member of the sidecar of events for a column.
    Json& environment = sidecar["Environment"];
    environment["Description"] =
        "what the participant was to see and hear, as the protocol requests; what was recorded is "
        "in eye_mask_confirmed and masking_noise_source of _beh.tsv";
    environment["Vision"] = text_of(*senses.vision);
    environment["MaskingNoise"] = text_of(senses.noise->kind);
    if (const auto level = senses.noise->level_dBA) environment["MaskingNoiseLevel_dBA"] = *level;
  }
  for (const ExportColumn& column : columns) sidecar[column.name] = sidecar_of(column);
  return sidecar;
}

void BidsDataset::add_events(const ExportPlace& at, const std::vector<PlannedTrialRow>& plan,
                             const std::vector<AttemptRow>& attempts,
                             const std::vector<TimedEvent>& timeline) {
  const std::string name = start_ + "_events.tsv";
  TableFile file(folder_.path_of(name), TableFile::Format::tsv, column_names(event_columns_));
  for (const std::vector<Cell>& row :
       bids_event_rows(event_columns_, audience_, at, plan, attempts, timeline)) {
    file.add(row);
  }
  folder_.add(name, file.finish(), events_left_out_);
  folder_.write(start_ + "_events.json", indented_text(session_sidecar(at, event_columns_)));
}

void BidsDataset::add_attempt(const Study& study, const ExportPlace& at) {
  attempt_is_recorded_ = recordings_ == Recordings::written && at.attempt->recording.has_value();
  if (!attempt_is_recorded_) return;
  ++run_;
  const Recording recording = recording_of(study.folder(), *at.attempt->recording);
  const std::string name = start_ + "_run-" + two_digits(run_) + "_recording-haptic_physio";
  std::vector<std::string> columns{"time_s"};
  Json described_columns{};
  described_columns["time_s"] =
      Json{{"Description", "time of the tick since the session began"}, {"Units", "s"}};
  for (const RecordingColumn& column : recording.header.columns) {
    columns.push_back(column.name);
    described_columns[column.name] =
        Json{{"Description", column.meaning}, {"Units", bids_unit(column.unit)}};
  }
  note_file(name);
  TableFile file(folder_.path_of(name + ".tsv.gz"), TableFile::Format::bare_tsv_gz, columns);
  const double rate_Hz = recording.header.rate_Hz;
  const auto seconds = [&at](std::int64_t time_ns) {
    return static_cast<double>(time_ns - at.session->clock_zero_ns) / 1e9;
  };
  std::vector<float> row(recording.columns.size());
  const std::vector<Cell> gap(columns.size());
  const std::vector<std::int64_t> rows = stream_rows(recording.time_ns, rate_Hz);
  std::int64_t next_row = 0;
  for (std::size_t i = 0; i < recording.time_ns.size(); ++i) {
    for (; next_row < rows[i]; ++next_row) file.add(gap);
    ++next_row;
    for (std::size_t column = 0; column < recording.columns.size(); ++column) {
      row[column] = recording.columns[column][i];
    }
    file.add(seconds(recording.time_ns[i]), row);
  }
  folder_.add(name + ".tsv.gz", file.finish());
  Json sidecar{};
  sidecar["SamplingFrequency"] = rate_Hz;
  sidecar["StartTime"] = recording.time_ns.empty() ? 0.0 : seconds(recording.time_ns.front());
  sidecar["Columns"] = columns;
  sidecar["TaskName"] = task_name_;
  sidecar["Manufacturer"] = at.session->device;
  for (const auto& [column, description] : described_columns.items()) {
    sidecar[column] = description;
  }
  folder_.write(name + ".json", indented_text(sidecar));
}

void BidsDataset::add_row(const std::vector<Cell>& row) {
  std::vector<Cell> cells = row;
  cells.push_back(row[response_time_]);
  if (recordings_ == Recordings::written) {
    cells.push_back(attempt_is_recorded_ ? Cell{run_} : Cell{});
  }
  beh_->add(cells);
}

void BidsDataset::end_session() {
  folder_.add(start_ + "_beh.tsv", beh_->finish(), left_out_);
  beh_.reset();
}

void BidsDataset::finish(CodebookFile& codebook) {
  TableFile participants(folder_.path_of(root_ + "participants.tsv"), TableFile::Format::tsv,
                         column_names(participant_columns_));
  Json sidecar{};
  for (const ExportColumn& column : participant_columns_) {
    sidecar[column.name] = sidecar_of(column);
  }
  for (const std::vector<Cell>& row : participants_) participants.add(row);
  folder_.add(root_ + "participants.tsv", participants.finish(), participants_left_out_);
  folder_.write(root_ + "participants.json", indented_text(sidecar));
  folder_.write(root_ + "dataset_description.json", indented_text(description()));
  folder_.write(root_ + "README", readme());
  folder_.write(root_ + "CHANGES", changes());
  if (const std::vector<std::string> ignored = intended(); !ignored.empty()) {
    folder_.write(root_ + ".bids-validator-config.json", indented_text(Json{{"ignore", ignored}}));
  }
  codebook.add(root_ + "participants.tsv", participant_columns_);
  codebook.add(root_ + "sub-*/ses-*/beh/*_beh.tsv", columns_);
  codebook.add(root_ + "sub-*/ses-*/beh/*_events.tsv", event_columns_);
}

void BidsDataset::note_file(const std::string& name) {
  files_[participant_].insert(name.substr(name.rfind('/') + 1 + participant_.size()));
}

std::vector<std::string> BidsDataset::intended() const {
  const auto differ = [](const std::map<std::string, std::set<std::string>>& by_participant) {
    return std::any_of(by_participant.begin(), by_participant.end(), [&](const auto& participant) {
      return participant.second != by_participant.begin()->second;
    });
  };
  std::vector<std::string> ignored{};
  if (differ(files_)) ignored.emplace_back("INCONSISTENT_SUBJECTS");
  if (differ(sessions_)) ignored.emplace_back("MISSING_SESSION");
  if (metadata_.authors.size() == 1) ignored.emplace_back("TOO_FEW_AUTHORS");
  return ignored;
}

Json BidsDataset::description() const {
  Json description{};
  description["Name"] = study_name_ + made_by_.in_title;
  description["BIDSVersion"] = kBidsVersion;
  description["HEDVersion"] = kHedVersion;
  description["DatasetType"] = "raw";
  if (metadata_.license) description["License"] = *metadata_.license;
  if (!metadata_.authors.empty()) description["Authors"] = metadata_.authors;
  if (metadata_.ethics_approval) {
    description["EthicsApprovals"] = Json::array({*metadata_.ethics_approval});
  }
  description["GeneratedBy"] =
      Json::array({Json{{"Name", "Asperity"}, {"Version", this_program().version}}});
  return description;
}

std::string BidsDataset::readme() const {
  std::string text = study_name_ + made_by_.in_title + "\n\n";
  if (!made_by_.sentence.empty()) text += made_by_.sentence + "\n\n";
  std::string authors{};
  for (const std::string& author : metadata_.authors) {
    authors += (authors.empty() ? "" : "; ") + author;
  }
  if (!authors.empty()) text += "Authors: " + authors + "\n";
  if (metadata_.license) text += "License: " + *metadata_.license + "\n";
  if (metadata_.ethics_approval) text += "Ethics approval: " + *metadata_.ethics_approval + "\n";
  if (!authors.empty() || metadata_.license || metadata_.ethics_approval) text += "\n";
  return text +
         "Responses to haptic textures by session (_beh.tsv), and presentations and events "
         "(_events.tsv), with the meanings of their columns in the .json files next to them. "
         "Onsets are relative to the beginning of the session.\n\nAnalyses include the rows of "
         "_beh.tsv with counts_in_analyses 1; rows with flagged 1 should be inspected.\nA text "
         "that a "
         "spreadsheet would read as a formula is preceded by an apostrophe; the same applies to a "
         "text that begins with an apostrophe. Remove one apostrophe to restore the text.\n";
}

/// In the format of CPAN changelogs, which BIDS requires. Dates are not published.
std::string BidsDataset::changes() const {
  const bool is_dated = audience_ == ExportAudience::own && !last_ended_utc_.empty();
  return "1.0.0" + (is_dated ? " " + last_ended_utc_.substr(0, 10) : "") +
         "\n  - Exported by Asperity " + this_program().version + ".\n";
}

}  // namespace asperity
