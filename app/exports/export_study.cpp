// Walks through the study once in the order of its keys, and adds each row to every table and dataset.

#include "app/exports/export_study.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/exports/codebook_file.h"
#include "app/exports/columns/export_tables.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/export_readme.h"
#include "app/exports/exported_participants.h"
#include "app/exports/group_files.h"
#include "app/exports/import_scripts.h"
#include "app/exports/publication.h"
#include "app/exports/sidecar.h"
#include "app/exports/stimulus_table.h"
#include "app/findings/study/participant_results.h"
#include "app/records/eye_mask.h"
#include "app/records/session_conditions.h"
#include "app/records/session_timeline.h"
#include "app/study_files/study_condition.h"
#include "app/words/text_parts.h"
#include "protocols/design/protocol.h"
#include "results_schema/stored_json.h"
#include "results_schema/tables/name_forms.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

// One of the tables with all rows of the study.
struct GrowingTable {
  std::string name{};
  std::vector<std::string> left_out{};
  std::vector<ExportColumn> columns{};
  TableFile file;
};

void sort_responses(std::vector<ResponseRow>& responses) {
  std::sort(responses.begin(), responses.end(), [](const ResponseRow& a, const ResponseRow& b) {
    return std::pair(a.question, a.item) < std::pair(b.question, b.item);
  });
}

// Parsed JSON texts, of which a study has few different ones.
class ReadJson final {
 public:
  // Valid until the next call.
  const nlohmann::json& of(const std::string& text, const char* column) {
    auto found = known_.find(text);
    if (found == known_.end()) {
      nlohmann::json read = stored_json(text, column);
      if (known_.size() == kMost) known_.clear();
      found = known_.emplace(text, std::move(read)).first;
    }
    return found->second;
  }

 private:
  static constexpr std::size_t kMost =
      1000;  // if all texts differ, keeping them would fill the memory
  std::unordered_map<std::string, nlohmann::json> known_{};
};

std::vector<std::string> questionnaire_of(const StudyVocabulary& vocabulary) {
  std::vector<std::string> names{};
  for (const auto& [name, question] : vocabulary.questions) {
    if (question.questionnaire) names.push_back(name);
  }
  return names;
}

// Refuses names that cannot be published, so that a misspelt name does not lead to an omitted question.
void refuse_questions(const StudyVocabulary& vocabulary) {
  const std::vector<std::string> asked = questionnaire_of(vocabulary);
  std::string possible{};
  for (const std::string& name : asked) {
    if (!vocabulary.questions.at(name).free_text) {
      possible += (possible.empty() ? "" : ", ") + name;
    }
  }
  for (const std::string& name : vocabulary.for_public) {
    const bool is_asked = std::find(asked.begin(), asked.end(), name) != asked.end();
    if (is_asked && vocabulary.is_published(name)) {
      // Whether a question was asked reveals the answer that it depends on.
      const std::string& earlier = vocabulary.questions.at(name).asked_after;
      if (earlier.empty() || vocabulary.is_published(earlier)) continue;
      throw std::invalid_argument(
          "answers to \"" + name + "\" cannot be published without those to \"" + earlier +
          "\": it is asked " + vocabulary.questions.at(name).condition +
          ", so that they reveal these answers; publish both, or leave both out");
    }
    throw std::invalid_argument(
        "answers to \"" + name + "\" cannot be published: " +
        (is_asked ? "they are free text" : "no questionnaire of the study contains this question") +
        (possible.empty() ? "; leave it out"
                          : "; choose from those that can be published: " + possible));
  }
}

