// A walk through a study in the order of its keys, past everything that is written of it.

#include "app/exports/export_study.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/bids.h"
#include "app/exports/columns/codebook.h"
#include "app/exports/columns/export_tables.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/fit_table.h"
#include "app/exports/import_scripts.h"
#include "app/exports/psych_ds.h"
#include "app/exports/publication.h"
#include "app/exports/sav_table.h"
#include "app/exports/sidecar.h"
#include "app/exports/stimulus_table.h"
#include "app/exports/wide_table.h"
#include "app/findings/study/own_scales.h"
#include "app/records/session_timeline.h"
#include "app/study_files/study_condition.h"
#include "app/words/text_parts.h"
#include "protocols/design/protocol.h"

namespace asperity {

namespace {

namespace fs = std::filesystem;

constexpr const char* kCodebook = "codebook.tsv";

/// What codebook.tsv and MANIFEST.tsv say of themselves.
std::vector<ExportColumn> columns_about_columns() {
  constexpr std::array<std::pair<const char*, const char*>, 11> kMeanings{
      {{"file", "file within the folder; * matches any text"},
       {"column", "name of the column"},
       {"description", "meaning of a cell"},
       {"type", "text, integer, number, boolean (1 or 0), utc_time or json"},
       {"unit", "unit, in SI notation; 1 for a dimensionless number"},
       {"levels", "possible values of a cell, separated by |"},
       {"minimum", "smallest declared or observed value"},
       {"maximum", "largest declared or observed value"},
       {"missing", "when a cell is missing"},
       {"publication", "how it appears in a public export"},
       {"source", "source of the description: the program, a force model, a place in a protocol"}}};
  std::vector<ExportColumn> columns{};
  for (const auto& [name, meaning] : kMeanings) {
    ExportColumn& column = columns.emplace_back();
    column.name = name;
    column.description = meaning;
    column.type = "text";
  }
  return columns;
}

std::vector<ExportColumn> manifest_columns() {
  std::vector<ExportColumn> columns(4);
  columns[0].name = "file";
  columns[0].description = "file within the folder";
  columns[0].type = "text";
  columns[1].name = "rows";
  columns[1].description = "rows of a table, without the names of the columns";
  columns[1].type = "integer";
  columns[1].missing = "the file is not a table";
  columns[2].name = "sha256";
  columns[2].description = "SHA-256 of the file";
  columns[2].type = "text";
  columns[3].name = "left_out";
  columns[3].description =
      "columns that a public export omits; answer(NAME): the answers to this question";
  columns[3].type = "text";
  columns[3].missing = "none";
  return columns;
}

/// Rows about columns, as the codebook has them.
class Codebook final {
 public:
  void add(const std::string& file, const std::vector<ExportColumn>& columns) {
    for (const ExportColumn& column : columns) rows_.push_back(codebook_row(file, column));
  }
  void write(ExportFolder& folder) {
    add(kCodebook, columns_about_columns());
    add("MANIFEST.tsv", manifest_columns());
    TableFile file(folder.path_of(kCodebook), TableFile::Format::tsv, codebook_columns());
    for (const std::vector<Cell>& row : rows_) file.add(row);
    folder.add(kCodebook, file.finish());
  }

