// asperity sweep: the offline roughness experiment.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/shard_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/cli/sweep/sweep_options.h"
#include "app/cli/sweep/sweep_summary.h"
#include "app/plugins/plugin_files.h"
#include "app/sweep/sweep_shard.h"
#include "app/words/text_parts.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/cli/sweep/sweep_study.h"
#include "app/figures/figure_files.h"
#include "app/study_files/drawn_figures.h"
#include "app/study_files/height_field_files.h"
#include "app/sweep/sweep_figure.h"
#endif

namespace asperity {

namespace {

/// The presets with their values, for the help.
std::string hand_preset_list() {
  std::string list{};
  for (const HandPreset& preset : hand_presets()) {
    list += std::string(list.empty() ? "" : "; ") + preset.name + " (" +
            number_text(preset.hand.mass_kg) + ',' + number_text(preset.hand.damping_N_s_per_m) +
            ',' + number_text(preset.hand.stiffness_N_per_m) + "), " + preset.choice;
  }
  return list;
}

/// Computes one shard. The summary and the figure are those of all rows.
int run_shard(const SweepOptions& options, const SweepFile& file) {
  const Shard& shard = *options.shard;
  Sweep sweep{};
  {
    const InterruptWatch interrupt("stopping; the shard is not written");
    Progress progress("sweeping");
    sweep = sweep_into_shard(options.order, shard, file, interrupt.token(),
                             [&progress](double fraction) { progress.show(fraction); });
  }
  if (!sweep.is_complete) {
    say("asperity: shard " + text_of(shard) +
        " was stopped and nothing was written; repeat the command to compute it");
    return 1;
  }
  std::cout << shard_path(file.out, shard).string() << ": shard " << text_of(shard) << ", "
            << (sweep.rows.empty() ? "already computed by an earlier command"
                                   : counted(sweep.rows.size(), "row") + " of " +
                                         std::to_string(divided(options.order).results))
            << '\n';
  return 0;
}

int run_sweep(SweepOptions options) {
  const ModelRegistry models = models_with(options.plugins);
  complete_order(options, models);
  const SweepOrder& order = options.order;
  if (entry_of(options.measure).is_of_turning && !order.stroke.turning) {
    throw WrongUsage(std::string("--measure ") + text_of(options.measure) +
                     " is a measure of a tool that turns; add --turning-rad or --vary turning_rad, "
                     "or choose another measure");
  }
  const SweepFile file{
      .out = options.out,
      .overwrite = options.force ? Overwrite::allow : Overwrite::refuse,
      .jobs = options.jobs > 0
                  ? options.jobs
                  : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))};
  if (options.shard) return run_shard(options, file);
#ifdef ASPERITY_WITH_WINDOWS
  const std::filesystem::path plot = options.plot;
  const DrawnFigures drawn(options.out + ".figures.json");
  if (!plot.empty()) {
    try {
      require_figure_ending(plot);
    } catch (const std::invalid_argument& error) {
      throw WrongUsage(std::string("--plot: ") + error.what());
    }
    refuse_existing({plot}, drawn.overwrite_of(plot, file.overwrite));
    if (plot.has_parent_path() && !std::filesystem::is_directory(plot.parent_path())) {
      throw std::runtime_error("--plot " + options.plot + ": there is no folder " +
                               plot.parent_path().string() + "; create it first");
    }
  }
  std::optional<StudyBeside> beside{};
  if (!options.beside.empty()) {
    require_sweep(order);
    beside = study_beside(options, models);
  }
#endif
  Sweep sweep{};
  {
    const InterruptWatch interrupt("stopping; complete rows are kept");
    Progress progress("sweeping");
    sweep = sweep_into_file(order, file, interrupt.token(),
                            [&progress](double fraction) { progress.show(fraction); });
  }
  const std::size_t asked = order.values.size() * order.spacings_m.size();
  if (!sweep.is_complete) {
    say(sweep.rows.empty()
            ? "asperity: the sweep was stopped before its first row; repeat the command to begin it"
            : "asperity: the sweep was stopped; rows in " + options.out + ": " +
                  std::to_string(sweep.rows.size()) + " of " + std::to_string(asked) +
                  "; repeat the command to continue it");
    return 1;
  }
  std::cout << options.out << ": " << counted(sweep.rows.size(), "row") << ", "
            << text_of(order.stroke.mode) << ", " << text_of(options.measure) << '\n'
            << aligned(summary_table(sweep, options.measure));
  say_without_effect(sweep);
  say_lost_contact(sweep);
  say_absent_numbers(sweep, options.measure);
#ifdef ASPERITY_WITH_WINDOWS
  if (!plot.empty()) {
    const LettersWithoutWindows letters;
    const Figure figure =
        beside ? beside_prediction(of_group(std::move(beside->estimates), beside->group), sweep,
                                   beside->conditions, options.measure)
               : sweep_figure(sweep, options.measure);
    write_figure(plot, figure, {}, drawn.overwrite_of(plot, file.overwrite));
    drawn.record(plot);
  }
#endif
  return 0;
}

}  // namespace

