// asperity clean-stiffness: the largest stiffness without perceived instability.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/options/model_option.h"
#include "app/cli/options/number_list.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/parameter_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/plugins/plugin_files.h"
#include "app/study_files/height_field_files.h"
#include "app/sweep/clean_stiffness_table.h"
#include "device/simulated_models.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

struct CleanStiffnessOptions {
  std::vector<std::string> models{};
  std::vector<std::string> parameters{};
  std::string amplitudes = "0.0001,0.0005";
  std::string wavelengths = "0.002,0.004";
  std::string rates = "500,1000,2000";
  std::string range = "100:409600";
  CleanStiffnessOrder order{};
  int jobs = 0;
  std::filesystem::path out{};
  bool force = false;
  std::vector<std::filesystem::path> plugins{};
};

std::vector<double> lengths_of(const std::string& option, const std::string& text) {
  constexpr double kLongest_m = 0.1;
  const std::string expected = "write lengths in metres, such as 0.001,0.002";
  std::vector<double> lengths_m = numbers_of(option, text, ',', expected);
  for (const double length_m : lengths_m) {
    if (length_m <= kLongest_m) continue;
    throw WrongUsage(option + " " + text + ": a length is at most 0.1 m; " + expected);
  }
  return lengths_m;
}

/// Completes the order. It refers to models of the registry.
void complete_clean_stiffness(CleanStiffnessOptions& options, const ModelRegistry& models) {
  CleanStiffnessOrder& order = options.order;
  for (const std::string& id : options.models) order.models.push_back(&model_named(models, id));
  if (!options.parameters.empty() && order.models.size() > 1) {
    throw WrongUsage("--param sets a parameter of one force model, and " +
                     std::to_string(order.models.size()) +
                     " are given; run the command once for each, or leave out --param");
  }
  if (!options.parameters.empty()) {
    order.parameters = parameters_from(
        options.parameters, order.models.front()->declaration.parameters, options.models.front());
  }
  order.amplitudes_m = lengths_of("--amplitudes", options.amplitudes);
  order.wavelengths_m = lengths_of("--wavelengths", options.wavelengths);
  order.rates_Hz =
      numbers_of("--rates", options.rates, ',', "write rates in hertz, such as 500,1000");
  const std::vector<double> range =
      numbers_of("--stiffness-range", options.range, ':', "write LEAST:MOST, such as 100:409600");
  if (range.size() != 2) {
    throw WrongUsage("--stiffness-range " + options.range +
                     " does not have two numbers; write LEAST:MOST, in N/m, such as 100:409600");
  }
  order.search.least_N_per_m = range[0];
  order.search.most_N_per_m = range[1];
  const std::optional<SimulatedDeviceSettings> device = simulated_settings(order.device);
  if (!device) {
    throw WrongUsage("--device " + order.device +
                     " is not a simulated device; write simulated or simulated:MODEL, such as "
                     "simulated:falcon");
  }
  order.loop.device = *device;
}

int run_clean_stiffness(CleanStiffnessOptions options) {
  const ModelRegistry models = models_with(options.plugins);
  complete_clean_stiffness(options, models);
  const std::filesystem::path declaration = options.out.string() + ".json";
  const Overwrite overwrite = options.force ? Overwrite::allow : Overwrite::refuse;
  refuse_existing({options.out, declaration}, overwrite);
  const int jobs = options.jobs > 0
                       ? options.jobs
                       : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::optional<std::vector<CleanStiffnessRow>> rows{};
  {
    const InterruptWatch interrupt("stopping; no table is written");
    Progress progress("searching");
    rows = clean_stiffness_rows(options.order, jobs, interrupt.token(),
                                [&progress](double fraction) { progress.show(fraction); });
  }
  if (!rows) {
    say("asperity: the search was stopped, and no table was written; repeat the command to begin "
        "it again");
    return 1;
  }
  const Table table = table_of(*rows);
  write_files_together({{declaration, declaration_of(options.order)}, {options.out, tsv_of(table)}},
                       overwrite);
  std::cout << options.out.string() << ": " << counted(rows->size(), "row") << ", "
            << options.order.device << '\n'
            << aligned(table);
  return 0;
}

}  // namespace

void add_clean_stiffness(CLI::App& program, Job& job) {
  auto options = std::make_shared<CleanStiffnessOptions>();
  CleanStiffnessOrder& order = options->order;
  CLI::App* command = program.add_subcommand(
      "clean-stiffness",
      "Find the largest stiffness at which a simulated stroke shows no perceived instability, by "
      "force model, amplitude, wavelength and servo rate.");
  command
      ->add_option("--model", options->models,
                   "A force model of a point; may be given several times; see: asperity models")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--param", options->parameters, "Parameter of a single model, NAME=VALUE");
  command
      ->add_option("--amplitudes", options->amplitudes,
                   "Amplitudes of the sinusoidal texture, A,A,…, in metres")
      ->capture_default_str();
  command->add_option("--wavelengths", options->wavelengths, "Its wavelengths, L,L,…, in metres")
      ->capture_default_str();
  command->add_option("--rates", options->rates, "Servo rates, R,R,…, in hertz, above 300")
      ->capture_default_str();
  command
      ->add_option("--device", order.device,
                   "Simulated device that the virtual hand holds: simulated, "
                   "simulated:MODEL[,PROPERTY=VALUE…]; by default an arm of 0.1 kg and 1 N s/m")
      ->capture_default_str();
  command
      ->add_option("--stiffness-range", options->range, "Range of the search, LEAST:MOST, in N/m")
      ->capture_default_str();
  command->add_option("--tolerance", order.search.tolerance, "Tolerance of the stiffness, relative")
      ->capture_default_str()
      ->check(number_within(1e-4, 1.0));
  command
      ->add_option("--buzz-limit", order.search.buzz_limit,
                   "A stroke with a greater value of the detector of buzz is not clean")
      ->capture_default_str()
      ->check(number_within(0.01, 100.0));
  command
      ->add_option("--buzz-force-limit-n", order.search.buzz_force_limit_N,
                   "A stroke with a greater unexplained vibration, RMS in N, is not clean either; "
                   "0.02 is about the threshold of detection of a force on a pen (Lee and "
                   "Hannaford 2003)")
      ->capture_default_str()
      ->check(number_within(0.001, 100.0));
  command
      ->add_option("--strokes", order.loop.strokes,
                   "Number of simulated hands that stroke at each stiffness; all must be clean")
      ->capture_default_str()
      ->check(number_within(1, 1000));
  command->add_option("--friction", order.friction, "Coulomb friction coefficient of the surface")
      ->capture_default_str()
      ->check(number_within(0.0, 10.0));
  command
      ->add_option("--applied-force-n", order.loop.habits.normal_force_N,
                   "Normal force of the hand, N")
      ->capture_default_str()
      ->check(number_within(0.01, 100.0));
  command
      ->add_option("--exploratory-speed-m-per-s", order.loop.habits.speed_m_per_s,
                   "Speed of the strokes, m/s")
      ->capture_default_str()
      ->check(number_within(0.001, 1.0));
  command->add_option("--seed", order.loop.seed, "Seed of the simulated hands")
      ->capture_default_str();
  command
      ->add_option("--jobs", options->jobs,
                   "Number of combinations searched in parallel (default: one for each "
                   "processor); does not affect the result")
      ->check(number_within(1, 256));
  command->add_option("--out", options->out, "Table of the results, one row per combination (TSV)")
      ->required();
  command->add_flag("--force", options->force, "Replace an existing table");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins,
                       with_lasting_effect([options] { return run_clean_stiffness(*options); }));
  });
}

}  // namespace asperity