// Walks through a study in the order of its keys, and adds the rows to all tables and files.
class StudyExport final {
 public:
  StudyExport(const Study& study, const ModelRegistry& models, ExportFolder& folder,
              const ExportOptions& options, const ParticipantResults& results)
      : study_(study),
        results_(results),
        folder_(folder),
        options_(options),
        participants_(exported_participants(study, options)),
        vocabulary_(vocabulary_of(study, models)),
        study_name_(study.name()),
        metadata_(study.metadata()),
        stimuli_(folder, study.folder(), options.formats.contains(ExportFormat::stimuli)) {
    vocabulary_.for_public = options_.questions_for_public;
    if (options.has_age_bands) vocabulary_.age_bands = age_bands_of(participants_);
    for (ExportFile& file : export_files(vocabulary_)) {
      std::vector<std::string> left_out{};
      std::vector<ExportColumn> columns =
          columns_for(options.audience, std::move(file.columns), left_out);
      const std::string name = file.name + ".tsv";
      TableFile table(folder.path_of(name), TableFile::Format::tsv, column_names(columns));
      codebook_.add(name, columns);
      if (file.name == "responses" && is_public(options.audience)) {
        for (const std::string& question : questionnaire_of(vocabulary_)) {
          if (!vocabulary_.is_published(question)) {
            left_out.push_back(left_out_answers_to(question));
          }
        }
      }
      tables_.push_back({file.name, std::move(left_out), std::move(columns), std::move(table)});
    }
  }

  // False if it was stopped.
  bool walk(const std::stop_token& stop, const std::function<void(double)>& progress) {
    for (const ProtocolRow& protocol : study_.protocols()) protocols_[protocol.id] = protocol;
    std::size_t sessions = 0;
    for (const ExportedParticipant& participant : participants_) {
      sessions += participant.sessions.size();
    }
    std::size_t done = 0;
    for (const ExportedParticipant& participant : participants_) {
      std::string mode{};
      std::string groups{};
      std::string languages{};
      std::set<std::string> languages_met{};
      std::set<std::pair<std::string, std::string>> groups_met{};
      for (const SessionRow& session : participant.sessions) {
        const std::string& language =
            vocabulary_.languages.at(protocols_.at(session.protocol_id).source_sha256);
        if (languages_met.insert(language).second) {
          languages += (languages.empty() ? "" : "; ") + language;
        }
        if (session.group_level &&
            groups_met.insert({protocols_.at(session.protocol_id).name, *session.group_level})
                .second) {
          groups += (groups.empty() ? "" : "; ") + *session.group_level;
        }
        const std::string word = text_of(session.mode);
        mode = mode.empty() || mode == word ? word : "mixed";
      }
      const nlohmann::json answers =
          stored_json(participant.listed.answers_json, "participant.answers_json");
      ExportPlace at{};
      at.participant = &participant.listed;
      at.participant_mode = &mode;
      at.participant_groups = &groups;
      at.participant_languages = &languages;
      at.answers = &answers;
      add("participants", at);
      std::set<SessionGroup> begun{};
      for (const SessionRow& session : participant.sessions) {
        if (stop.stop_requested()) return false;
        if (progress) progress(static_cast<double>(done++) / static_cast<double>(sessions));
        const SessionGroup group = session_group_of(participant.listed, session);
        if (begun.insert(group).second) files_of(group).begin_participant(at);
        ExportPlace here = at;
        here.session = &session;
        here.protocol = &protocols_.at(session.protocol_id);
        add_session(here, participant.stored, files_of(group));
      }
    }
    return !stop.stop_requested();
  }

  // What a public export contains of the tables, whose columns depend on the study.
  std::string publication() const {
    constexpr std::size_t kColumns = 120;
    std::string text = publication_text(export_files(vocabulary_), options_.audience);
    if (options_.audience == ExportAudience::relabelled) text += versions_text(participants_);
    return wrapped_text(text + identifying_text(options_), kColumns);
  }

  // Warnings of labels that could be those of one participant.
  std::vector<Phrase> alike_labels() const {
    std::vector<Phrase> warnings{};
    std::map<std::string, std::string> of_form{};
    for (const ExportedParticipant& participant : participants_) {
      const std::string& label = participant.listed.label;
      const auto [first, is_new] = of_form.emplace(label_form(label), label);
      if (is_new) continue;
      warnings.push_back(
          phrase("StudyExport",
                 "The labels %1 and %2 differ only in letter case or leading zeros: some programs "
                 "and file systems take them for one. If they are of one participant, state this "
                 "where the data are used.")
              .with(first->second, label));
    }
    return warnings;
  }

