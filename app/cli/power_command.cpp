// asperity power: how many participants a protocol needs, from simulated studies.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/number_list.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/shard_option.h"
#include "app/cli/output/power_output.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/plugins/plugin_files.h"
#include "app/power/calibration.h"
#include "app/power/curve/effect_levels.h"
#include "app/power/curve/ethics_sentence.h"
#include "app/power/curve/power_shard.h"
#include "app/power/curve/simulate_power.h"
#include "app/power/power_model.h"
#include "app/power/simulated_run.h"
#include "app/study_files/program.h"
#include "app/tasks/protocol_files.h"
#include "app/words/text_parts.h"
#include "protocols/file/diagnostic.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"
#ifdef ASPERITY_WITH_WINDOWS
#include "app/figures/figure_files.h"
#include "app/figures/power_curve_figure.h"
#include "app/study_files/height_field_files.h"
#endif

namespace asperity {

namespace {

constexpr int kMostParticipants = 10000;
constexpr const char* kAssumedSource = "stated";
constexpr const char* kStatedSource = "stated as the smallest effect of interest";

struct PowerOptions {
  std::string protocol{};
  std::string participants{};
  std::vector<std::string> effects{};
  std::string effect_source = kStatedSource;
  std::string calibrated_by{};
  std::string assumptions{};
  std::vector<std::string> assumed{};
  bool list_assumptions = false;
  std::int64_t runs = 1000;
  std::optional<std::uint64_t> seed{};
  int jobs = 0;
  Attrition attrition{};
  std::string out{};
  std::optional<Shard> shard{};
  std::string plot{};
  bool force = false;
  bool json = false;
  std::vector<std::filesystem::path> plugins{};

  Overwrite overwrite() const noexcept { return force ? Overwrite::allow : Overwrite::refuse; }
};

/// FROM:TO:STEP or N,N,…
std::vector<int> participants_of(const std::string& text) {
  const std::string expected =
      "write FROM:TO:STEP, such as 10:40:5, or N,N,…, whole numbers in ascending order from 1 to " +
      std::to_string(kMostParticipants);
  const auto refuse = [&] { throw WrongUsage("--participants " + text + ": " + expected); };
  const bool is_range = text.find(':') != std::string::npos;
  std::vector<int> numbers{};
  for (const double number : numbers_of("--participants", text, is_range ? ':' : ',', expected)) {
    if (number != std::floor(number) || number < 1.0 || number > kMostParticipants) refuse();
    if (!is_range && !numbers.empty() && number <= numbers.back()) refuse();
    numbers.push_back(static_cast<int>(number));
  }
  if (!is_range) return numbers;
  if (numbers.size() != 3 || numbers[0] > numbers[1]) refuse();
  std::vector<int> range{};
  for (int number = numbers[0]; number <= numbers[1]; number += numbers[2]) range.push_back(number);
  return range;
}

std::vector<StatedEffect> effects_of(const PowerOptions& options) {
  std::vector<StatedEffect> stated{};
  for (const std::string& text : options.effects) {
    try {
      stated.push_back(stated_effect_in(text));
    } catch (const std::invalid_argument& error) {
      throw WrongUsage(std::string("--effect: ") + error.what());
    }
  }
  return stated;
}

/// Takes what the responses of a study show, and prints what that is.
std::vector<Assumption> calibrated_by(const std::string& folder, const Protocol& protocol,
                                      const std::vector<Assumption>& usual) {
  const Study study = Study::open(folder, Access::read_only);
  std::vector<Assumption> calibrated = calibrated_by_study(usual, protocol, study);
  say_condition(study);
  std::vector<std::string> taken{};
  for (std::size_t i = 0; i < usual.size(); ++i) {
    if (calibrated[i].source != usual[i].source) taken.push_back(calibrated[i].name);
  }
  say(taken.empty() ? "asperity: warning: the responses of the study " + folder +
                          " show none of the assumptions; all keep their usual values"
                    : "asperity: taken from the study " + folder + ": " + listed(taken));
  return calibrated;
}

/// Sets what --assume states.
void assume(const std::vector<std::string>& stated, std::vector<Assumption>& assumptions) {
  for (const std::string& text : stated) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::optional<double> value =
        number_in(std::string_view(text).substr(std::min(equals + 1, text.size())));
    if (!value) {
      throw WrongUsage("--assume " + text +
                       ": write NAME=VALUE with a number, such as order_sd=0.3");
    }
    try {
      set_assumption(assumptions, text.substr(0, equals), *value, kAssumedSource);
    } catch (const std::runtime_error& error) {
      throw WrongUsage("--assume " + text + ": " + error.what());
    }
  }
}

/// The report without its studies.
PowerReport report_of(const PowerOptions& options, const ProtocolCheck& check,
                      const std::vector<Assumption>& assumptions,
                      const std::vector<StatedEffect>& stated) {
  PowerReport report{.protocol = *check.protocol, .cost = check.cost};
  try {
    report.levels = effect_levels(assumptions, stated, options.effect_source);
    report.order.assumptions_sha256 = sha256_of(json_of(without_stated(assumptions, stated)));
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("--effect: ") + error.what());
  }
  for (const EffectLevel& level : report.levels) report.order.effects.push_back(level.text);
  report.order.participants = participants_of(options.participants);
  report.order.seed = *options.seed;
  report.order.runs = options.runs;
  report.order.protocol_sha256 = sha256_of(check.protocol->source);
  report.order.program = version_line();
  report.rules.attrition = options.attrition;
  return report;
}

