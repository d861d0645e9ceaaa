// asperity power: how many participants a protocol needs, from simulated studies.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/shard_option.h"
#include "app/cli/output/power_output.h"
#include "app/cli/output/terminal.h"
#include "app/cli/power/power_request.h"
#include "app/cli/signals.h"
#include "app/plugins/plugin_files.h"
#include "app/power/curve/power_shard.h"
#include "app/power/curve/simulate_power.h"
#include "app/power/power_model.h"
#include "app/power/simulated_run.h"
#include "app/tasks/check_protocol.h"
#include "app/virtual_studies/physics_studies.h"
#include "protocols/file/diagnostic.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/power/curve/power_curve_figure.h"
#include "app/study_files/drawn_figures.h"
#include "app/study_files/height_field_files.h"
#endif

namespace asperity {

namespace {

int jobs_of(const PowerOptions& options) {
  return options.jobs > 0 ? options.jobs
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// What makes the studies.
struct StudySource {
  /// Studies that end early after a stop request, where they take long.
  std::function<SimulateStudy(const std::stop_token&)> until{};
  int jobs = 1;  ///< studies that are simulated at the same time
};

/// The models are those of the levels of the report. They must outlive the source.
StudySource source_by(const std::vector<PowerModel>& models, const PowerOptions& options) {
  const SimulateStudy simulate = [&models](std::size_t effect, int participants, std::uint64_t seed,
                                           std::int64_t run) {
    return simulate_and_analyse(models[effect], participants, seed, run);
  };
  return {.until = [simulate](const std::stop_token&) { return simulate; },
          .jobs = jobs_of(options)};
}

/// One study at a time, which has all jobs. `studies` must outlive the source.
StudySource source_by(PhysicsStudies& studies) {
  return {.until = [&studies](const std::stop_token& stop) -> SimulateStudy {
    return [&studies, stop](std::size_t, int participants, std::uint64_t seed, std::int64_t run) {
      return studies.outcomes(participants, seed, run, stop);
    };
  }};
}

PowerFiles files_of(const PowerOptions& options) {
  return {.folder = options.out, .overwrite = options.overwrite()};
}

/// Simulates the runs of one shard. Power is that of all runs.
int run_shard(const PowerReport& report, const StudySource& source, const PowerOptions& options) {
  const Shard& shard = *options.shard;
  const PowerFiles files = files_of(options);
  PowerShard outcome{};
  {
    const InterruptWatch interrupt("stopping; the shard is not written");
    Progress progress("simulating studies");
    outcome = simulate_power_shard(report.order, shard, source.until(interrupt.token()),
                                   source.jobs, files, interrupt.token(),
                                   [&progress](double fraction) { progress.show(fraction); });
  }
  if (outcome == PowerShard::stopped) {
    say("asperity: shard " + text_of(shard) +
        " was stopped and nothing was written; repeat the command to simulate it");
    return 1;
  }
  const auto runs = static_cast<std::size_t>(report.order.runs);
  std::cout << shard_path(files.studies(), shard).string() << ": shard " << text_of(shard) << ", "
            << (outcome == PowerShard::stored_before
                    ? "already simulated by an earlier command"
                    : counted(shard.number_of(runs), "run") + " of " + std::to_string(runs))
            << '\n';
  return 0;
}

/// Simulates the studies of the report.
void simulate(PowerReport& report, const StudySource& source, const PowerOptions& options) {
  std::optional<PowerFiles> files{};
  if (!options.out.empty()) files = files_of(options);
  const InterruptWatch interrupt(files ? "stopping; simulated studies are kept"
                                       : "stopping; without --out nothing is kept");
  Progress progress("simulating studies");
  report.power =
      simulate_power(report.order, source.until(interrupt.token()), source.jobs, files,
                     interrupt.token(), [&progress](double fraction) { progress.show(fraction); });
}

void say_stopped(const PowerReport& report, const PowerOptions& options) {
  say(options.out.empty()
          ? "asperity: the simulation was stopped, and nothing was kept; add --out FOLDER to be "
            "able to continue it"
          : "asperity: the simulation was stopped; complete runs in " + options.out + ": " +
                std::to_string(report.power.runs) + " of " + std::to_string(report.order.runs) +
                "; repeat the command to continue it");
}

#ifdef ASPERITY_WITH_WINDOWS
/// A figure that an earlier command drew from the same studies is replaced.
Overwrite overwrite_of_plot(const PowerOptions& options) {
  if (options.out.empty()) return options.overwrite();
  return DrawnFigures(files_of(options).figures()).overwrite_of(options.plot, options.overwrite());
}
#endif

/// Before hours of work whose figure could not be written.
void require_plot([[maybe_unused]] const PowerOptions& options) {
#ifdef ASPERITY_WITH_WINDOWS
  if (options.plot.empty()) return;
  try {
    require_figure_ending(options.plot);
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("--plot: ") + error.what());
  }
  refuse_existing({options.plot}, overwrite_of_plot(options));
  const std::filesystem::path folder = std::filesystem::path(options.plot).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw std::runtime_error("--plot " + options.plot + ": there is no folder " + folder.string() +
                             "; create it first");
  }
#endif
}

/// Simulates the studies, and prints and writes the results.
int finish(PowerReport& report, const StudySource& source, const PowerOptions& options) {
  say_warnings(report);
  if (options.shard) return run_shard(report, source, options);
  simulate(report, source, options);
  if (!report.power.is_complete) {
    say_stopped(report, options);
    return 1;
  }
  if (!options.out.empty()) write_power(options.out, report);
  if (options.json) {
    std::cout << json_of(report).dump(2) << '\n';
  } else {
    print_power(report);
  }
  say_true_sizes(report);
#ifdef ASPERITY_WITH_WINDOWS
  if (!options.plot.empty()) {
    const LettersWithoutWindows letters;
    write_figure(options.plot, power_curve_figure(report.power.curves), {},
                 overwrite_of_plot(options));
    if (!options.out.empty()) DrawnFigures(files_of(options).figures()).record(options.plot);
  }
#endif
  return 0;
}

int run_power(const PowerOptions& options) {
  require_one_source(options);
  const ModelRegistry registry = models_with(options.plugins);
  const ProtocolCheck check =
      check_protocol(options.protocol, registry, std::nullopt, std::nullopt);
  if (!check.diagnostics.empty()) throw ProtocolError(check.diagnostics);
  std::vector<Assumption> assumptions{};
  if (!options.physics) assumptions = stated_assumptions(options, *check.protocol);
  if (options.list_assumptions) {
    std::cout << json_of(assumptions);
    return 0;
  }
  if (options.participants.empty() || !options.seed) {
    throw WrongUsage(
        "power requires --participants and --seed, unless --list-assumptions is given");
  }
  require_plot(options);
  if (options.physics) {
    PhysicsStudies studies(*check.protocol,
                           {.study = options.study,
                            .participants = participants_of(options),
                            .jobs = jobs_of(options),
                            .warned =
                                [&options](Diagnostic warning) {
                                  warning.file = options.protocol;
                                  say(warning_text(warning));
                                }},
                           registry);
    PowerReport report = report_of_physics(options, check, studies);
    return finish(report, source_by(studies), options);
  }
  PowerReport report = report_of_tables(options, check, assumptions);
  std::vector<PowerModel> models{};
  for (const EffectLevel& level : report.levels) {
    models.emplace_back(*check.protocol, level.assumptions);
  }
  return finish(report, source_by(models, options), options);
}

}  // namespace

