// asperity analyze: the tables and tests of a study's answers, of anyone's tables, or of a reference
// case.

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output/analysis_output.h"
#include "app/cli/output/terminal.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/tidy/reference_case.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/findings/study/family_figures.h"
#include "app/study_files/height_field_files.h"
#endif
#include "results_schema/files/atomic_file.h"

namespace asperity {
namespace {

struct AnalyzeOptions {
  std::string study{};
  std::optional<std::string> protocol{};
  std::optional<std::string> only{};
  bool json = false;
  std::vector<std::string> tables{};
  std::string kind{};
  std::string options_file{};
  std::vector<std::string> options{};
  std::string figures{};
  std::string level_unit{};
  std::string reference_case{};
  std::string out{};
  bool force = false;
};

int analyze_case(const AnalyzeOptions& options) {
  const ReferenceCase read = read_reference_case(options.reference_case);
  const TidyFamily& family = tidy_family(read.family);
  refuse_further_tables(family, read.input);
  write_file(options.out, case_csv_of(family.findings(read.input)),
             options.force ? Overwrite::allow : Overwrite::refuse);
  return 0;
}

/// Of an option that the analysis has and did not ask for: it may be of no use with these data or these
/// other options.
void refuse_unused(const TidyInput& input, const std::string& name) {
  if (!input.table().has(name)) return;
  throw std::runtime_error(
      "the option \"" + name + "\" is not used, because " + input.table().name() +
      " has a column of that name; leave out the option, or remove the column");
}

#ifdef ASPERITY_WITH_WINDOWS
/// A file for each figure; the sentence of one that these data cannot fill goes to standard error.
void write_figures(const std::string& folder, const std::vector<Figure>& figures,
                   Overwrite overwrite) {
  std::filesystem::create_directories(folder);
  const LettersWithoutWindows letters;
  if (figures.empty()) say("asperity: this kind of analysis has no figures; leave out --figures");
  std::vector<NewFile> files{};
  std::vector<std::string> descriptions{};
  for (const Figure& figure : figures) {
    if (!figure.is_drawn()) {
      say("asperity: " + figure.name + ": " + figure.instead.as_sentence().english());
      continue;
    }
    const std::filesystem::path path = std::filesystem::path(folder) / (figure.name + ".svg");
    files.push_back({path, svg_of(figure)});
    descriptions.push_back(path.string() + ": " + figure.title.english() + ". " +
                           figure.note.english());
  }
  if (!files.empty()) write_files_or_refuse(files, overwrite);
  for (const std::string& description : descriptions) say(description);
}
#endif

int analyze_tables(const AnalyzeOptions& options) {
  const TidyFamily& family = tidy_family(options.kind);
  TidyInput input{};
  if (!options.options_file.empty()) {
    input.options =
        FamilyOptions::of_json(read_file(options.options_file, kOptionsFile), options.options_file);
  }
  for (const std::string& assignment : options.options) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw WrongUsage("--option takes NAME=VALUE, not \"" + assignment + "\"");
    }
    input.options.add(assignment.substr(0, equals), assignment.substr(equals + 1));
  }
  refuse_unknown_options(family, input.options);
  for (const std::string& file : options.tables) {
    const TidyTable& table = input.tables.emplace_back(read_file(file, kTableFile), file);
    if (table.rows() > 0) continue;
    throw std::runtime_error(file + ": the table has no rows below the header; add at least one");
  }
  refuse_further_tables(family, input);
  const TableFindings findings{
      .kind = options.kind, .files = options.tables, .findings = family.findings(input)};
  for (const std::string& name : input.options.never_asked_for()) refuse_unused(input, name);
  std::cout << (options.json ? findings_json(findings) : display_text_of(findings));
#ifdef ASPERITY_WITH_WINDOWS
  if (!options.figures.empty()) {
    write_figures(options.figures,
                  figures_of(options.kind, input, findings.findings, options.level_unit),
                  options.force ? Overwrite::allow : Overwrite::refuse);
  }
#endif
  return 0;
}

