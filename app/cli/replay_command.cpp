// asperity replay: recorded hands through any force model.

#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/asset_option.h"
#include "app/cli/options/model_option.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/parameter_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/replay_options.h"
#include "app/plugins/plugin_files.h"
#include "app/plugins/stored_plugins.h"
#include "app/records/other_model.h"
#include "app/records/path_table.h"
#include "app/records/recorded_attempt.h"
#include "protocols/design/wording.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

/// Names the models that the recording permits.
void require_same_kind(const ModelRegistry& models, const ForceModel& asked, const ForceModel& felt,
                       int surface) {
  if (feel_alike(asked, felt)) return;
  const bool felt_bodies = felt.declaration.needs_bodies;
  std::vector<std::string> fitting{};
  for (const ForceModel& model : models.models()) {
    if (feel_alike(model, felt)) fitting.push_back(model.declaration.id);
  }
  throw std::runtime_error(
      "surface " + std::to_string(surface) + " was rendered with " + felt.declaration.id + ", " +
      (felt_bodies ? "a model with two bodies" : "a model with a point") + ", and " +
      asked.declaration.id + " needs " +
      (felt_bodies ? "a height field and a point" : "a tool and a surface as bodies") +
      "; --model takes " + one_of(fitting) + " here");
}

int run_replay(const ReplayOptions& options) {
  refuse_existing({options.out}, options.overwrite());
  const Study study = Study::open(options.study, Access::read_only);
  const AttemptRow attempt = find_attempt(study, *options.attempt);
  // A recorded plug-in is needed only if it renders: with its declaration, another model can replace it.
  const ModelRegistry models = with_stored_builds(models_with_builds(options.plugins), study)
                                   .with(plugin_builds_of(attempt));
  StimulusBuilder builder(models, study.folder());
  const RecordedAttempt recorded = recorded_attempt(study, attempt, builder);
  if (options.surface < 1 || options.surface > static_cast<int>(recorded.surfaces.size())) {
    throw std::runtime_error("--surface is " + std::to_string(options.surface) +
                             ", and the trial has " + counted(recorded.surfaces.size(), "surface") +
                             (recorded.surfaces.size() == 1 ? "; leave out --surface"
                                                            : "; give the number of one of them"));
  }
  const RecordedSurface& surface = recorded.surfaces[static_cast<std::size_t>(options.surface - 1)];
  const ForceModel* model = surface.stimulus.model;
  RendererInputs inputs = surface.stimulus.inputs;
  if (const std::optional<OtherModelSettings> settings = other_model(options, models)) {
    model = settings->model;
    require_same_kind(models, *model, *surface.stimulus.model, options.surface);
    inputs = OtherModel(*settings).inputs_for(recorded, options.surface, builder);
  }
  const ReplayedSurface replayed = replay_surface(recorded, options.surface, *model, inputs);
  std::vector<RenderedTick> forces{};
  std::vector<ProbeState> path{};
  for (std::size_t i = 0; i < replayed.records.size(); ++i) {
    if (!replayed.records[i].has(TickFlag::presenting)) continue;
    forces.push_back(replayed.ticks[i]);
    path.push_back(replayed.records[i].probe);
  }
  write_file(options.out, forces_tsv(path, forces), options.overwrite());
  std::cout << options.out.string() << ": " << counted(forces.size(), "row") << '\n';
  return 0;
}

}  // namespace

std::optional<OtherModelSettings> other_model(const ReplayOptions& options,
                                              const ModelRegistry& models) {
  if (!options.model) {
    if (options.parameters.empty() && options.assets.empty()) return {};
    const std::string option = options.parameters.empty() ? "--asset" : "--param";
    throw WrongUsage(option + " needs --model; add it, or leave out " + option);
  }
  OtherModelSettings settings{.model = &model_named(models, *options.model)};
  const ModelDeclaration& declaration = settings.model->declaration;
  settings.parameters = parameters_from(options.parameters, declaration.parameters, *options.model);
  for (const std::string& text : options.assets) add_asset(settings, declaration, text);
  return settings;
}

void add_replay(CLI::App& program, Job& job) {
  auto options = std::make_shared<ReplayOptions>();
  CLI::App* command = program.add_subcommand(
      "replay",
      "Render a recorded hand movement again, or compare those of a whole study, with the recorded "
      "force model or another one.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  CLI::Option* const attempt = command->add_option(
      "--attempt", options->attempt,
      "Row number in the exported attempts.tsv, or PARTICIPANT/SESSION/TRIAL/ATTEMPT");
  CLI::Option* const surface =
      command->add_option("--surface", options->surface, "Number of the surface in the trial")
          ->capture_default_str();
  CLI::Option* const compare = command->add_flag(
      "--compare", options->compare,
      "Compare all recorded presentations of the study with the forces of this program and its "
      "plug-ins, or of another model: RMS, largest difference, energy in nine bands of frequency");
  compare->excludes(attempt)->excludes(surface);
  command->add_option("--model", options->model,
                      "Another force model on the same texture, of the same kind as the recorded "
                      "one: with two bodies or with a point. The recorded model keeps its recorded "
                      "parameters, except those of --param");
  command->add_option("--param", options->parameters, "Parameter of that model, NAME=VALUE");
  command->add_option("--asset", options->assets,
                      "File that the other model needs, ROLE=FILE; see: asperity models");
  command
      ->add_option("--out", options->out,
                   "Table of the forces, or with --compare of the presentations (TSV)")
      ->required();
#ifdef ASPERITY_WITH_WINDOWS
  command
      ->add_option("--plot", options->plot,
                   "With --compare: figure of the forces by frequency, .svg, .png or .pdf")
      ->needs(compare);
#endif
  command
      ->add_option("--jobs", options->jobs,
                   "With --compare: number of attempts that are replayed in parallel (default: one "
                   "for each processor); does not affect the result")
      ->needs(compare)
      ->check(number_within(1, 256));
  command->add_flag("--json", options->json, "With --compare: print one JSON document")
      ->needs(compare);
  command->add_flag("--force", options->force, "Replace existing files");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    const auto run = [options] {
      if (!options->compare && !options->attempt) {
        throw WrongUsage(
            "replay renders one attempt or compares a whole study; add --attempt WHICH or "
            "--compare");
      }
      return options->compare ? run_replay_comparison(*options) : run_replay(*options);
    };
    job = watched_with(options->plugins, with_lasting_effect(run));
  });
}

}  // namespace asperity
