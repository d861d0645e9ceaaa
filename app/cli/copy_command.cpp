// asperity copy: a consistent copy of a study that may be in use.

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/study_files/study_outputs.h"
#include "results_schema/study.h"

namespace asperity {

void add_copy(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string folder{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("copy", "Copy a study, even while its sessions are running.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("DIR", options->folder, "Folder of the copy, which must not exist yet")
      ->required();
  command->callback([options, &job] {
    job = [options] {
      Study::read_beside_writers();  // ListedOutput is one, in this process
      const Study study = Study::open(options->study, Access::read_only);
      study.refuse_copy_to(options->folder);  // before it is written to
      ListedOutput listed(study, OutputKind::copy, options->folder);
      const InterruptWatch interrupt("stopping; no copy is made");
      study.copy_to(options->folder, interrupt.token());
      say("copied " + options->study + " to " + options->folder);
      say_unrecorded(listed.complete());
      return 0;
    };
  });
}

}  // namespace asperity