  // Completes all files. The outcome receives what could not be exported.
  void finish(ExportOutcome& outcome) {
    for (GrowingTable& table : tables_) {
      folder_.add(table.name + ".tsv", table.file.finish(), table.left_out);
    }
    for (auto& [group, files] : groups_) {
      files->finish(codebook_, outcome.not_written);
    }
    if (groups_.empty() && !options_.formats.empty()) {
      outcome.not_written.push_back(
          phrase("StudyExport",
                 "The study has no sessions, so that there are no files for other programs; run a "
                 "session, then export again."));
    }
    outcome.warnings = stimuli_.finish();
    codebook_.add("stimuli.tsv", StimulusTable::columns());
    codebook_.write(folder_);
    write_event_sidecar();
  }

 private:
  // The codebook contains the names of the kinds of events; their descriptions do not fit into a cell.
  void write_event_sidecar() {
    nlohmann::ordered_json sidecar{};
    for (const GrowingTable& table : tables_) {
      if (table.name != "events") continue;
      for (const ExportColumn& column : table.columns) sidecar[column.name] = sidecar_of(column);
    }
    folder_.write("events.json", indented_text(sidecar));
  }

  GroupFiles& files_of(SessionGroup group) {
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

  // `stored`: the participant under the label of the study.
  void add_session(ExportPlace at, const ParticipantRow& stored, GroupFiles& files) {
    const ParticipantResult result = results_.of(stored, *at.session, *at.protocol);
    at.is_excluded_by_catch = result.is_excluded_by_catch;
    add("sessions", at);
    stimuli_.begin_session(at);
    std::vector<AttemptRow> attempts = study_.attempts(at.session->id);
    const std::vector<PlannedTrialRow> plan = study_.plan(at.session->id);
    const std::vector<EventRow> events = study_.events(at.session->id);
    const std::vector<TimedEvent> timeline = session_timeline(events, attempts);
    const std::vector<RecordedStretch> stretches =
        recorded_stretches(*at.session, events, attempts);
    const EyeMask eye_mask(timeline);
    at.stretches = &stretches;
    at.eye_mask = &eye_mask;
    files.begin_session(at, plan, attempts, timeline);
    std::vector<ResponseRow> answers = study_.session_answers(at.session->id);
    sort_responses(answers);
    std::string withheld{};
    for (const ResponseRow& answer : answers) {
      ExportPlace here = at;
      here.response = &answer;
      here.response_is_withheld = !vocabulary_.is_published(answer.question);
      // The number of rows would state how many options were chosen.
      const bool is_hidden = is_public(options_.audience) && here.response_is_withheld;
      if (is_hidden && std::exchange(withheld, answer.question) == answer.question) continue;
      add("responses", here);
      files.add_session_answer(here);
    }
    at.own_scale = result.own_scale;
    std::map<int, std::vector<AttemptRow*>> attempts_by_trial{};
    for (AttemptRow& attempt : attempts) attempts_by_trial[attempt.trial].push_back(&attempt);
    std::map<int, const PlannedTrialRow*> trials{};
    for (const PlannedTrialRow& trial : plan) {
      trials[trial.trial] = &trial;
      at.trial = &trial;
      at.factors = &factors_.of(trial.factors_json, "trial.factors_json");
      const nlohmann::json planned = stored_json(trial.plan_json, "trial.plan_json");
      at.plan = &planned;
      at.attempts_of_trial = attempts_by_trial[trial.trial].size();
      add("trials", at);
      for (AttemptRow* attempt : attempts_by_trial[trial.trial]) add_attempt(at, *attempt, files);
    }
    at.plan = nullptr;
    for (const TimedEvent& event : timeline) {
      at.event = &event;
      at.attempt = event.attempt;
      at.trial = event.attempt == nullptr ? nullptr : trials[event.attempt->trial];
      add("events", at);
    }
    files.end_session();
  }

  // The first estimate of an attempt whose magnitude was re-elicited.
  static std::optional<double> doubted_in(const AttemptRow& attempt) {
    for (const EventRow& event : attempt.events) {
      if (event.kind != "estimate_doubted") continue;
      return stored_json(event.data_json, "event.data_json").at("estimate").get<double>();
    }
    return {};
  }

  void add_attempt(ExportPlace at, AttemptRow& attempt, GroupFiles& files) {
    at.attempt = &attempt;
    at.doubted_estimate = doubted_in(attempt);
    add("attempts", at);
    for (const PresentationRow& presentation : attempt.presentations) {
      ExportPlace here = at;
      here.presentation = &presentation;
      here.parameters =
          &parameters_.of(presentation.parameters_json, "presentation.parameters_json");
      add("presentations", here);
      stimuli_.add(here);
      for (const VisitRow& visit : presentation.visits) {
        here.visit = &visit;
        ++here.visit_number;
        add("visits", here);
      }
    }
    files.begin_attempt(study_, at);
    sort_responses(attempt.responses);
    for (const ResponseRow& response : attempt.responses) {
      ExportPlace here = at;
      here.response = &response;
      here.response_is_withheld = vocabulary_.is_free_text(response.question);
      if (vocabulary_.has_no_own_scale(response.question)) here.own_scale.reset();
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
  const ParticipantResults& results_;
  ExportFolder& folder_;
  ExportOptions options_;
  std::vector<ExportedParticipant> participants_;
  StudyVocabulary vocabulary_;
  std::string study_name_;
  StudyMetadata metadata_;
  std::map<std::int64_t, ProtocolRow> protocols_{};
  StimulusTable stimuli_;
  std::vector<GrowingTable> tables_{};
  std::map<SessionGroup, std::unique_ptr<GroupFiles>> groups_{};
  CodebookFile codebook_{};
  ReadJson factors_{};
  ReadJson parameters_{};
  std::vector<Cell> row_{};
};

}  // namespace

void refuse_export(const Study& study, const fs::path& folder, const ExportOptions& options) {
  if (options.has_age_bands && !is_public(options.audience)) {
    throw std::invalid_argument("has_age_bands applies to public exports only");
  }
  refuse_target(folder, options.overwrite);
  if (options.questions_for_public.empty()) return;
  StudyVocabulary vocabulary = vocabulary_of_protocols(study);
  vocabulary.for_public = options.questions_for_public;
  refuse_questions(vocabulary);
}

ExportOutcome export_study(const Study& study, const ModelRegistry& models, const fs::path& folder,
                           const ExportOptions& options, const std::stop_token& stop,
                           const std::function<void(double)>& progress) {
  refuse_export(study, folder, options);
  std::optional<ExportFolder> making(std::in_place, folder, options.overwrite);
  bool has_begun = false;
  bool stopped = false;
  ExportOutcome outcome{};
  std::string publication{};
  std::vector<Phrase> alike{};
  // All of one moment: what was written is discarded where the study has changed under it.
  const auto export_one_moment = [&] {
    if (std::exchange(has_begun, true)) making.emplace(folder, options.overwrite);
    outcome = {};
    const ParticipantResults results(study, stop);
    stopped = stop.stop_requested();
    if (stopped) return;
    StudyExport walk(study, models, *making, options, results);
    stopped = !walk.walk(stop, progress);
    if (stopped) return;
    walk.finish(outcome);
    alike = walk.alike_labels();
    publication = walk.publication();
  };
  name_target_in_errors(making, [&] {
    read_unless_broken(
        study, [&] { study.read_at_one_moment(export_one_moment); }, stop);
    if (stopped) return;
    making->write("README.txt",
                  export_readme(options, remark_on(study), outcome.warnings, publication));
    // README.txt states what is missing, and nothing is here.
    outcome.warnings.insert(outcome.warnings.end(), alike.begin(), alike.end());
    making->write("import.R", import_script_for_r());
    making->write("import.py", import_script_for_python());
    outcome.files = making->take_place();
  });
  if (stopped) return {};
  if (progress) progress(1.0);
  return outcome;
}

}  // namespace asperity