 private:
  std::vector<std::vector<Cell>> rows_{};
};

/// One of the tables that hold everything.
struct GrowingTable {
  std::string name{};
  std::vector<std::string> left_out{};
  std::vector<ExportColumn> columns{};
  TableFile file;
};

enum class Group { run, pilot, virtual_people };

std::string folder_of(Group group) {
  switch (group) {
    case Group::run:
      return "";
    case Group::pilot:
      return "pilot/";
    case Group::virtual_people:
      return "virtual/";
  }
  return "";
}

/// Whoever gets one of these datasets alone, without the folder that it was in, is told by itself.
MadeBy made_by(Group group) {
  switch (group) {
    case Group::run:
      return {};
    case Group::pilot:
      return {" (pilot sessions)",
              "These are pilot sessions: they served to test the experiment and are not part of "
              "its data."};
    case Group::virtual_people:
      return {" (virtual participants)",
              "The participants are virtual: a program simulated all responses; there were no "
              "human participants."};
  }
  return {};
}

Group folder_group_of(const ParticipantRow& participant, const SessionRow& session) {
  if (participant.is_virtual || session.mode == SessionMode::simulate) return Group::virtual_people;
  return session.mode == SessionMode::pilot ? Group::pilot : Group::run;
}

/// What is written of the sessions of one group, in the formats that are wanted.
class GroupFiles final {
 public:
  GroupFiles(ExportFolder& folder, Group group, const std::string& study_name,
             const StudyMetadata& metadata, const StudyVocabulary& vocabulary,
             const ExportOptions& options)
      : folder_(folder), root_(folder_of(group)), title_(study_name), options_(options) {
    const auto wants = [&](ExportFormat format) { return options.formats.contains(format); };
    if (wants(ExportFormat::wide) || wants(ExportFormat::sav)) {
      wide_.emplace(vocabulary, options.audience);
    }
    if (wants(ExportFormat::fit)) fit_.emplace();
    columns_ = columns_for(options.audience, answered_trial_columns(vocabulary), left_out_);
    if (wants(ExportFormat::sav)) trials_.emplace(columns_, folder.path_of(""));
    recordings_ = wants(ExportFormat::physio) ? BidsDataset::Recordings::written
                                              : BidsDataset::Recordings::left_out;
    if (wants(ExportFormat::bids) || wants(ExportFormat::physio)) {
      bids_.emplace(folder, root_ + "bids/", study_name, metadata, vocabulary, options.audience,
                    recordings_, made_by(group));
    }
    if (wants(ExportFormat::psychds)) {
      psych_.emplace(folder, root_ + "psychds/", study_name, vocabulary, options.audience,
                     made_by(group));
    }
  }

  void begin_participant(const ExportPlace& at) {
    if (wide_) wide_->begin_participant(at);
    if (bids_) bids_->add_participant(at);
  }

  void begin_session(const ExportPlace& at, const std::vector<PlannedTrialRow>& plan,
                     const std::vector<AttemptRow>& attempts,
                     const std::vector<TimedEvent>& timeline) {
    if (wide_) wide_->begin_session(at);
    if (bids_) {
      bids_->begin_session(at);
      bids_->add_events(at, plan, attempts, timeline);
    }
    if (psych_) psych_->begin_session(at);
  }

  void end_session() {
    if (bids_) bids_->end_session();
    if (psych_) psych_->end_session();
  }

  void add_session_answer(const ExportPlace& at) {
    if (wide_) wide_->add_session_answer(at);
  }

  void begin_attempt(const Study& study, const ExportPlace& at) {
    if (bids_) bids_->add_attempt(study, at);
  }

  /// With a response, or without where the attempt has none.
  void add_row(const ExportPlace& at) {
    if (wide_ && at.response != nullptr) wide_->add_answer(at);
    if (fit_ && at.response != nullptr) fit_->add(at);
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

  void finish(const StudyVocabulary& vocabulary, Codebook& codebook,
              std::vector<Phrase>& not_written) {
    if (wide_) finish_wide(codebook);
    if (fit_) finish_fit(codebook, not_written);
    if (trials_) {
      const std::string name = root_ + "trials.sav";
      folder_.add(name, trials_->write(folder_.path_of(name), title_), left_out_);
      codebook.add(name, renamed(columns_, trials_->names()));
    }
    std::vector<std::string> ignored{};
    if (bids_) {
      bids_->finish();
      codebook.add(root_ + "bids/participants.tsv",
                   BidsDataset::participant_columns(vocabulary, options_.audience, ignored));
      codebook.add(root_ + "bids/sub-*/ses-*/beh/*_beh.tsv",
                   BidsDataset::beh_columns(vocabulary, options_.audience, recordings_, ignored));
      codebook.add(root_ + "bids/sub-*/ses-*/beh/*_events.tsv",
                   bids_event_columns(vocabulary, options_.audience, ignored));
    }
    if (psych_) {
      psych_->finish();
      codebook.add(root_ + "psychds/data/*_data.csv", columns_);
    }
  }

 private:
  static std::vector<ExportColumn> renamed(std::vector<ExportColumn> columns,
                                           const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].name = names[i];
    return columns;
  }

