// A walk through a study in the order of its keys, and a folder that appears whole.

#include "app/tasks/export_study.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "results_schema/sha256.h"

namespace asperity {

namespace {

namespace fs = std::filesystem;

constexpr const char* kCodebook = "codebook.tsv";
constexpr const char* kManifest = "MANIFEST.tsv";

/// What a protocol says of the factors and questions that its rows use.
void learn_from_protocol(const ProtocolRow& protocol, StudyVocabulary& vocabulary) {
  const nlohmann::json source = nlohmann::json::parse(protocol.source, nullptr, false);
  if (!source.is_object()) return;
  const auto text = [](const nlohmann::json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const nlohmann::json factors = source.value("factors", nlohmann::json::object());
  for (const auto& [name, declaration] : factors.items()) {
    const auto factor = vocabulary.factors.find(name);
    if (factor == vocabulary.factors.end() || !declaration.is_object()) continue;
    factor->second.meaning = text(declaration, "meaning");
    factor->second.unit = text(declaration, "unit");
  }
  const nlohmann::json questions = source.value("questions", nlohmann::json::object());
  for (const auto& [name, declaration] : questions.items()) {
    if (!declaration.is_object()) continue;
    const bool free_text = text(declaration, "form") == "text";
    const auto [question, is_new] =
        vocabulary.questions.insert({name, {text(declaration, "prompt"), free_text}});
    if (!is_new && free_text) question->second.free_text = true;
  }
}

void learn_factors(const PlannedTrialRow& trial, StudyVocabulary& vocabulary) {
  const nlohmann::json factors = nlohmann::json::parse(trial.factors_json);
  for (const auto& [name, level] : factors.items()) {
    StudyVocabulary::FactorMeaning& factor = vocabulary.factors[name];
    if (!level.is_number()) factor.numeric = false;
    std::string word = level.is_string() ? level.get<std::string>() : level.dump();
    if (level.is_number_float()) word = text_of_number(level.get<double>());
    if (std::find(factor.levels.begin(), factor.levels.end(), word) == factor.levels.end()) {
      factor.levels.push_back(std::move(word));
    }
  }
}

void sort_levels(StudyVocabulary::FactorMeaning& factor) {
  std::sort(factor.levels.begin(), factor.levels.end(),
            [&factor](const std::string& a, const std::string& b) {
              if (!factor.numeric) return a < b;
              return number_in(a).value_or(0.0) < number_in(b).value_or(0.0);
            });
}

StudyVocabulary vocabulary_of(const Study& study, const std::vector<SessionRow>& sessions,
                              const std::stop_token& stop) {
  StudyVocabulary vocabulary{};
  for (const SessionRow& session : sessions) {
    if (stop.stop_requested()) break;
    for (const PlannedTrialRow& trial : study.plan(session.id)) learn_factors(trial, vocabulary);
    for (const AttemptRow& attempt : study.attempts(session.id)) {
      for (const PresentationRow& presentation : attempt.presentations) {
        const nlohmann::json parameters = nlohmann::json::parse(presentation.parameters_json);
        for (const auto& [name, value] : parameters.items()) {
          StudyVocabulary::ParameterMeaning& parameter = vocabulary.parameters[name];
          parameter.models.insert(presentation.model);
          if (value.is_string()) parameter.levels.insert(value.get<std::string>());
        }
        for (const ModelLimitRow& limit : presentation.limits) {
          vocabulary.limits[limit.kind].insert(presentation.model);
        }
      }
    }
  }
  for (auto& [name, factor] : vocabulary.factors) sort_levels(factor);
  for (const ParticipantRow& participant : study.participants()) {
    const nlohmann::json answers = nlohmann::json::parse(participant.answers_json);
    for (const auto& [name, value] : answers.items()) vocabulary.participant_answers.insert(name);
  }
  for (const ProtocolRow& protocol : study.protocols()) learn_from_protocol(protocol, vocabulary);
  return vocabulary;
}

/// The tables while they grow, row by row.
class Tables final {
 public:
  Tables(const StudyVocabulary& vocabulary, ExportAudience audience)
      : files_(export_files(vocabulary)), audience_(audience) {
    made_.codebook.columns = codebook_columns();
    for (ExportFile& file : files_) {
      ExportTable& table = made_.tables.emplace_back();
      table.name = file.name;
      const auto is_left_out = [audience](const ExportColumn& column) {
        return audience == ExportAudience::published && column.publication == Publication::dropped;
      };
      for (const ExportColumn& column : file.columns) {
        if (is_left_out(column)) table.left_out.push_back(column.name);
      }
      std::erase_if(file.columns, is_left_out);
      for (const ExportColumn& column : file.columns) {
        table.table.columns.push_back(column.name);
        made_.codebook.rows.push_back(codebook_row(file.name + ".tsv", column));
      }
    }
  }

  void add(const std::string& name, const ExportPlace& at) {
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (files_[i].name != name) continue;
      std::vector<Cell>& row = made_.tables[i].table.rows.emplace_back();
      for (const ExportColumn& column : files_[i].columns) {
        const bool hidden = audience_ == ExportAudience::published &&
                            column.publication == Publication::without_free_text &&
                            at.response_is_free_text;
        Cell cell = hidden ? Cell{} : column.cell(at);
        const auto* text = std::get_if<std::string>(&cell);
        if (text != nullptr && text->empty()) cell = Cell{};
        row.push_back(std::move(cell));
      }
    }
  }

  ExportTables take() { return std::move(made_); }

 private:
  std::vector<ExportFile> files_;
  ExportAudience audience_;
  ExportTables made_{};
};

void sort_responses(std::vector<ResponseRow>& responses) {
  std::sort(responses.begin(), responses.end(), [](const ResponseRow& a, const ResponseRow& b) {
    return std::pair(a.question, a.item) < std::pair(b.question, b.item);
  });
}

void add_attempt(Tables& tables, ExportPlace at, AttemptRow attempt) {
  at.attempt = &attempt;
  tables.add("attempts", at);
  for (const PresentationRow& presentation : attempt.presentations) {
    ExportPlace here = at;
    here.presentation = &presentation;
    tables.add("presentations", here);
  }
  sort_responses(attempt.responses);
  for (const ResponseRow& response : attempt.responses) {
    ExportPlace here = at;
    here.response = &response;
    tables.add("responses", here);
  }
  if (attempt.servo) {
    ExportPlace here = at;
    here.servo = &*attempt.servo;
    tables.add("servo_quality", here);
  }
  std::sort(attempt.compliance.begin(), attempt.compliance.end(),
            [](const ComplianceRow& a, const ComplianceRow& b) {
              return std::pair(a.position, a.quantity) < std::pair(b.position, b.quantity);
            });
  for (const ComplianceRow& compliance : attempt.compliance) {
    ExportPlace here = at;
    here.compliance = &compliance;
    tables.add("compliance", here);
  }
}

void add_session(Tables& tables, const Study& study, const StudyVocabulary& vocabulary,
                 ExportPlace at) {
  tables.add("sessions", at);
  std::vector<ResponseRow> answers = study.session_answers(at.session->id);
  sort_responses(answers);
  for (const ResponseRow& answer : answers) {
    ExportPlace here = at;
    here.response = &answer;
    const auto question = vocabulary.questions.find(answer.question);
    here.response_is_free_text =
        question == vocabulary.questions.end() || question->second.free_text;
    tables.add("responses", here);
  }
  std::map<int, std::vector<AttemptRow>> attempts_by_trial{};
  for (AttemptRow& attempt : study.attempts(at.session->id)) {
    attempts_by_trial[attempt.trial].push_back(std::move(attempt));
  }
  for (const PlannedTrialRow& trial : study.plan(at.session->id)) {
    at.trial = &trial;
    tables.add("trials", at);
    for (AttemptRow& attempt : attempts_by_trial[trial.trial]) {
      add_attempt(tables, at, std::move(attempt));
    }
  }
}

/// What stands in the way of writing into `folder`, as the end of a sentence.
std::optional<std::string> obstacle_in(const fs::path& folder, Overwrite overwrite,
                                       const std::set<std::string>& own_files) {
  if (!fs::exists(folder)) return std::nullopt;
  if (!fs::is_directory(folder)) return "exists and is not a folder";
  if (fs::is_empty(folder)) return std::nullopt;
  if (overwrite == Overwrite::refuse) {
    return "is not empty; choose another folder, or replace an earlier export with --force";
  }
  std::set<std::string> others{};
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!own_files.contains(name)) others.insert(name);
  }
  if (others.empty()) return std::nullopt;
  return "holds \"" + *others.begin() +
         "\", which no export wrote and which would be lost; choose another folder";
}

