// asperity run: one session.

#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <unistd.h>

#include <CLI/CLI.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/compute_option.h"
#include "app/cli/options/driver_options.h"
#include "app/cli/options/external_option.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/options/word_option.h"
#include "app/cli/output/session_output.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/device_bench/device_choice.h"
#include "app/plugins/plugin_files.h"
#include "app/session/new_seed.h"
#include "app/session/respondents/terminal_respondent.h"
#include "app/session/session_setup.h"
#include "app/tasks/label_notice.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/run_session.h"
#include "app/tasks/session_language.h"
#include "app/tasks/warnings/plugin_warnings.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

namespace {

/// Before anybody is asked anything.
void tell_what_a_terminal_lacks(const Protocol& protocol) {
  if (protocol.masking_noise.kind != Protocol::Noise::Kind::none) {
    say("asperity: warning: the protocol requires masking noise, which is not played at a "
        "terminal; this is stored with the session and stated in the report. To play the noise, "
        "run the session in the program's windows");
  }
  if (guides_participants(protocol)) {
    say("asperity: the protocol guides the participant's hand by bars, a target or tones; a "
        "terminal cannot present them, and the report states this. To present them, run the "
        "session in the program's windows");
  }
}

/// Of builds of the plug-ins whose attempts would be analysed together with those of this session.
void warn_of_other_builds(const RunInputs& inputs, const Study& study,
                          const ModelRegistry& models) {
  const Protocol protocol = load_protocol(inputs.protocol, models, inputs.study);
  const SessionMode mode = inputs.is_virtual ? SessionMode::simulate : inputs.mode;
  for (const Diagnostic& warning :
       warnings_about_plugins({protocol, inputs.protocol.string()}, study, models, mode)) {
    say(warning_text(warning));
  }
}

}  // namespace

