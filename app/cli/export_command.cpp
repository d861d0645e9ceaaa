// asperity export: a study as tidy tables.

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/terminal.h"
#include "app/tasks/export_study.h"

namespace asperity {

void add_export(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string out{};
    bool published = false;
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("export", "Write a study as tables (TSV) with a codebook.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command->add_option("--out", options->out, "New folder for the tables")->required();
  command->add_flag("--public", options->published, "Leave out dates and free text");
  command->add_flag("--force", options->force, "Replace an earlier export");
  command->callback([options, &job] {
    job = [options] {
      const Study study = Study::open(options->study, Access::read_only);
      const std::vector<ExportedFile> files = export_study(
          study, options->out, options->published ? ExportAudience::published : ExportAudience::own,
          options->force ? Overwrite::allow : Overwrite::refuse);
      for (const ExportedFile& file : files) {
        say(options->out + "/" + file.name + ": " + std::to_string(file.rows) + " rows");
        if (file.replaced_cells > 0) {
          say(file.name + ": in " + std::to_string(file.replaced_cells) +
              " cells tabs or line breaks became spaces, which TSV cannot hold");
        }
      }
      return 0;
    };
  });
}

}  // namespace asperity