/// A folder next to the one that is to be, which takes its place when all is written.
class FolderInTheMaking final {
 public:
  explicit FolderInTheMaking(const fs::path& target)
      : target_(target), path_(target.string() + ".part-" + std::to_string(::getpid())) {
    fs::remove_all(path_);
    if (target_.has_parent_path()) fs::create_directories(target_.parent_path());
    fs::create_directory(path_);
  }
  FolderInTheMaking(const FolderInTheMaking&) = delete;
  FolderInTheMaking& operator=(const FolderInTheMaking&) = delete;
  ~FolderInTheMaking() {
    std::error_code ignored{};
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const noexcept { return path_; }

  void take_place() {
    const fs::path old = target_.string() + ".old-" + std::to_string(::getpid());
    const bool replaces = fs::exists(target_);
    if (replaces) fs::rename(target_, old);
    fs::rename(path_, target_);
    if (replaces) fs::remove_all(old);
  }

 private:
  fs::path target_;
  fs::path path_;
};

}  // namespace

ExportTables export_tables(const Study& study, ExportAudience audience, const std::stop_token& stop,
                           const std::function<void(double)>& progress) {
  const std::vector<SessionRow> sessions = study.sessions();
  const StudyVocabulary vocabulary = vocabulary_of(study, sessions, stop);
  Tables tables(vocabulary, audience);
  std::map<std::string, std::vector<const SessionRow*>> sessions_of{};
  for (const SessionRow& session : sessions) sessions_of[session.participant].push_back(&session);
  std::size_t done = 0;
  for (const ParticipantRow& participant : study.participants()) {
    ExportPlace at{};
    at.participant = &participant;
    const std::vector<const SessionRow*>& own = sessions_of[participant.label];
    std::string mode{};
    for (const SessionRow* session : own) {
      const std::string word = text_of(session->mode);
      mode = mode.empty() || mode == word ? word : "mixed";
    }
    at.participant_mode = &mode;
    tables.add("participants", at);
    for (const SessionRow* session : own) {
      if (stop.stop_requested()) return tables.take();
      if (progress) progress(static_cast<double>(done++) / static_cast<double>(sessions.size()));
      const ProtocolRow protocol = study.protocol(session->protocol_id);
      ExportPlace here = at;
      here.session = session;
      here.protocol = &protocol;
      add_session(tables, study, vocabulary, here);
    }
  }
  return tables.take();
}

