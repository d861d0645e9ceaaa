// asperity simulate: virtual participants through the whole study.

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/compute_option.h"
#include "app/cli/options/external_option.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/shard_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/session_output.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/device_bench/device_choice.h"
#include "app/plugins/plugin_files.h"
#include "app/study_files/protocol_languages.h"
#include "app/study_files/study_condition.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/simulation/simulation_shard.h"

namespace asperity {

void add_simulate(CLI::App& program, Job& job) {
  struct Options {
    SimulationInputs inputs{};
    ExternalOptions external{};
    std::optional<std::string> language{};
    bool json = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "simulate", "Add virtual participants to a study; each completes all given protocols.");
  command
      ->add_option("PROTOCOL", options->inputs.protocols,
                   "Protocol files, in the order of the sessions")
      ->required();
  command
      ->add_option("--study", options->inputs.study,
                   "Folder of the study (created if it does not exist)")
      ->required();
  command->add_option("--language", options->language,
                      "Language of the texts, such as de: that of the protocols or of their "
                      "translations NAME.LANGUAGE.json; by default that of each PROTOCOL");
  command
      ->add_option("--participants", options->inputs.participants, "Number of participants to add")
      ->required()
      ->check(number_within(1, 9999));
  command
      ->add_option("--device", options->inputs.device,
                   "Simulated device that the virtual hands hold: simulated, "
                   "simulated:MODEL[,PROPERTY=VALUE…]")
      ->capture_default_str();
  add_external_options(*command, options->external);
  command->add_option("--seed", options->inputs.seed, "Seed; the same seed gives the same results")
      ->required();
  command
      ->add_option("--jobs", options->inputs.jobs,
                   "Number of sessions that run in parallel; does not affect the results")
      ->check(number_within(1, 256));
  const std::map<std::string, Recordings> recordings{
      {"all", Recordings::all}, {"first", Recordings::first}, {"none", Recordings::none}};
  command
      ->add_option(
          "--recordings", options->inputs.recordings,
          "Keep the tick records of all participants, of the first one (the default), or of none")
      ->transform(word_of(recordings))
      ->option_text("all|first|none");
  CLI::Option* const resume =
      command->add_flag("--resume", options->inputs.resume,
                        "Resume an interrupted simulation with the same arguments");
  add_shard_option(*command, options->inputs.shard, "participants", "asperity merge")
      ->excludes(resume);
  command->add_flag("--json", options->json, "Print the totals as JSON");
  add_compute_option(*command, options->inputs.on_gpu, kComputeOfSession);
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    const auto run = [options] {
      require_device("--device", options->inputs.device);
      options->inputs.level_program = options->external.chosen();
      const InterruptWatch interrupt("stopping after the trials that are running");
      const ModelRegistry models = models_with(options->plugins);
      const std::filesystem::path& folder = options->inputs.study;
      if (Study::exists(folder) ||
          (std::filesystem::exists(folder) && !std::filesystem::is_directory(folder))) {
        // Before it is opened for writing, which takes away a checksum that holds; and before the
        // protocols' files are missed in what is no study.
        const Study before = Study::open(folder, Access::read_only);
        refuse_if_broken(before);
        say_condition(before);
      }
      for (std::filesystem::path& file : options->inputs.protocols) {
        if (!options->language) break;
        file = protocol_in_language(found_protocol(file, folder), *options->language);
      }
      options->inputs.noticed = [&options](const SameSeed& others) {
        const int added = options->inputs.participants;
        say("asperity: warning: the study already has " +
            counted(static_cast<std::size_t>(others.there), "participant") + " with the seed " +
            std::to_string(options->inputs.seed) + "; " +
            (added == 1 ? others.first + " is added"
                        : others.first + " to " + others.last + " are added") +
            ". To resume a simulation instead, add --resume");
      };
      options->inputs.warned = [](const Diagnostic& warning) { say(warning_text(warning)); };
      const auto simulated = [&]() -> SimulatedShard {
        Progress progress("simulating");
        const auto show = [&progress](double fraction) { progress.show(fraction); };
        const SimulationInputs& inputs = options->inputs;
        if (inputs.shard) return simulate_shard(inputs, models, interrupt.token(), show, say_done);
        try {
          return {folder, simulate(inputs, models, interrupt.token(), show, say_done)};
        } catch (const SimulationStopped& stopped) {
          throw std::runtime_error(
              stopped.said().english() +
              (inputs.resume ? "; repeat the command to resume it" : "; resume with --resume"));
        }
      }();
      // Without sessions where an earlier command simulated this shard.
      const SimulationResult result = simulated.result.value_or(SimulationResult{});
      if (options->json) {
        const nlohmann::ordered_json json{{"format", "asperity.simulate/1"},
                                          {"sessions", result.sessions},
                                          {"attempts", result.attempts},
                                          {"simulated_s", result.simulated_s},
                                          {"wall_s", result.wall_s}};
        std::cout << json.dump(2) << '\n';
      } else {
        if (options->inputs.shard) {
          std::cout << simulated.study.string() << ": shard " << text_of(*options->inputs.shard)
                    << ", "
                    << (simulated.result ? "" : "already simulated by an earlier command; ");
        }
        std::cout << counted(result.sessions, "session") << ", "
                  << counted(result.attempts, "attempt") << ", " << fixed(result.simulated_s, 0)
                  << " s of sessions in " << fixed(result.wall_s, 1) << " s\n";
      }
      return 0;
    };
    job = watched_with(options->plugins, with_lasting_effect(run));
  });
}

}  // namespace asperity