void add_power(CLI::App& program, Job& job) {
  auto options = std::make_shared<PowerOptions>();
  CLI::App* command = program.add_subcommand(
      "power", "Simulate studies of a protocol: power and precision by number of participants.");
  command->add_option("PROTOCOL", options->protocol, "Protocol file")->required();
  command->add_option("--participants", options->participants,
                      "Numbers of participants, FROM:TO:STEP or N,N,…");
  command
      ->add_option(
          "--effect", options->effects,
          "Effect to be found, NAME=VALUE[,VALUE…] in its unit, or null for the value without "
          "an effect; may be given several times, with several values once. Names: "
          "--list-assumptions")
      ->option_text("NAME=VALUE,…")
      ->allow_extra_args(false);  // one for each time the option is given
  command
      ->add_option(
          "--effect-source", options->effect_source,
          "Where the values of --effect are from; one that begins with \"pilot\" is marked")
      ->capture_default_str();
  command
      ->add_option("--calibrate", options->calibrated_by,
                   "Study whose responses show assumptions that take the place of the usual ones: "
                   "a pilot, or a simulated study; effects are never taken from it")
      ->option_text("STUDY");
  command->add_option("--assumptions", options->assumptions,
                      "File with assumptions in place of the usual ones and those of --calibrate "
                      "(JSON, as printed by --list-assumptions)");
  command
      ->add_option("--assume", options->assumed,
                   "Value of one assumption, NAME=VALUE in its unit, in place of that of the file, "
                   "the study or the usual one; may be given several times")
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option("--assume-source", options->assumed_source,
                   "Where the values of --assume are from, such as a study")
      ->capture_default_str();
  command->add_flag("--list-assumptions", options->list_assumptions,
                    "Print all assumptions of the protocol as JSON, to be edited, and end");
  command->add_flag("--physics", options->physics,
                    "Simulate the virtual observers of the protocol on the full physics, as "
                    "asperity simulate does, in place of response tables");
  command
      ->add_option("--study", options->study,
                   "With --physics: study that has the files which the protocol names; it is not "
                   "changed")
      ->option_text("STUDY");
  command
      ->add_option("--runs", options->runs,
                   "Number of simulated studies of each effect and number of participants")
      ->capture_default_str()
      ->check(number_within<std::int64_t>(1, 9'999'999));
  command->add_option("--seed", options->seed, "Seed; the same seed gives the same studies");
  command
      ->add_option("--jobs", options->jobs,
                   "Number of studies, or with --physics of sessions, simulated in parallel "
                   "(default: one for "
                   "each processor); does not affect the results")
      ->check(number_within(1, 256));
  command
      ->add_option("--dropout", options->attrition.dropout,
                   "Proportion of participants without complete data, for the number to recruit")
      ->capture_default_str()
      ->check(number_within(0.0, 0.95));
  command
      ->add_option("--exclusion", options->attrition.exclusion,
                   "Proportion of participants with complete data who are excluded, beyond the "
                   "exclusions of the protocol, for the number to recruit")
      ->capture_default_str()
      ->check(number_within(0.0, 0.95));
  auto* out = command->add_option(
      "--out", options->out,
      "Folder of the simulated studies and the tables; repeating the command resumes "
      "a stopped simulation and adds runs");
  auto* shard = add_shard_option(*command, options->shard, "runs", "asperity gather")->needs(out);
#ifdef ASPERITY_WITH_WINDOWS
  command
      ->add_option(
          "--plot", options->plot,
          "Also write a figure of the power, .svg, .png or .pdf; one that was drawn from the "
          "studies of --out before is replaced")
      ->excludes(shard);
#endif
  command->add_flag(
      "--force", options->force,
      "Replace the studies of other inputs, and a figure that was not drawn from those of --out");
  command->add_flag("--json", options->json, "Print one JSON document")->excludes(shard);
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] { return run_power(*options); });
  });
}

}  // namespace asperity
