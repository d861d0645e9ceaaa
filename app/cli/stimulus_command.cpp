// asperity stimulus: stimuli of a study are renamed, deleted, copied to another study, or used in a protocol.

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "analysis/words/phrase.h"
#include "app/cli/command.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/plugins/plugin_files.h"
#include "app/study_files/height_field_files.h"
#include "app/study_files/rendering_files.h"
#include "app/tasks/checked_rendering_use.h"
#include "app/tasks/stimulus_files.h"
#include "app/tasks/study_overview.h"
#include "app/words/phrase_of_error.h"
#include "app/words/text_parts.h"
#include "protocols/file/diagnostic.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

struct StimulusOptions {
  std::vector<std::filesystem::path> files{};
  std::optional<std::string> name{};
  bool deletes = false;
  std::optional<std::filesystem::path> other{};
  std::optional<std::filesystem::path> protocol{};
  RenderingPlace place{};
  std::filesystem::path out{};
  bool force = false;
  std::vector<std::filesystem::path> plugins{};
};

/// A stimulus on the command line.
struct StimulusOfStudy {
  std::filesystem::path study{};
  std::string path{};  ///< relative to the study
};

/// Errors: std::runtime_error for a file that is not a stimulus.
StimulusOfStudy stimulus_of(const std::filesystem::path& file) {
  const std::filesystem::path full = std::filesystem::absolute(file).lexically_normal();
  const std::filesystem::path folder = full.parent_path();
  std::error_code unknown{};
  if (folder.filename() != "stimuli" || !std::filesystem::is_regular_file(full, unknown)) {
    throw std::runtime_error(file.string() +
                             " is not a stimulus; give a file of the folder stimuli of a study");
  }
  if (full.extension() == ".json" && has_sidecar(folder / full.stem())) {
    throw std::runtime_error(file.string() + " belongs to " + full.stem().string() +
                             "; give that file");
  }
  return {folder.parent_path(), "stimuli/" + full.filename().string()};
}

std::string names_of(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> names{};
  for (const std::filesystem::path& file : files) names.push_back(file.filename().string());
  return comma_separated(names);
}

void rename_one(const StimulusOfStudy& stimulus, const std::string& name) {
  const Study study = Study::open(stimulus.study, Access::read_only);
  const RenamePlan plan = plan_of_renaming(study, stimulus.path);
  const std::string renamed = rename_stimulus(study, plan, name);
  std::cout << stimulus.path << ": renamed to " << renamed << '\n';
  if (!plan.changed.empty()) {
    std::cout << "references changed in: " << names_of(plan.changed) << '\n';
  }
  if (!plan.unchanged.empty()) {
    std::cout << "protocols with sessions, which keep the earlier name: "
              << names_of(plan.unchanged) << '\n';
  }
  if (!plan.reliefs.empty()) {
    std::cout << "height fields without their photograph under the new name: "
              << comma_separated(plan.reliefs) << '\n';
  }
}

void delete_one(const StimulusOfStudy& stimulus) {
  const std::vector<std::string> files = files_of_stimulus(stimulus.study, stimulus.path);
  delete_stimulus(Study::open(stimulus.study, Access::read_only), stimulus.path);
  std::cout << "deleted: " << comma_separated(files) << '\n';
}

void copy_one(const StimulusOfStudy& stimulus, const std::filesystem::path& other) {
  copy_stimuli(Study::open(other, Access::read_only).folder(), stimulus.study, {stimulus.path});
  std::cout << stimulus.path << ": copied to " << other.string() << '\n';
}

