// asperity merge: one study with the participants of several: of the stations of an experiment, or of the shards of a simulation.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/metadata_options.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/shards/study_shard.h"
#include "app/study_files/study_outputs.h"
#include "app/tasks/verify/verify_places.h"
#include "results_schema/merge/study_merge.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

/// "STUDY=PREFIX", for a study as it was named on the command line. Errors: WrongUsage.
void apply_prefix(const std::string& stated, std::vector<MergeSource>& sources) {
  const std::size_t equals = stated.rfind('=');
  if (equals == std::string::npos) {
    throw WrongUsage("--prefix is \"" + stated +
                     "\"; write STUDY=PREFIX, where STUDY is one of the studies to be merged");
  }
  const std::filesystem::path study = stated.substr(0, equals);
  // With a slash at the end, or without.
  const auto as_folder = [](const std::filesystem::path& path) {
    return (path / "").lexically_normal();
  };
  const auto source = std::find_if(sources.begin(), sources.end(), [&](const MergeSource& any) {
    return as_folder(any.folder) == as_folder(study);
  });
  if (source == sources.end()) {
    throw WrongUsage("--prefix names the study \"" + study.string() +
                     "\", which is not one of the studies to be merged; name it as before --out");
  }
  source->prefix = stated.substr(equals + 1);
}

std::string number_of(std::int64_t count, const char* thing) {
  return counted(static_cast<std::size_t>(count), thing);
}

/// Only a warning: sessions of people cannot be run again at other places.
void say_shared_places(const std::filesystem::path& merged) {
  for (const std::string& warning : shared_places(Study::open(merged, Access::read_only))) {
    say("asperity: warning: " + warning);
  }
}

void say_what_remains(const MergedCounts& counts) {
  if (counts.incomplete_sessions > 0) {
    say("asperity: warning: " + number_of(counts.incomplete_sessions, "session") +
        (counts.incomplete_sessions == 1 ? " is" : " are") +
        " not complete: resume in the study of the station and merge again, or resume in the "
        "merged study, but not in both");
  }
  std::cout << "A participant who withdraws must be withdrawn from the study of the station, "
               "which lists this one among its outputs, and from this one\n";
}

}  // namespace

void add_merge(CLI::App& program, Job& job) {
  struct Options {
    std::vector<std::string> studies{};
    std::string out{};
    std::vector<std::string> prefixes{};
    bool deletions_checked = false;
    MetadataOptions metadata{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "merge",
      "Merge the studies of stations, or of all shards of a simulation, into a new study.");
  command->add_option("STUDY", options->studies, "Folders of the studies, in any order")
      ->required();
  command
      ->add_option(
          "--out", options->out,
          "Folder of the merged study: new, or made by an earlier merge of the same studies")
      ->required();
  command
      ->add_option("--prefix", options->prefixes,
                   "Prefix of the labels of a study in the merged study, for labels that occur in "
                   "several studies: letters and digits; separate several by commas")
      ->delimiter(',')
      ->allow_extra_args(false)  // one for each time the option is given
      ->option_text("STUDY=PREFIX,…");
  command->add_flag("--deletions-checked", options->deletions_checked,
                    "Of studies that were copied from one: confirm that data of participants that "
                    "were deleted from one are not in another");
  add_metadata_options(*command, options->metadata, EmptyText::mistake);
  command->callback([options, &job] {
    job = [options] {
      std::vector<MergeSource> sources{};
      for (const std::string& study : options->studies) sources.push_back({.folder = study});
      for (const std::string& prefix : options->prefixes) apply_prefix(prefix, sources);
      Study::read_beside_writers();                   // ListedOutput is one, in this process
      Study::refuse_merge_to(sources, options->out);  // before one is written to
      require_complete_divisions({options->studies.begin(), options->studies.end()});
      std::list<ListedOutput> listed{};
      for (const MergeSource& source : sources) {
        const Study study = Study::open(source.folder, Access::read_only);
        listed.emplace_back(study, OutputKind::merge, options->out);
      }
      const InterruptWatch interrupt("stopping; no merged study is made");
      const MergedCounts counts = Study::merge(
          sources, options->out,
          {.metadata = options->metadata.applied_to({}),
           .deletions_in_copies = options->deletions_checked ? DeletionsInCopies::checked
                                                             : DeletionsInCopies::unchecked,
           .stop = interrupt.token()});
      if (!counts.was_there) {  // otherwise the earlier merge is listed
        for (ListedOutput& entry : listed) say_unrecorded(entry.complete());
      }
      std::cout << (counts.was_there ? "already merged by an earlier command: " : "merged ")
                << sources.size() << (sources.size() == 1 ? " study" : " studies") << " into "
                << options->out << ": " << number_of(counts.participants, "participant") << ", "
                << number_of(counts.sessions, "session") << ", "
                << number_of(counts.attempts, "attempt") << ", "
                << number_of(counts.recordings, "recording") << '\n';
      say_shared_places(options->out);
      say_what_remains(counts);
      return 0;
    };
  });
}

}  // namespace asperity