  void finish_fit(Codebook& codebook, std::vector<Phrase>& not_written) {
    const std::string name = root_ + "fit.tsv";
    if (const auto why = fit_->why_empty(name)) {
      not_written.push_back(*why);
      return;
    }
    fit_->write(folder_, name);
    codebook.add(name, FitTable::columns());
  }

  void finish_wide(Codebook& codebook) {
    const WideTable::Made made = wide_->make();
    if (options_.formats.contains(ExportFormat::wide)) {
      const std::string name = root_ + "wide.csv";
      TableFile file(folder_.path_of(name), TableFile::Format::csv, column_names(made.columns));
      for (const std::vector<Cell>& row : made.rows) file.add(row);
      folder_.add(name, file.finish(), made.left_out);
      codebook.add(name, made.columns);
    }
    if (options_.formats.contains(ExportFormat::sav)) {
      const std::string name = root_ + "wide.sav";
      SavTable file(made.columns, folder_.path_of(""));
      for (const std::vector<Cell>& row : made.rows) file.add(row);
      folder_.add(name, file.write(folder_.path_of(name), title_), made.left_out);
      codebook.add(name, renamed(made.columns, file.names()));
    }
  }

  ExportFolder& folder_;
  std::string root_{};
  std::string title_{};
  ExportOptions options_{};
  std::vector<ExportColumn> columns_{};
  std::vector<std::string> left_out_{};
  BidsDataset::Recordings recordings_ = BidsDataset::Recordings::left_out;
  std::optional<WideTable> wide_{};
  std::optional<FitTable> fit_{};
  std::optional<SavTable> trials_{};
  std::optional<BidsDataset> bids_{};
  std::optional<PsychDataset> psych_{};
};

void sort_responses(std::vector<ResponseRow>& responses) {
  std::sort(responses.begin(), responses.end(), [](const ResponseRow& a, const ResponseRow& b) {
    return std::pair(a.question, a.item) < std::pair(b.question, b.item);
  });
}

/// JSON texts, of which a study has few that differ and many that are equal, as what they say.
class ReadJson final {
 public:
  /// Holds until the next text.
  const nlohmann::json& of(const std::string& text) {
    auto found = known_.find(text);
    if (found == known_.end()) {
      nlohmann::json read = nlohmann::json::parse(text);
      if (known_.size() == kMost) known_.clear();
      found = known_.emplace(text, std::move(read)).first;
    }
    return found->second;
  }

 private:
  static constexpr std::size_t kMost =
      1000;  // where all differ, keeping them would fill the memory
  std::unordered_map<std::string, nlohmann::json> known_{};
};

class StudyExport final {
 public:
  StudyExport(const Study& study, const ModelRegistry& models, ExportFolder& folder,
              const ExportOptions& options, const OwnScales& own_scales)
      : study_(study),
        own_scales_(own_scales),
        folder_(folder),
        options_(options),
        vocabulary_(vocabulary_of(study, models)),
        study_name_(study.name()),
        metadata_(study.metadata()),
        stimuli_(folder, study.folder(), options.formats.contains(ExportFormat::stimuli)) {
    take_questions_for_public();
    for (ExportFile& file : export_files(vocabulary_)) {
      std::vector<std::string> left_out{};
      std::vector<ExportColumn> columns =
          columns_for(options.audience, std::move(file.columns), left_out);
      const std::string name = file.name + ".tsv";
      TableFile table(folder.path_of(name), TableFile::Format::tsv, column_names(columns));
      codebook_.add(name, columns);
      if (file.name == "responses" && options.audience == ExportAudience::published) {
        for (const std::string& question : questionnaire()) {
          if (!vocabulary_.is_published(question)) {
            left_out.push_back(left_out_answers_to(question));
          }
        }
      }
      tables_.push_back({file.name, std::move(left_out), std::move(columns), std::move(table)});
    }
  }