/// What may be read wrongly, before hours of work.
void say_warnings(const PowerReport& report) {
  const auto multiple = static_cast<int>(report.rules.multiple);
  const bool has_incomplete =
      std::any_of(report.order.participants.begin(), report.order.participants.end(),
                  [multiple](int number) { return number % multiple != 0; });
  if (has_incomplete) {
    say("asperity: warning: one round of counterbalancing rows and groups has " +
        std::to_string(multiple) +
        " participants; a number of --participants that is not a multiple of it has an incomplete "
        "last round");
  }
  for (const Assumption& one : report.levels.front().assumptions) {
    if (!is_from_pilot(one)) continue;
    say("asperity: warning: the effect " + one.name + " is taken from a pilot (" + one.source +
        "), whose estimate is uncertain and, if it was selected for being significant, too large; "
        "state the smallest effect of interest with --effect, or both ends of the pilot's "
        "interval");
  }
}

SimulateStudy simulation_by(const std::vector<PowerModel>& models) {
  return [&models](std::size_t effect, int participants, std::uint64_t seed, std::int64_t run) {
    return simulate_and_analyse(models[effect], participants, seed, run);
  };
}

int jobs_of(const PowerOptions& options) {
  return options.jobs > 0 ? options.jobs
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Simulates the runs of one shard. Power is that of all runs.
int run_shard(const PowerReport& report, const std::vector<PowerModel>& models,
              const PowerOptions& options) {
  const Shard& shard = *options.shard;
  const PowerFiles files{.folder = options.out, .overwrite = options.overwrite()};
  PowerShard outcome{};
  {
    const InterruptWatch interrupt("stopping; the shard is not written");
    Progress progress("simulating studies");
    outcome = simulate_power_shard(report.order, shard, simulation_by(models), jobs_of(options),
                                   files, interrupt.token(),
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

/// Simulates the studies of the report, and prints where they are when it is stopped. The models are those of its levels.
void simulate(PowerReport& report, const std::vector<PowerModel>& models,
              const PowerOptions& options) {
  std::optional<PowerFiles> files{};
  if (!options.out.empty()) {
    files = PowerFiles{.folder = options.out, .overwrite = options.overwrite()};
  }
  const InterruptWatch interrupt(files ? "stopping; simulated studies are kept"
                                       : "stopping; without --out nothing is kept");
  Progress progress("simulating studies");
  report.power =
      simulate_power(report.order, simulation_by(models), jobs_of(options), files,
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

/// Before hours of work whose figure could not be written.
void require_plot([[maybe_unused]] const PowerOptions& options) {
#ifdef ASPERITY_WITH_WINDOWS
  if (options.plot.empty()) return;
  try {
    require_figure_ending(options.plot);
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("--plot: ") + error.what());
  }
  refuse_existing({options.plot}, options.overwrite());
  const std::filesystem::path folder = std::filesystem::path(options.plot).parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder)) {
    throw std::runtime_error("--plot " + options.plot + ": there is no folder " + folder.string() +
                             "; create it first");
  }
#endif
}

int run_power(const PowerOptions& options) {
  const ModelRegistry registry = models_with(options.plugins);
  const ProtocolCheck check =
      check_protocol(options.protocol, registry, std::nullopt, std::nullopt);
  if (!check.diagnostics.empty()) throw ProtocolError(check.diagnostics);
  std::vector<Assumption> assumptions = assumptions_of(*check.protocol);
  if (!options.calibrated_by.empty()) {
    assumptions = calibrated_by(options.calibrated_by, *check.protocol, assumptions);
  }
  if (!options.assumptions.empty()) {
    assumptions = with_assumptions_of_file(std::move(assumptions), options.assumptions);
  }
  assume(options.assumed, assumptions);
  if (options.list_assumptions) {
    std::cout << json_of(assumptions);
    return 0;
  }
  if (options.participants.empty() || !options.seed) {
    throw WrongUsage(
        "power requires --participants and --seed, unless --list-assumptions is given");
  }
  require_plot(options);
  PowerReport report = report_of(options, check, assumptions, effects_of(options));
  std::vector<PowerModel> models{};
  for (const EffectLevel& level : report.levels) {
    models.emplace_back(*check.protocol, level.assumptions);
  }
  report.rules.multiple = static_cast<std::size_t>(models.front().multiple());
  say_warnings(report);
  if (options.shard) return run_shard(report, models, options);
  simulate(report, models, options);
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
    write_figure(options.plot, power_curve_figure(report.power.curves), {}, options.overwrite());
  }
#endif
  return 0;
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
  command->add_flag("--list-assumptions", options->list_assumptions,
                    "Print all assumptions of the protocol as JSON, to be edited, and end");
  command
      ->add_option("--runs", options->runs,
                   "Number of simulated studies of each effect and number of participants")
      ->capture_default_str()
      ->check(number_within<std::int64_t>(1, 9'999'999));
  command->add_option("--seed", options->seed, "Seed; the same seed gives the same studies");
  command
      ->add_option(
          "--jobs", options->jobs,
          "Number of studies simulated in parallel (default: one for each processor); does "
          "not affect the results")
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
      ->add_option("--plot", options->plot, "Also write a figure of the power, .svg, .png or .pdf")
      ->excludes(shard);
#endif
  command->add_flag("--force", options->force,
                    "Replace the studies of other inputs, and the figure");
  command->add_flag("--json", options->json, "Print one JSON document")->excludes(shard);
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] { return run_power(*options); });
  });
}

}  // namespace asperity
