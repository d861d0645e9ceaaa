// asperity analyze: the tables and tests of what a study has answers to, or of a reference case.

#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/analyses/analyze_study.h"
#include "app/analyses/tidy/reference_case.h"
#include "app/cli/analysis_output.h"
#include "app/cli/command.h"
#include "app/cli/terminal.h"
#include "results_schema/atomic_file.h"

namespace asperity {

void add_analyze(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::optional<std::string> protocol{};
    std::string reference_case{};
    std::string out{};
    bool force = false;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("analyze", "Show the tables and tests of a study's answers.");
  auto* of_study = command->add_option("STUDY", options->study, "Folder of the study");
  auto* protocol =
      command->add_option("--protocol", options->protocol, "Only the protocol of this name");
  auto* json = command->add_flag("--json", options->json, "Print one JSON document");
  auto* reference_case = command->add_option(
      "--case", options->reference_case,
      "Instead of a study: a folder with case.json (family, inputs, options) and its tables");
  auto* out = command->add_option(
      "--out", options->out, "Write the results of the case to this file as quantity,key,value");
  reference_case->excludes(of_study)->excludes(protocol)->excludes(json)->needs(out);
  out->needs(reference_case);
  command->add_flag("--force", options->force, "Replace an existing file")->needs(out);
  command->callback([options, &job] {
    if (options->study.empty() && options->reference_case.empty()) {
      throw CLI::RequiredError("STUDY or --case");
    }
    if (!options->reference_case.empty()) {
      job = [options] {
        const ReferenceCase read = read_reference_case(options->reference_case);
        write_file(options->out, case_csv_of(tidy_family(read.family).findings(read.input)),
                   options->force ? Overwrite::allow : Overwrite::refuse);
        return 0;
      };
      return;
    }
    job = [options] {
      const Study study = Study::open(options->study, Access::read_only);
      const std::vector<AnalysisOutcome> outcomes = analyze_study(study, options->protocol);
      if (options->json) {
        std::cout << analysis_json(study.name(), outcomes);
        return 0;
      }
      if (outcomes.empty()) {
        say("the study " + options->study + " has no sessions yet: there is nothing to analyse");
      }
      for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (i > 0) std::cout << "\n\n";
        std::cout << reading_text_of(outcomes[i]);
      }
      return 0;
    };
  });
}

}  // namespace asperity
