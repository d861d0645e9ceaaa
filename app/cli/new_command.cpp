// asperity new: a study to begin with.

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/metadata_options.h"
#include "app/cli/output/terminal.h"
#include "app/tasks/new_study.h"
#include "results_schema/study_sharing.h"

namespace asperity {

void add_new(CLI::App& program, Job& job) {
  struct Options {
    std::filesystem::path folder{};
    std::string group{};
    bool demo = false;
    bool shared = false;
    MetadataOptions metadata{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("new", "Create a study.");
  command
      ->add_option("DIR", options->folder,
                   "Folder of the study; must be new or empty (desktop files such as .DS_Store are "
                   "ignored)")
      ->required();
  command->add_flag("--demo", options->demo, "Create the demo study, with textures and protocols");
  CLI::Option* const shared = command->add_flag(
      "--shared", options->shared,
      "Share the study with the group of the folder: its members can read and change it and run "
      "sessions. Without this option only the owner can access a new folder");
  command
      ->add_option("--group", options->group,
                   "With --shared: name of the group; you must be a member")
      ->needs(shared);
  add_metadata_options(*command, options->metadata, EmptyText::mistake);
  command->callback([options, &job] {
    job = [options] {
      require_group(options->group);
      NewStudySettings settings{.metadata = options->metadata.applied_to({})};
      if (options->shared) settings.group = options->group;
      const NewStudy result = [&] {
        if (!options->demo) return new_study(options->folder, settings);
        Progress progress("making textures");
        return new_demo_study(
            options->folder, [&progress](double fraction) { progress.show(fraction); }, settings);
      }();
      std::cout << (result == NewStudy::made ? "created the study "
                                             : "an earlier command created the unused study ")
                << options->folder.string();
      if (options->shared) {
        std::cout << ", shared with the group " << group_of(options->folder);
      }
      std::cout << '\n' << one_version_per_study().english() << '\n';
      if (!options->shared) return 0;
      if (const auto closed = folder_closed_to_group(options->folder)) {
        std::cerr
            << "asperity: warning: members of the group cannot access the study: they have "
               "no permission for the folder "
            << closed->string()
            << ". Give the group access to that folder with chmod, or move the study out of it\n";
      }
      return 0;
    };
  });
}

}  // namespace asperity
