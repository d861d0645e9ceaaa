// asperity report: a study in words, tables and figures, for people.

#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/figures/figure_files.h"
#include "app/report/pages/report_file.h"
#include "app/study_files/study_condition.h"
#include "app/study_files/study_outputs.h"

namespace asperity {

void add_report(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string out{};
    std::optional<std::string> protocol{};
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "report", "Write a report of a study: methods, tables, tests and figures.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("--out", options->out, "New file, .pdf or .html")->required();
  command->add_option("--protocol", options->protocol, "Only the protocol with this name");
  command->add_flag("--force", options->force, "Replace an existing file");
  command->callback([options, &job] {
    job = [options] {
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      try {
        require_report_path(options->out, overwrite);
      } catch (const std::invalid_argument& error) {
        throw WrongUsage(error.what());
      }
      const InterruptWatch interrupt("stopping; no report is written");
      Study::read_beside_writers();  // ListedOutput is one, in this process
      const Study study = Study::open(options->study, Access::read_only);
      ListedOutput listed(study, OutputKind::report, options->out);
      const LettersWithoutWindows letters;
      bool written = false;
      {
        Progress progress("writing the report");
        read_unless_broken(
            study,
            [&] {
              written =
                  write_report(study, options->out, overwrite, options->protocol, interrupt.token(),
                               [&progress](double fraction) { progress.show(fraction); });
            },
            interrupt.token());
      }
      if (!written) {
        say("asperity: the command was stopped, and no report was written; repeat it to write the "
            "report");
        return 1;
      }
      say("the report is in " + options->out);
      say_condition(study);
      say_unrecorded(listed.complete());
      return 0;
    };
  });
}

}  // namespace asperity