  /// False: it was asked to stop.
  bool walk(const std::stop_token& stop, const std::function<void(double)>& progress) {
    const std::vector<SessionRow> sessions = study_.sessions();
    std::map<std::string, std::vector<const SessionRow*>> sessions_of{};
    for (const SessionRow& session : sessions) sessions_of[session.participant].push_back(&session);
    for (const ProtocolRow& protocol : study_.protocols()) protocols_[protocol.id] = protocol;
    std::size_t done = 0;
    for (const ParticipantRow& participant : study_.participants()) {
      if (participant.withdrawn && options_.audience == ExportAudience::published) continue;
      const std::vector<const SessionRow*>& own = sessions_of[participant.label];
      std::string mode{};
      for (const SessionRow* session : own) {
        const std::string word = text_of(session->mode);
        mode = mode.empty() || mode == word ? word : "mixed";
      }
      const nlohmann::json answers = nlohmann::json::parse(participant.answers_json);
      ExportPlace at{};
      at.participant = &participant;
      at.participant_mode = &mode;
      at.answers = &answers;
      add("participants", at);
      std::set<Group> begun{};
      for (const SessionRow* session : own) {
        if (stop.stop_requested()) return false;
        if (progress) progress(static_cast<double>(done++) / static_cast<double>(sessions.size()));
        const Group group = folder_group_of(participant, *session);
        if (begun.insert(group).second) files_of(group).begin_participant(at);
        ExportPlace here = at;
        here.session = session;
        here.protocol = &protocols_.at(session->protocol_id);
        add_session(here, files_of(group));
      }
    }
    return !stop.stop_requested();
  }

  /// What the public gets of the tables, whose columns depend on the study.
  std::string publication() const {
    constexpr std::size_t kColumns = 120;
    return wrapped_text(publication_text(export_files(vocabulary_)), kColumns);
  }

  /// What could not be exported, and what there was nothing to write of.
  void finish(ExportOutcome& outcome) {
    for (GrowingTable& table : tables_) {
      folder_.add(table.name + ".tsv", table.file.finish(), table.left_out);
    }
    for (auto& [group, files] : groups_) {
      files->finish(vocabulary_, codebook_, outcome.not_written);
    }
    if (groups_.empty() && !options_.formats.empty()) {
      outcome.not_written.push_back(phrase(
          "StudyExport", "The study has no sessions: there are no files for other programs."));
    }
    outcome.warnings = stimuli_.finish();
    codebook_.add("stimuli.tsv", StimulusTable::columns());
    codebook_.write(folder_);
    write_event_sidecar();
  }

 private:
  /// The codebook has the names of the kinds of events; what each is would not fit into a cell.
  void write_event_sidecar() {
    nlohmann::ordered_json sidecar{};
    for (const GrowingTable& table : tables_) {
      if (table.name != "events") continue;
      for (const ExportColumn& column : table.columns) sidecar[column.name] = sidecar_of(column);
    }
    folder_.write("events.json", indented_text(sidecar));
  }

  std::vector<std::string> questionnaire() const {
    std::vector<std::string> names{};
    for (const auto& [name, question] : vocabulary_.questions) {
      if (question.questionnaire) names.push_back(name);
    }
    return names;
  }

  /// Refuses a name that stands for nothing that can be published, so that a misspelt one is not
  /// taken for consent to leave it out.
  void take_questions_for_public() {
    vocabulary_.for_public = options_.questions_for_public;
    const std::vector<std::string> asked = questionnaire();
    std::string possible{};
    for (const std::string& name : asked) {
      if (!vocabulary_.questions.at(name).free_text) {
        possible += (possible.empty() ? "" : ", ") + name;
      }
    }
    for (const std::string& name : vocabulary_.for_public) {
      const bool is_asked = std::find(asked.begin(), asked.end(), name) != asked.end();
      if (is_asked && vocabulary_.is_published(name)) continue;
      throw std::invalid_argument("answers to \"" + name + "\" cannot be published: " +
                                  (is_asked
                                       ? "they are free text"
                                       : "no questionnaire of the study contains this question") +
                                  (possible.empty() ? "" : "; those that can: " + possible));
    }
  }

  GroupFiles& files_of(Group group) {
    std::unique_ptr<GroupFiles>& files = groups_[group];
    if (!files) {
      files = std::make_unique<GroupFiles>(folder_, group, study_name_, metadata_, vocabulary_,
                                           options_);
    }
    return *files;
  }

