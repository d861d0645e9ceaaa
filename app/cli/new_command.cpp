// asperity new: a study to begin with.

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/terminal.h"
#include "app/tasks/new_study.h"

namespace asperity {

void add_new(CLI::App& program, Job& job) {
  struct Options {
    std::filesystem::path folder{};
    bool demo = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("new", "Make a study.");
  command->add_option("DIR", options->folder, "Folder of the study; must not hold anything yet")
      ->required();
  command->add_flag("--demo", options->demo,
                    "The demonstration study, with textures and protocols");
  command->callback([options, &job] {
    job = [options] {
      if (options->demo) {
        Progress progress("making textures");
        new_demo_study(options->folder, [&progress](double fraction) { progress.show(fraction); });
      } else {
        new_study(options->folder);
      }
      std::cout << "made the study " << options->folder.string() << '\n';
      return 0;
    };
  });
}

}  // namespace asperity
