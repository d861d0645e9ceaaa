// asperity bench: what a tick takes on this computer, next to figures that publications state.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/study_files/height_field_files.h"
#include "app/timing/tick_table.h"
#include "app/timing/timed_scenes.h"
#include "app/timing/timing_machine.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

namespace {

constexpr std::size_t kEvicted_bytes = 32 << 20;  // more than the caches of a core

struct BenchOptions {
  TimingOrder order{};
  bool cold_caches = false;
  int seconds = 10;
  std::optional<std::filesystem::path> out{};
  bool list = false;
  bool json = false;
  bool force = false;
};

void list_scenes(bool as_json) {
  nlohmann::ordered_json json{{"format", "asperity.bench/1"},
                              {"scenes", nlohmann::ordered_json::array()}};
  Table table{.columns = {"scene", "meaning"}};
  for (const TimedScene& each : timed_scenes()) {
    json["scenes"].push_back({{"name", each.name}, {"meaning", each.meaning}});
    table.rows.push_back({std::string(each.name), std::string(each.meaning)});
  }
  std::cout << (as_json ? json.dump(2) + '\n' : aligned(table));
}

nlohmann::ordered_json json_cell(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

void print_rows_as_json(const Table& table, const std::vector<std::string>& warnings) {
  nlohmann::ordered_json json{{"format", "asperity.bench/1"},
                              {"warnings", warnings},
                              {"rows", nlohmann::ordered_json::array()}};
  for (const std::vector<Cell>& row : table.rows) {
    nlohmann::ordered_json one;
    for (std::size_t i = 0; i < row.size(); ++i) one[table.columns[i]] = json_cell(row[i]);
    json["rows"].push_back(std::move(one));
  }
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

void print_rows(const std::vector<TimedRow>& rows, const TimingMachine& machine) {
  std::cout << machine.program << ", " << machine.compiler << ", " << machine.instruction_set
            << '\n'
            << machine.processor << ", " << counted(machine.cores, "core") << '\n'
            << '\n'
            << aligned(short_tick_table(rows)) << '\n';
  for (const std::string& note : tick_notes(rows)) std::cout << note << '\n';
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error{};
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(
        "--bodies " + folder.string() + " is not a folder and cannot be made: " +
        (error ? error.message() : "it is a file") + "; choose another folder");
  }
}

TimingOutcome measured(const TimingOrder& order) {
  const InterruptWatch interrupt("stopping; the rows until now are printed");
  std::optional<Progress> progress{};
  const TimingCourse course{
      .stop = interrupt.token(),
      .begin_step = [&progress](const std::string& step) { progress.emplace(step); },
      .progress =
          [&progress](double fraction) {
            if (progress) progress->show(fraction);
          }};
  return time_scenes(order, course);
}

int run_bench(BenchOptions options) {
  if (options.list) {
    list_scenes(options.json);
    return 0;
  }
  const Overwrite overwrite = options.force ? Overwrite::allow : Overwrite::refuse;
  if (options.out) refuse_existing({*options.out}, overwrite);
  TimingOrder& order = options.order;
  order.ticks.longest = std::chrono::seconds(options.seconds);
  order.ticks.warm_up = std::max(1, order.ticks.counted / 10);
  if (options.cold_caches) order.ticks.evicted_bytes = kEvicted_bytes;
  order.bodies.jobs = std::clamp(std::thread::hardware_concurrency(), 1U, 256U);
  if (order.scenes.empty() && order.meshes.empty()) {
    for (const TimedScene& each : timed_scenes()) order.scenes.emplace_back(each.name);
  }
  if (order.bodies.folder) make_folder(*order.bodies.folder);
  const TimingMachine machine = this_machine();
  const std::vector<std::string> warnings = timing_warnings(machine);
  for (const std::string& warning : warnings) say("asperity: warning: " + warning);
  const TimingOutcome outcome = measured(order);
  const Table table = tick_table(outcome.rows, machine);
  if (options.json) {
    print_rows_as_json(table, warnings);
  } else {
    print_rows(outcome.rows, machine);
  }
  if (!outcome.is_complete) {
    say("asperity: the measurement was stopped" +
        std::string(options.out ? ", and no table was written" : "") +
        "; repeat the command to begin it again");
    return 1;
  }
  if (options.out) {
    write_file(*options.out, tsv_of(table), overwrite);
    if (!options.json) {
      std::cout << options.out->string() << ": " << counted(table.rows.size(), "row") << '\n';
    }
  }
  return 0;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const TimedScene& each : timed_scenes()) names.emplace_back(each.name);
  return names;
}

}  // namespace

void add_bench(CLI::App& program, Job& job) {
  auto options = std::make_shared<BenchOptions>();
  TimingOrder& order = options->order;
  CLI::App* command = program.add_subcommand(
      "bench",
      "Measure the time of a tick on this computer: textured bodies in contact, models of a point, "
      "and the whole loop of a session, next to published figures.");
  command
      ->add_option("--scene", order.scenes,
                   "A scene that --list names; may be given several times (default: all)")
      ->allow_extra_args(false)
      ->check(word_among(scene_names()))
      ->option_text("SCENE ...");
  command
      ->add_option("--mesh", order.meshes,
                   "A mesh as for bake, or a textured mesh (.mesh), moved over the textured block; "
                   "may be given several times. Without --scene only meshes are measured")
      ->allow_extra_args(false);
  command->add_option("--unit-m", order.reading.unit_m, "Length of one unit of --mesh, in metres")
      ->capture_default_str();
  command
      ->add_option("--triangles", order.bodies.triangles,
                   "Triangles of each generated body before simplification (default: the published "
                   "sizes, 300000 where there are none)")
      ->check(number_within(1000, 5'000'000));
  command->add_option(
      "--bodies", order.bodies.folder,
      "Folder in which generated bodies are kept, so that the next measurement need "
      "not simplify them again");
  command->add_option("--ticks", order.ticks.counted, "Number of ticks of a row")
      ->capture_default_str()
      ->check(number_within(1, 10'000'000));
  command
      ->add_option("--seconds", options->seconds,
                   "Longest time of a row; a slower row has fewer ticks")
      ->capture_default_str()
      ->check(number_within(1, 86'400));
  command->add_flag("--cold-caches", options->cold_caches,
                    "Write other data before each tick, so that the caches do not contain what it "
                    "needs, as in a loop that sleeps between its ticks");
  command->add_option("--out", options->out, "Table of all columns (TSV)");
  command->add_flag("--list", options->list, "Print the scenes, and measure nothing");
  command->add_flag("--json", options->json, "Print the table as JSON");
  command->add_flag("--force", options->force, "Replace an existing table");
  command->callback(
      [options, &job] { job = with_lasting_effect([options] { return run_bench(*options); }); });
}

}  // namespace asperity