  void add(std::string_view name, const ExportPlace& at) {
    for (GrowingTable& table : tables_) {
      if (table.name != name) continue;
      row_.clear();
      for (const ExportColumn& column : table.columns) {
        row_.push_back(cell_for(options_.audience, column, at));
      }
      table.file.add(row_);
    }
  }

  void add_session(ExportPlace at, GroupFiles& files) {
    add("sessions", at);
    stimuli_.begin_session(at);
    std::vector<AttemptRow> attempts = study_.attempts(at.session->id);
    const std::vector<PlannedTrialRow> plan = study_.plan(at.session->id);
    const std::vector<TimedEvent> timeline =
        session_timeline(study_.events(at.session->id), attempts);
    files.begin_session(at, plan, attempts, timeline);
    std::vector<ResponseRow> answers = study_.session_answers(at.session->id);
    sort_responses(answers);
    for (const ResponseRow& answer : answers) {
      ExportPlace here = at;
      here.response = &answer;
      here.response_is_withheld = !vocabulary_.is_published(answer.question);
      add("responses", here);
      files.add_session_answer(here);
    }
    own_scale_ = own_scales_.of(*at.participant, *at.session, *at.protocol);
    std::map<int, std::vector<AttemptRow*>> attempts_by_trial{};
    for (AttemptRow& attempt : attempts) attempts_by_trial[attempt.trial].push_back(&attempt);
    std::map<int, const PlannedTrialRow*> trials{};
    for (const PlannedTrialRow& trial : plan) {
      trials[trial.trial] = &trial;
      at.trial = &trial;
      at.factors = &factors_.of(trial.factors_json);
      add("trials", at);
      for (AttemptRow* attempt : attempts_by_trial[trial.trial]) add_attempt(at, *attempt, files);
    }
    for (const TimedEvent& event : timeline) {
      at.event = &event;
      at.attempt = event.attempt;
      at.trial = event.attempt == nullptr ? nullptr : trials[event.attempt->trial];
      add("events", at);
    }
    files.end_session();
  }

  /// The first number of an attempt that was asked for a second one.
  static std::optional<double> doubted_in(const AttemptRow& attempt) {
    for (const EventRow& event : attempt.events) {
      if (event.kind != "estimate_doubted") continue;
      return nlohmann::json::parse(event.data_json).at("estimate").get<double>();
    }
    return {};
  }

  void add_attempt(ExportPlace at, AttemptRow& attempt, GroupFiles& files) {
    at.attempt = &attempt;
    at.doubted_estimate = doubted_in(attempt);
    at.own_scale = own_scale_;
    add("attempts", at);
    for (const PresentationRow& presentation : attempt.presentations) {
      ExportPlace here = at;
      here.presentation = &presentation;
      here.parameters = &parameters_.of(presentation.parameters_json);
      add("presentations", here);
      stimuli_.add(here);
    }
    files.begin_attempt(study_, at);
    sort_responses(attempt.responses);
    for (const ResponseRow& response : attempt.responses) {
      ExportPlace here = at;
      here.response = &response;
      add("responses", here);
      files.add_row(here);
    }
    if (attempt.responses.empty()) files.add_row(at);
    if (attempt.servo) {
      ExportPlace here = at;
      here.servo = &*attempt.servo;
      add("servo_quality", here);
    }
    std::sort(attempt.compliance.begin(), attempt.compliance.end(),
              [](const ComplianceRow& a, const ComplianceRow& b) {
                return std::pair(a.position, a.quantity) < std::pair(b.position, b.quantity);
              });
    for (const ComplianceRow& compliance : attempt.compliance) {
      ExportPlace here = at;
      here.compliance = &compliance;
      add("compliance", here);
    }
  }