/// The outcomes that have the table, each with this table alone. Its remarks remain: they state whose responses it shows.
std::vector<AnalysisOutcome> with_only_table(std::vector<AnalysisOutcome> outcomes,
                                             const std::string& name) {
  std::set<std::string> names{};
  for (AnalysisOutcome& outcome : outcomes) {
    for (const ResultTable& table : outcome.tables) names.insert(table.name);
    std::erase_if(outcome.tables, [&](const ResultTable& table) { return table.name != name; });
    outcome.questions.clear();
  }
  if (names.empty()) {
    throw std::runtime_error("the analysis has no tables yet; leave out --only to see its remarks");
  }
  if (!names.contains(name)) {
    std::string known{};
    for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
    throw std::runtime_error("--only " + name +
                             ": the analysis has no table of this name; choose one of " + known);
  }
  std::erase_if(outcomes, [](const AnalysisOutcome& outcome) { return outcome.tables.empty(); });
  return outcomes;
}

int analyze_answers(const AnalyzeOptions& options) {
  const Study study = Study::open(options.study, Access::read_only);
  std::vector<AnalysisOutcome> outcomes = analyze_study(study, options.protocol);
  say_condition(study);
  if (options.only && !outcomes.empty()) {
    outcomes = with_only_table(std::move(outcomes), *options.only);
  }
  if (options.json) {
    std::cout << analysis_json(study.name(), outcomes);
    return 0;
  }
  if (outcomes.empty()) {
    say("the study " + options.study +
        (study.withdrawals().empty() ? " has no sessions yet; run one before the analysis"
                                     : " has only sessions of participants who have withdrawn; run "
                                       "another session before the analysis"));
  }
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (i > 0) std::cout << "\n\n";
    std::cout << display_text_of(outcomes[i]);
  }
  return 0;
}

}  // namespace

void add_analyze(CLI::App& program, Job& job) {
  auto options = std::make_shared<AnalyzeOptions>();
  CLI::App* command = program.add_subcommand(
      "analyze",
      "Analyse the responses of a study, or tables from other sources: tables and tests.");
  auto* study = command->add_option("STUDY", options->study, "Folder of the study");
  auto* protocol =
      command->add_option("--protocol", options->protocol, "Only the protocol with this name");
  auto* only = command->add_option(
      "--only", options->only,
      "Print only the table with this name, such as table_1; an unknown name lists all names");
  auto* json = command->add_flag("--json", options->json, "Print one JSON document");
  auto* tables = command->add_option(
      "--table", options->tables, "Instead of a study: tables, one observation per row (CSV, TSV)");
  auto* kind = command->add_option("--as", options->kind, "Kind of analysis: " + family_names());
  auto* file = command->add_option("--options", options->options_file,
                                   "Options of the analysis (a JSON object)");
  auto* option =
      command->add_option("--option", options->options,
                          "Options of the analysis, NAME=VALUE; a,b,c is a list, and a VALUE in "
                          "JSON is read as JSON: 'within={\"spacing\":[1,2,4]}'");
#ifdef ASPERITY_WITH_WINDOWS
  auto* figures =
      command->add_option("--figures", options->figures,
                          "Also write the figures of the analysis, as SVG files in this folder");
  auto* level_unit = command->add_option(
      "--level-unit", options->level_unit,
      "Unit of the levels or spacings in the table, for the axes of the figures");
#endif
  auto* reference_case = command->add_option(
      "--case", options->reference_case,
      "Instead of a study: a folder with case.json (family, inputs, options) and its tables");
  auto* out = command->add_option(
      "--out", options->out, "Write the results of the case to this file as quantity,key,value");
  protocol->needs(study);
  only->needs(study)->excludes(json);
  tables->excludes(study)->needs(kind);
  kind->needs(tables);
  file->needs(tables);
  option->needs(tables);
  reference_case->excludes(study)->excludes(tables)->excludes(json)->needs(out);
  out->needs(reference_case);
  command->add_flag("--force", options->force, "Replace existing files");
#ifdef ASPERITY_WITH_WINDOWS
  figures->needs(tables);
  level_unit->needs(figures);
#endif
  command->callback([options, &job] {
    if (options->force && options->out.empty() && options->figures.empty()) {
      throw CLI::RequiresError("--force", "an output, --out or --figures");
    }
    if (!options->reference_case.empty()) {
      job = [options] { return analyze_case(*options); };
    } else if (!options->tables.empty()) {
      job = [options] { return analyze_tables(*options); };
    } else if (!options->study.empty()) {
      job = [options] { return analyze_answers(*options); };
    } else {
      throw CLI::RequiredError("STUDY, --table or --case");
    }
  });
}

}  // namespace asperity