void add_run(CLI::App& program, Job& job) {
  struct Options {
    RunInputs inputs{};
    ExternalOptions external{};
    std::optional<std::uint64_t> seed{};
    std::optional<std::string> language{};
    bool fast = false;
    bool realtime = false;
    bool allows_similar_label = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("run", "Run one session.");
  command->add_option("PROTOCOL", options->inputs.protocol, "Protocol file")->required();
  command->add_option("--language", options->language,
                      "Language of the texts for the participant, such as de: that of the protocol "
                      "or of its translation NAME.LANGUAGE.json; by default that of the "
                      "participant's earlier sessions, or else of PROTOCOL");
  command->add_option("--study", options->inputs.study, "Folder of the study")->required();
  command
      ->add_option("--participant", options->inputs.participant,
                   "Label: 1 to 32 letters and digits")
      ->required();
  CLI::Option* similar =
      command->add_flag("--allow-similar-label", options->allows_similar_label,
                        "Accept the label of a new participant that differs from another label of "
                        "the study only in letter case or leading zeros. Without this option it is "
                        "refused; at a terminal it has to be confirmed");
  command
      ->add_option("--device", options->inputs.device,
                   "Device to run on: a name listed by asperity devices; NAME:SERIAL if several "
                   "are attached")
      ->capture_default_str();
  add_driver_options(*command, options->inputs.driver_options);
  add_external_options(*command, options->external);
  command->add_option("--seed", options->seed, "Seed of the session; drawn at random by default");
  CLI::Option* group =
      command->add_option("--group", options->inputs.group,
                          "Group of the participant, if the experimenter assigns the protocol's "
                          "groups");
  const std::map<std::string, SessionMode> modes{{"run", SessionMode::run},
                                                 {"pilot", SessionMode::pilot}};
  command
      ->add_option("--mode", options->inputs.mode,
                   "run (the default): study data, on a device with motors (or without, if the "
                   "protocol sets device.input_only); pilot: any device, marked as pilot data")
      ->transform(word_of(modes))
      ->option_text("run|pilot");
  CLI::Option* resume =
      command->add_flag("--resume", options->inputs.resume, "Resume an unfinished session");
  command
      ->add_option(
          "--late-reason", options->inputs.late_reason,
          "Reason for resuming a session that is older than the protocol's maximum_age_hours")
      ->needs(resume);
  resume->excludes(group)->excludes(similar);
  CLI::Option* stand_in =
      command->add_flag("--virtual", options->inputs.is_virtual,
                        "Simulate the participant with a virtual hand and a virtual observer");
  CLI::Option* fast = command->add_flag("--as-fast-as-possible", options->fast,
                                        "Run on a simulated clock (default with --virtual)");
  CLI::Option* realtime = command->add_flag("--realtime", options->realtime, "Run in real time");
  fast->needs(stand_in)->excludes(realtime);
  realtime->needs(stand_in);
  add_compute_option(*command, options->inputs.on_gpu, kComputeOfSession);
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = [options]() -> int {
      RunInputs& inputs = options->inputs;
      inputs.driver_options.tell = say;
      inputs.level_program = options->external.chosen();
      if (const auto complaint = complaint_about_label(inputs.participant, inputs.is_virtual)) {
        throw PhrasedError(*complaint);
      }
      require_device("--device", inputs.device);
      inputs.seed = options->seed ? *options->seed : new_seed();
      inputs.pacing =
          inputs.is_virtual && !options->realtime ? RunPacing::stepped : RunPacing::real_time;
      std::optional<TerminalRespondent> person{};
      if (!inputs.is_virtual) {
        if (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0) {
          throw WrongUsage(
              "run asks the participant at a terminal, and its standard input or output is not a "
              "terminal but a file, a pipe or a job. Start the command in a terminal without "
              "redirecting it, run the session in the program's windows (asperity " +
              inputs.study.string() + "), or add --virtual for a virtual participant");
        }
        person.emplace(STDIN_FILENO, std::cout, inputs.study,
                       inputs.study / ("sheet-" + inputs.participant + ".png"));
      }
      SessionRequests requests;
      const InterruptWatch interrupt(
          "stopping after the current trial, or now if no trial is running",
          [&requests] { requests.emergency_stop(); });
      // Before the protocol's files are missed in what is no study. Closed before the session: SQLite refuses to write while
      // the process has the database open for reading only.
      std::optional<SessionMode> mode = inputs.is_virtual ? SessionMode::simulate : inputs.mode;
      if (inputs.resume) mode.reset();  // that of the session
      inputs.protocol = protocol_for_participant(Study::open(inputs.study, Access::read_only),
                                                 found_protocol(inputs.protocol, inputs.study),
                                                 inputs.participant, mode, options->language);
      const ModelRegistry models = models_with(options->plugins);
      if (!options->plugins.empty()) {
        warn_of_other_builds(inputs, Study::open(inputs.study, Access::read_only), models);
      }
      inputs.rehearsed = [](const RehearsedDevice& device) {
        for (const RehearsalWarning& warning : device.warnings) {
          say("asperity: warning: " + warning.text.english());
        }
      };
      inputs.resumed = [](const Phrase& circumstance) {
        say("asperity: warning: " + circumstance.english());
      };
      inputs.noticed = [&](const LabelNotice& notice, const Wait& wait) {
        if (notice.is_planned) return say("asperity: " + notice.text.english());
        const bool is_similar = !notice.similar_label.empty();
        const std::string sentence = notice.text.english() + "; " + notice.command_remedy;
        if (is_similar && !person && !options->allows_similar_label) {
          throw std::runtime_error(sentence + ". For another participant, use another label, or " +
                                   "--allow-similar-label. Nothing was stored");
        }
        say("asperity: warning: " + sentence);
        if (!person || (is_similar && options->allows_similar_label)) return;
        person->read("Ctrl-C ends the program; nothing has been stored.", 0.0, wait);
      };
      inputs.ready = [&](const Protocol& protocol) {
        if (!person) return;
        tell_what_a_terminal_lacks(protocol);
        if (protocol.shows_pictures_in_grey) person->show_in_grey();
      };
      // Acknowledgements are for the experimenter, and a terminal is the participant's screen.
      const bool is_on_screen = person && isatty(STDERR_FILENO) == 1;
      const auto acknowledge = [is_on_screen](const AttemptDone& done) {
        if (!is_on_screen) say_done(done);
      };
      const SessionEnd end =
          run_session(inputs, models, person ? &*person : nullptr, interrupt.token(), acknowledge,
                      {.requests = &requests,
                       .experimenter_is_there = person.has_value(),
                       .tell = [](const std::string& line) { say("asperity: " + line); }});
      if (end.state != SessionState::completed) {
        say("asperity: the session stopped: " + end.reason.english() +
            (end.as_the_protocol_says ? ""
                                      : "; every completed trial is stored. To resume the session, "
                                        "repeat the command") +
            (end.as_the_protocol_says || inputs.resume ? "" : " with --resume"));
        return 1;
      }
      // Not before: who resumes the session is not told whether responses were correct.
      for (const Phrase& anchors : end.anchors) say("asperity: " + anchors.english());
      say("session complete: " + std::to_string(end.attempts) +
          (end.attempts == 1 ? " attempt" : " attempts") + " in " + fixed(end.duration_s, 0) +
          " s");
      return 0;
    };
  });
}

}  // namespace asperity
