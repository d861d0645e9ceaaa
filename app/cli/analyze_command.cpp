// asperity analyze: the tables and tests of what a study has answers to.

#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/analyses/analyze_study.h"
#include "app/cli/analysis_output.h"
#include "app/cli/command.h"
#include "app/cli/terminal.h"

namespace asperity {

void add_analyze(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::optional<std::string> protocol{};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("analyze", "Show the tables and tests of a study's answers.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("--protocol", options->protocol, "Only the protocol of this name");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback([options, &job] {
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
