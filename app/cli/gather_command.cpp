// asperity gather: joins the results of the shards of a divided computation.

#include <filesystem>
#include <iostream>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/output/terminal.h"
#include "app/shards/table_shard.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

/// The files that the undivided command writes. Those that exist with the same bytes, from a repeated command, are accepted.
void write_whole(const std::filesystem::path& out, const GatheredTable& gathered,
                 Overwrite overwrite) {
  const std::vector<NewFile> files{{out.string() + ".json", gathered.whole.declaration},
                                   {out, gathered.table}};
  if (holds(files[0]) && holds(files[1])) return;
  write_files_together(files, overwrite);
}

}  // namespace

void add_gather(CLI::App& program, Job& job) {
  struct Options {
    std::vector<std::filesystem::path> shards{};
    std::filesystem::path out{};
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("gather", "Join the files of the shards of a divided computation.");
  command
      ->add_option("SHARD", options->shards,
                   "Files of all shards that one command computed, in any order")
      ->required();
  command
      ->add_option("--out", options->out,
                   "Table to write, with FILE.json next to it: the bytes of the undivided command")
      ->required()
      ->option_text("FILE REQUIRED");
  command->add_flag("--force", options->force, "Replace an existing table with other content");
  command->callback([options, &job] {
    job = [options] {
      for (const std::filesystem::path& shard : options->shards) {
        if (!Study::exists(shard)) continue;
        throw std::runtime_error(shard.string() +
                                 " is a study; join the studies of simulate --shard with asperity "
                                 "merge");
      }
      const GatheredTable whole = gathered(options->shards);
      write_whole(options->out, whole, options->force ? Overwrite::allow : Overwrite::refuse);
      std::cout << options->out.string() << ": " << counted(whole.rows, "row") << " of "
                << whole.whole.command << ", from "
                << counted(static_cast<std::size_t>(whole.shards), "shard") << '\n';
      return 0;
    };
  });
}

}  // namespace asperity
