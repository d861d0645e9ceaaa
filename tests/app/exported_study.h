// A small study of a person and a virtual participant, exported, and its files read back.

#pragma once

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/export_study.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"

namespace asperity {

inline constexpr const char* kExportedProtocol = R"({
  "factors": {"spacing_m": {"levels": [0.001, 0.01], "meaning": "distance of the ridges",
                            "unit": "m"}},
  "questions": {"comment": {"prompt": "Anything else?", "form": "text"},
                "hand": {"prompt": "Which hand?", "form": "choice", "options": ["left", "right"]}}
})";

inline MadeUpTrial some_trial() {
  MadeUpTrial trial{};
  trial.factors_json = R"({"spacing_m": 0.01, "order": "first"})";
  trial.surfaces = {surface_of("stone", "height_map", "stone"),
                    surface_of("sinusoid", "sinusoid", "stone")};
  trial.surfaces[0].parameters_json = R"({"stiffness_N_per_m": 500.0})";
  trial.surfaces[1].parameters_json = R"({"stiffness_N_per_m": 500.0, "amplitude_m": 0.0001})";
  trial.answers = {"stone"};
  trial.right = {"stone"};
  trial.options = {"stone", "wood"};
  return trial;
}

inline ResponseRow session_answer(const std::string& question, const std::string& answer) {
  ResponseRow response{};
  response.question = question;
  response.answer = answer;
  response.time_ns = 5'500'000'000;
  response.source = "keyboard";
  return response;
}

/// A person and a virtual participant, with a session each.
inline void fill(MadeUpStudy& made) {
  ParticipantRow person{};
  person.label = "anna";
  person.sex = "F";
  person.answers_json = R"({"comment": "my name is Anna", "hand": "left", "years": 3})";
  person.created_utc = "2001-02-03T04:05:06Z";
  made.study().add_participant(person);
  made.add_virtual("virtual0001", "M");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kExportedProtocol);
  MadeUpTrial flagged = some_trial();
  flagged.flagged = true;
  const std::int64_t session = made.add_session("anna", protocol, {some_trial(), flagged});
  made.study().add_session_answer(session, session_answer("comment", "=SUM(A1)"));
  made.study().add_session_answer(session, session_answer("hand", "left"));
  made.add_session("virtual0001", protocol, {some_trial()}, SessionMode::simulate);
}

inline ExportOptions options_of(ExportAudience audience, Overwrite overwrite = Overwrite::refuse) {
  ExportOptions options{};
  options.audience = audience;
  options.overwrite = overwrite;
  return options;
}

inline ExportOptions tables_only() {
  ExportOptions options{};
  options.formats = {};
  return options;
}

inline ExportOutcome export_to(MadeUpStudy& made, const std::filesystem::path& out,
                               const ExportOptions& options = {}) {
  return export_study(made.study(), built_in_models(), out, options);
}

inline Table table_in(const std::filesystem::path& folder, const std::string& name) {
  return read_tsv(read_file(folder / name), name);
}

/// A study exported, table by table.
class Exported final {
 public:
  explicit Exported(MadeUpStudy& made, ExportOptions options = tables_only())
      : folder_(made.beside("exported")) {
    options.overwrite = Overwrite::allow;
    export_to(made, folder_, options);
  }
  Table table(const std::string& name) const { return table_in(folder_, name + ".tsv"); }
  Table codebook() const { return table("codebook"); }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_{};
};

/// The tables of the study of `fill`, exported once in this process.
inline const Exported& exported_tables() {
  static MadeUpStudy made;
  static const Exported kTables = [] {
    fill(made);
    return Exported(made);
  }();
  return kTables;
}

inline Cell cell_of(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) throw std::runtime_error("no column " + column);
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.columns.begin()));
}

inline std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names{};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

inline std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names{};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_directory()) continue;
    names.insert(std::filesystem::relative(entry.path(), folder).generic_string());
  }
  return names;
}

inline std::set<std::pair<std::string, std::string>> columns_in_codebook(const Table& codebook) {
  std::set<std::pair<std::string, std::string>> columns{};
  for (const std::vector<Cell>& row : codebook.rows) {
    columns.insert({std::get<std::string>(row[0]), std::get<std::string>(row[1])});
  }
  return columns;
}

}  // namespace asperity