void add_sweep(CLI::App& program, Job& job) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* command = program.add_subcommand(
      "sweep",
      "Predict roughness over texture spacing, by probe diameter, applied force, speed or "
      "amplitude of turning.");
  command->add_option("--model", options->model, "A force model; see: asperity models")->required();
  command->add_option("--param", options->parameters, "Parameter of the model, NAME=VALUE");
  command->add_option(
      "--asset", options->assets,
      "File that the model needs, ROLE=FILE; see: asperity models (default: the file that the "
      "texture suggests at each spacing)");
  const std::map<std::string, VariedQuantity> varied{
      {"probe_diameter", VariedQuantity::probe_diameter},
      {"applied_force", VariedQuantity::applied_force},
      {"exploratory_speed", VariedQuantity::exploratory_speed},
      {"turning_rad", VariedQuantity::turning}};
  command
      ->add_option("--vary", options->order.varied,
                   "Quantity that is varied, with one curve for each value")
      ->required()
      ->transform(word_of(varied))
      ->option_text("probe_diameter|applied_force|exploratory_speed|turning_rad REQUIRED");
  command->add_option(
      "--values", options->values,
      "Values of the varied quantity, V,V,…, in m, N, m/s or rad (default: three typical values)");
  command
      ->add_option("--spacings", options->spacings,
                   "Spacings of the texture, FROM:TO:COUNT in metres, logarithmically spaced")
      ->capture_default_str();
  command
      ->add_option("--texture", options->texture,
                   "Texture: KIND[,NAME=VALUE…] of asperity synth, or FILE.png, a height field "
                   "that is stretched to each spacing")
      ->capture_default_str();
  command->add_option("--tool", options->tool,
                      "For a model with two bodies: sphere (the default), disc (upright, along the "
                      "stroke), point, or the file of a textured mesh");
  command->add_option(
      "--stimulus", options->stimulus,
      "For a model of a point: the body under the texture, along whose upper side the stroke leads "
      "(default: a plane): a textured mesh, or box:X_m,Y_m,Z_m, cylinder:D_m,L_m, sphere:D_m, "
      "plane:X_m,Y_m");
  const std::map<std::string, DragMode> modes{{"constant_height", DragMode::constant_height},
                                              {"constant_force", DragMode::constant_force}};
  command
      ->add_option("--drag", options->drag,
                   "constant_height: at the height of the given mean normal force; "
                   "constant_force: pressed with the given force, the default for "
                   "exploratory_speed")
      ->transform(word_of(modes))
      ->option_text("constant_height|constant_force");
  command
      ->add_option("--hand", options->hand,
                   "Mass, damping and stiffness of the hand, M_kg,B_N_s_per_m,K_N_per_m, or a "
                   "preset: " +
                       hand_preset_list())
      ->capture_default_str();
  command->add_option(
      "--stiffness-n-per-m", options->stiffness_N_per_m,
      "Stiffness of the surface, N/m (default: 20000 for exploratory_speed at constant "
      "force, otherwise 1000)");
  command
      ->add_option("--friction", options->order.stroke.material.friction,
                   "Coulomb friction coefficient of the surface")
      ->capture_default_str();
  command
      ->add_option("--probe-diameter-m", options->probe_diameter_m,
                   "Probe diameter, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.tip.diameter_m));
  command
      ->add_option("--applied-force-n", options->applied_force_N,
                   "Applied force, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.force_N));
  command
      ->add_option("--exploratory-speed-m-per-s", options->exploratory_speed_m_per_s,
                   "Exploratory speed, unless --vary varies it")
      ->default_str(number_text(options->order.stroke.speed_m_per_s));
  command->add_option("--turning-rad", options->turning_rad,
                      "Let the tool turn to and fro about an axis normal to the surface, with this "
                      "amplitude, instead of a straight stroke");
  command
      ->add_option("--turning-radius-m", options->turning_radius_m,
                   "Distance of the tip from the axis of a tool that turns")
      ->default_str(number_text(Turning{}.radius_m));
  command
      ->add_option("--jobs", options->jobs,
                   "Number of spacings computed in parallel (default: one for each processor); "
                   "does not affect the result")
      ->check(number_within(1, 256));
  command
      ->add_option("--out", options->out,
                   "Table of the results, one row per spacing and level (TSV)")
      ->required();
  std::map<std::string, SweepMeasure> measures{};
  std::string measure_names{};
  for (const MeasureEntry& entry : sweep_measures()) {
    measures[entry.name] = entry.measure;
    measure_names += std::string(measure_names.empty() ? "" : "|") + entry.name;
  }
  command
      ->add_option(
          "--measure", options->measure,
          "Measure of the printed peaks and of the figure: the maximum acceleration (the default), "
          "its RMS, the power in a band, or the power above the vibrotactile threshold; of a tool "
          "that turns also the RMS torque and force and their powers in the bands")
      ->transform(word_of(measures))
      ->option_text(measure_names);
  add_shard_option(*command, options->shard, "spacings", "asperity gather");
#ifdef ASPERITY_WITH_WINDOWS
  auto* plot = command->add_option("--plot", options->plot,
                                   "Also write a figure of the measure, .svg, .png or .pdf");
  auto* beside = command
                     ->add_option("--beside", options->beside,
                                  "Also show the estimates of the participants of this study in "
                                  "the figure. The sweep needs one level for each condition of the "
                                  "protocol, and the conditions must differ in the varied quantity")
                     ->needs(plot);
  plot->excludes("--shard");
  command
      ->add_option("--protocol", options->protocol,
                   "Protocol of the study given with --beside, NAME[@VERSION]; required if several "
                   "protocols, or "
                   "several versions of one, request estimates of roughness")
      ->needs(beside);
#endif
  command->add_flag("--force", options->force, "Replace the rows of another sweep");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] { return run_sweep(*options); });
  });
}

}  // namespace asperity