/// Errors: std::runtime_error for a rendering that cannot be used there; ProtocolError for a protocol that is not valid, or
/// would not be.
void use_one(const StimulusOfStudy& stimulus, const StimulusOptions& options) {
  if (!is_rendering(stimulus.path)) {
    throw std::runtime_error(stimulus.path +
                             " is not a rendering, and --use-in copies the values of one; give a "
                             "file NAME.rendering.json");
  }
  const Overwrite overwrite = options.force ? Overwrite::allow : Overwrite::refuse;
  refuse_existing({options.out}, overwrite);
  const RenderingUse use =
      use_of_rendering({.study = stimulus.study,
                        .rendering = stimulus.study / stimulus.path,
                        .protocol = read_file(*options.protocol, kProtocolFile),
                        .file_name = options.protocol->string(),
                        .place = options.place},
                       models_with(options.plugins));
  if (!use.problems_before.empty()) throw ProtocolError(use.problems_before);
  if (!use.remarks.problems.empty()) throw PhrasedError(use.remarks.problems.front());
  if (!use.problems.empty()) throw ProtocolError(use.problems);
  for (const Phrase& warning : use.remarks.warnings) {
    say("asperity: warning: " + warning.english());
  }
  for (const Diagnostic& warning : use.warnings) say(warning_text(warning));
  write_file(options.out, use.after, overwrite);
  for (const ChangedValue& change : use.changes) {
    const auto shown = [](const std::string& value) { return value.empty() ? "none" : value; };
    std::cout << change.pointer << ": " << shown(change.before) << " → " << shown(change.after)
              << '\n';
  }
  std::cout << options.out.string() << ": " << counted(use.changes.size(), "changed value") << '\n';
}

}  // namespace

void add_stimulus(CLI::App& program, Job& job) {
  auto options = std::make_shared<StimulusOptions>();
  CLI::App* command = program.add_subcommand(
      "stimulus",
      "Rename, delete or copy stimuli of a study, or copy the values of a rendering into a "
      "protocol.");
  command
      ->add_option("FILE", options->files,
                   "A file of the folder stimuli of a study; its sidecar belongs to it")
      ->required();
  auto* renames = command->add_option(
      "--rename", options->name,
      "New name, without its ending. All references in protocols and renderings are changed, and "
      "the name of the photograph NAME_photo.png");
  auto* deletes = command->add_flag("--delete", options->deletes,
                                    "Delete the files, to which nothing may refer");
  auto* copies = command->add_option(
      "--copy-to", options->other,
      "Folder of another study. The photograph of a height field and the texture of a rendering "
      "are copied too, and no file is replaced");
  auto* uses = command->add_option(
      "--use-in", options->protocol,
      "A protocol into which the values of a rendering are copied, as a new surface");
  auto* out = command->add_option("--out", options->out, "The changed protocol")->needs(uses);
  uses->needs(out);
  auto* replaces =
      command
          ->add_option("--replace", options->place.replaced,
                       "With --use-in: the surface (an entry of \"stimuli\") that is replaced")
          ->needs(uses);
  command
      ->add_flag("--keep-texture", options->place.keeps_texture,
                 "The replaced surface keeps its texture, or the factor that states it")
      ->needs(replaces);
  command->add_flag("--force", options->force, "Replace an existing file --out")->needs(uses);
  add_plugin_option(*command, options->plugins);
  const std::vector<CLI::Option*> actions{renames, deletes, copies, uses};
  for (CLI::Option* const one : actions) {
    for (CLI::Option* const other : actions) {
      if (one != other) one->excludes(other);
    }
  }
  command->callback([options, &job] {
    const auto run = [options] {
      if (!options->name && !options->deletes && !options->other && !options->protocol) {
        throw WrongUsage(
            "stimulus needs one of --rename, --delete, --copy-to and --use-in; see asperity "
            "stimulus --help");
      }
      if (options->files.size() > 1 && (options->name || options->protocol)) {
        throw WrongUsage(std::string(options->name ? "--rename" : "--use-in") +
                         " takes one file; give one");
      }
      for (const std::filesystem::path& file : options->files) {
        const StimulusOfStudy stimulus = stimulus_of(file);
        if (options->name) rename_one(stimulus, *options->name);
        if (options->deletes) delete_one(stimulus);
        if (options->other) copy_one(stimulus, *options->other);
        if (options->protocol) use_one(stimulus, *options);
      }
      return 0;
    };
    job = watched_with(options->plugins, with_lasting_effect(run));
  });
}

}  // namespace asperity