  const Study& study_;
  const OwnScales& own_scales_;
  std::optional<double> own_scale_{};  ///< of the session
  ExportFolder& folder_;
  ExportOptions options_;
  StudyVocabulary vocabulary_;
  std::string study_name_;
  StudyMetadata metadata_;
  std::map<std::int64_t, ProtocolRow> protocols_{};
  StimulusTable stimuli_;
  std::vector<GrowingTable> tables_{};
  std::map<Group, std::unique_ptr<GroupFiles>> groups_{};
  Codebook codebook_{};
  ReadJson factors_{};
  ReadJson parameters_{};
  std::vector<Cell> row_{};
};

/// For whoever finds the folder.
///
/// `publication` states what an export for the public has and lacks.
std::string readme(const ExportOptions& options, const std::optional<Phrase>& remark,
                   const std::vector<Phrase>& warnings, const std::string& publication) {
  std::string text = "A study, exported by Asperity for use in other programs.\n\n";
  if (remark) text += "BEFORE USE: " + remark->english() + "\n\n";
  for (const Phrase& warning : warnings) text += "INCOMPLETE: " + warning.english() + "\n\n";
  text +=
      "codebook.tsv describes every column of every file; MANIFEST.tsv contains the SHA-256 of "
      "every file; events.json describes each kind of event.\nimport.R and import.py load all "
      "tables with the correct types.\n\n";
  if (options.audience == ExportAudience::published) {
    std::string named{};
    for (const std::string& question : options.questions_for_public) {
      named += (named.empty() ? ", except for " : ", ") + question;
    }
    text += "This is a public export: without dates, free text and answers to questionnaires" +
            named + ". Participants who withdrew are not included.\n" + publication + "\n";
  }
  return text +
         "The .tsv files of this folder contain all data, including attempts that do not count, "
         "excluded ones, pilots and virtual\nparticipants; the columns virtual, mode, phase, "
         "valid, excluded and flagged state which, and counts_in_analyses\nof attempts.tsv states "
         "which attempts analyses include. All other files of this\nfolder contain only sessions "
         "of human participants. Pilots are in pilot/, virtual participants in virtual/. Rows that "
         "do not\ncount are marked there too, except in wide.csv and wide.sav, which include only "
         "responses that count.\n\nSpreadsheets: a text that begins with = + - @, a tab or a line "
         "break would be read as a formula. In every .tsv and .csv file such a\ntext is preceded "
         "by an apostrophe; the same applies to a text that begins with an apostrophe or is "
         "exactly "
         "n/a.\nRemove one apostrophe from every text that begins with one to restore the original "
         "texts; import.R and\nimport.py do this. Numbers are never changed. The .sav files "
         "contain the original texts.\nTabs and line breaks within a text are spaces in a .tsv "
         "file; the number of such cells was reported at the export.\n\nMissing values are n/a in "
         ".tsv files and empty in .csv files. Times in seconds are relative to the beginning of "
         "the session. Labels of\nparticipants and seeds are texts, even if they look like "
         "numbers.\n";
}

}  // namespace

const char* name_of(ExportFormat format) noexcept {
  switch (format) {
    case ExportFormat::wide:
      return "wide";
    case ExportFormat::sav:
      return "sav";
    case ExportFormat::bids:
      return "bids";
    case ExportFormat::psychds:
      return "psychds";
    case ExportFormat::physio:
      return "physio";
    case ExportFormat::stimuli:
      return "stimuli";
    case ExportFormat::fit:
      return "fit";
  }
  return "";
}

std::set<ExportFormat> usual_export_formats() {
  return {ExportFormat::wide,    ExportFormat::sav,     ExportFormat::bids,
          ExportFormat::psychds, ExportFormat::stimuli, ExportFormat::fit};
}

ExportOutcome export_study(const Study& study, const ModelRegistry& models, const fs::path& folder,
                           const ExportOptions& options, const std::stop_token& stop,
                           const std::function<void(double)>& progress) {
  ExportFolder making(folder, options.overwrite);
  const OwnScales own_scales(study, stop);
  if (stop.stop_requested()) return {};
  bool stopped = false;
  ExportOutcome outcome{};
  std::string publication{};
  read_unless_broken(
      study,
      [&] {
        StudyExport walk(study, models, making, options, own_scales);
        stopped = !walk.walk(stop, progress);
        if (stopped) return;
        walk.finish(outcome);
        publication = walk.publication();
      },
      stop);
  if (stopped) return {};
  making.write("README.txt", readme(options, remark_on(study), outcome.warnings, publication));
  making.write("import.R", import_script_for_r());
  making.write("import.py", import_script_for_python());
  outcome.files = making.take_place();
  return outcome;
}

}  // namespace asperity
