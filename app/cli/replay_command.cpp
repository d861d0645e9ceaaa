// asperity replay: a recorded hand through any force model.

#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/asset_option.h"
#include "app/cli/command.h"
#include "app/cli/model_option.h"
#include "app/cli/parameter_option.h"
#include "app/cli/plugin_option.h"
#include "app/cli/terminal.h"
#include "app/plugins/plugin_files.h"
#include "app/plugins/stored_plugins.h"
#include "app/records/path_table.h"
#include "app/records/recorded_attempt.h"
#include "app/study_files/height_field_files.h"
#include "protocols/design/wording.h"
#include "results_schema/atomic_file.h"

namespace asperity {

namespace {

/// A hand that held a tool against a surface tells nothing to a model that feels a height field with a
/// point, and the other way round.
void require_same_kind(const ModelRegistry& models, const ForceModel& asked, const ForceModel& felt,
                       int surface) {
  const bool felt_bodies = felt.declaration.needs_bodies;
  if (asked.declaration.needs_bodies == felt_bodies) return;
  std::vector<std::string> fitting{};
  for (const ForceModel& model : models.models()) {
    if (model.declaration.needs_bodies == felt_bodies) fitting.push_back(model.declaration.id);
  }
  throw std::runtime_error(
      "surface " + std::to_string(surface) + " was rendered with " + felt.declaration.id + ", " +
      (felt_bodies ? "a model with two bodies" : "a model with a point") + ", and " +
      asked.declaration.id + " needs " +
      (felt_bodies ? "a height field and a point" : "a tool and a surface as bodies") +
      "; --model takes " + one_of(fitting) + " here");
}

/// The files of the recorded texture that the model needs.
void add_assets_of_texture(const Study& study, const RecordedAttempt& recorded, int surface,
                           const ModelDeclaration& model, RendererInputs& inputs) {
  const auto& files = recorded.trial.presentations.at(static_cast<std::size_t>(surface - 1))
                          .stimulus.declared_assets;
  for (const AssetDeclaration& asset : model.assets) {
    const auto file = files.find(asset.role);
    if (file == files.end()) continue;
    inputs.assets[asset.role] =
        std::make_shared<const std::string>(read_file(study.folder() / file->second));
    inputs.asset_names[asset.role] = file->second;
  }
}

}  // namespace

void add_replay(CLI::App& program, Job& job) {
  struct Options {
    std::string study{};
    std::string attempt{};
    int surface = 1;
    std::optional<std::string> model{};
    std::vector<std::string> parameters{};
    std::vector<std::string> assets{};
    std::filesystem::path out{};
    bool force = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "replay", "Render a recorded hand movement again, with its force model or another one.");
  command->add_option("STUDY", options->study, "Folder of the study")->required();
  command
      ->add_option("--attempt", options->attempt,
                   "Row number in the exported attempts.tsv, or PARTICIPANT/SESSION/TRIAL/ATTEMPT")
      ->required();
  command->add_option("--surface", options->surface, "Number of the surface in the trial")
      ->capture_default_str();
  command->add_option("--model", options->model,
                      "Another force model on the same texture, of the same kind as the recorded "
                      "one: with two bodies or with a point");
  command->add_option("--param", options->parameters, "Parameter of the other model, NAME=VALUE");
  command->add_option("--asset", options->assets,
                      "File that the other model needs, ROLE=FILE; see: asperity models");
  command->add_option("--out", options->out, "Table of the forces (TSV)")->required();
  command->add_flag("--force", options->force, "Replace an existing file");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] {
      const Overwrite overwrite = options->force ? Overwrite::allow : Overwrite::refuse;
      refuse_existing({options->out}, overwrite);
      const Study study = Study::open(options->study, Access::read_only);
      const AttemptRow attempt = find_attempt(study, options->attempt);
      // A recorded plug-in is needed only if it renders: with its declaration, another model can replace it.
      const ModelRegistry models = with_stored_builds(models_with_builds(options->plugins), study)
                                       .with(plugin_builds_of(attempt));
      const SessionRow session = study.session(study.session_of(attempt.id));
      const Plan plan = plan_of(study, session, models);
      StimulusBuilder builder(models, study.folder());
      const RecordedAttempt recorded = recorded_attempt(
          study.folder(), session, plan.trials.at(static_cast<std::size_t>(attempt.trial - 1)),
          attempt, builder);
      if (options->surface < 1 || options->surface > static_cast<int>(recorded.surfaces.size())) {
        throw std::runtime_error(
            "--surface is " + std::to_string(options->surface) + ", and the trial has " +
            counted(recorded.surfaces.size(), "surface") +
            (recorded.surfaces.size() == 1 ? "; leave out --surface"
                                           : "; give the number of one of them"));
      }
      const RecordedSurface& surface =
          recorded.surfaces[static_cast<std::size_t>(options->surface - 1)];
      const ForceModel* model = surface.stimulus.model;
      RendererInputs inputs = surface.stimulus.inputs;
      if (options->model) {
        model = &model_named(models, *options->model);
        require_same_kind(models, *model, *surface.stimulus.model, options->surface);
        inputs.parameters.clear();
        if (model->suggested_by && inputs.height_field) {
          inputs.parameters = model->suggested_by(*inputs.height_field, inputs.material);
        }
        for (const auto& [name, value] :
             parameters_from(options->parameters, model->declaration.parameters, *options->model)) {
          inputs.parameters[name] = value;
        }
        add_assets_of_texture(study, recorded, options->surface, model->declaration, inputs);
        for (const std::string& text : options->assets) {
          add_asset(inputs, model->declaration, text);
        }
      } else if (!options->parameters.empty() || !options->assets.empty()) {
        const std::string option = options->parameters.empty() ? "--asset" : "--param";
        throw WrongUsage(option + " needs --model; add it, or leave out " + option);
      }
      const ReplayedSurface replayed = replay_surface(recorded, options->surface, *model, inputs);
      std::vector<RenderedTick> forces{};
      std::vector<ProbeState> path{};
      for (std::size_t i = 0; i < replayed.records.size(); ++i) {
        if (!replayed.records[i].has(TickFlag::presenting)) continue;
        forces.push_back(replayed.ticks[i]);
        path.push_back(replayed.records[i].probe);
      }
      write_file(options->out, forces_tsv(path, forces), overwrite);
      std::cout << options->out.string() << ": " << counted(forces.size(), "row") << '\n';
      return 0;
    });
  });
}

}  // namespace asperity