std::vector<ExportedFile> export_study(const Study& study, const fs::path& folder,
                                       ExportAudience audience, Overwrite overwrite,
                                       const std::stop_token& stop,
                                       const std::function<void(double)>& progress) {
  fs::path target = fs::absolute(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();  // a slash at the end
  const ExportTables made = export_tables(study, audience, stop, progress);
  if (stop.stop_requested()) return {};
  std::set<std::string> own_files{kCodebook, kManifest};
  for (const ExportTable& table : made.tables) own_files.insert(table.name + ".tsv");
  std::vector<ExportedFile> written{};
  Table manifest{{"file", "rows", "sha256", "left_out"}, {}};
  try {
    if (const auto obstacle = obstacle_in(target, overwrite, own_files)) {
      throw ResultsError("the folder " + target.string() + " " + *obstacle, target);
    }
    FolderInTheMaking making(target);
    const auto write = [&](const std::string& name, const Table& table,
                           const std::vector<std::string>& left_out) {
      ExportedFile& file = written.emplace_back();
      file.name = name;
      file.rows = table.rows.size();
      const std::string text = tsv_of(table, &file.replaced_cells);
      write_file(making.path() / name, text, Overwrite::refuse);
      std::string names{};
      for (const std::string& column : left_out) names += (names.empty() ? "" : " ") + column;
      manifest.rows.push_back({name, static_cast<std::int64_t>(file.rows), sha256_of(text),
                               names.empty() ? Cell{} : Cell{names}});
    };
    for (const ExportTable& table : made.tables) {
      write(table.name + ".tsv", table.table, table.left_out);
    }
    write(kCodebook, made.codebook, {});
    write_file(making.path() / kManifest, tsv_of(manifest), Overwrite::refuse);
    written.push_back({.name = kManifest, .rows = manifest.rows.size()});
    making.take_place();
  } catch (const fs::filesystem_error& error) {
    throw ResultsError(
        "the export cannot be written to " + target.string() + ": " + error.code().message(),
        target, error.code().value());
  }
  return written;
}

}  // namespace asperity
