// asperity check: every problem of a protocol, and what its plan amounts to.

#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/cli/command.h"
#include "app/cli/options/driver_options.h"
#include "app/cli/options/plugin_option.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/device_bench/compared_device.h"
#include "app/device_bench/device_choice.h"
#include "app/plugins/plugin_files.h"
#include "app/session/rig/clock.h"
#include "app/tasks/check_protocol.h"
#include "app/tasks/warnings/drag_of_stimuli.h"
#include "app/tasks/warnings/session_warnings.h"
#include "app/tasks/warnings/stimulus_examination.h"
#include "app/words/shell_word.h"
#include "device/drivers.h"
#include "protocols/file/json_document.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/course.h"
#include "protocols/plan/groups.h"
#include "protocols/plan/plan.h"
#include "results_schema/error_text.h"
#include "results_schema/study_sharing.h"

namespace asperity {

namespace {

nlohmann::ordered_json json_of(const std::vector<Diagnostic>& diagnostics) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    json.push_back({{"line", nullptr},
                    {"column", nullptr},
                    {"pointer", diagnostic.pointer},
                    {"message", diagnostic.message.english()}});
    if (diagnostic.line == 0) continue;  // the file could not be read
    json.back()["line"] = diagnostic.line;
    json.back()["column"] = diagnostic.column;
  }
  return json;
}

/// With what a device was compared, as a program reads it.
nlohmann::ordered_json json_of(const std::string& device, const DeviceComparison& comparison,
                               const std::vector<DeviceTrait>& not_known) {
  nlohmann::ordered_json json{{"name", device},
                              {"compared", nullptr},
                              {"profile_measured_utc", nullptr},
                              {"not_known", nlohmann::ordered_json::array()}};
  if (!comparison.compared.empty()) json["compared"] = comparison.compared;
  if (comparison.profile) json["profile_measured_utc"] = comparison.profile->measured_utc;
  for (const DeviceTrait trait : not_known) json["not_known"].push_back(name_of(trait));
  return json;
}

/// The course of an examination of many stimuli, which may take minutes. Where standard error is no terminal, its lines stand
/// among the problems, and only where it does take long.
class ShownCourse final {
 public:
  ShownCourse(const std::string& what, const std::stop_token& stop)
      : progress_(what, kBetweenLines), course_{.stop = stop, .progress = [this](double done) {
                                                  progress_.show(done);
                                                }} {}
  ShownCourse(const ShownCourse&) = delete;
  ShownCourse& operator=(const ShownCourse&) = delete;

  const StimuliCourse& course() const noexcept { return course_; }

 private:
  static constexpr std::chrono::seconds kBetweenLines{10};

  Progress progress_;
  StimuliCourse course_;
};

nlohmann::ordered_json json_of(const std::vector<StimulusDrag>& drags) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const StimulusDrag& drag : drags) {
    json.push_back({{"stimulus", drag.stimulus},
                    {"exploration", drag.exploration},
                    {"mean_N", drag.mean_N},
                    {"of_coulomb", drag.of_coulomb}});
  }
  return json;
}

/// The files that a protocol names, each once.
std::set<std::string> named_files(const Protocol& protocol) {
  std::set<std::string> paths{};
  for (const NamedFile& named : files_of(protocol)) paths.insert(named.path);
  return paths;
}

nlohmann::ordered_json json_of(const ProtocolCheck& check, const std::vector<StimulusDrag>& drags,
                               bool examines_files) {
  nlohmann::ordered_json json{{"file", check.file},
                              {"valid", check.diagnostics.empty()},
                              {"diagnostics", json_of(check.diagnostics)},
                              {"warnings", json_of(check.warnings)}};
  if (check.protocol) {
    json["name"] = check.protocol->name;
    json["version"] = check.protocol->version;
    json["trials"] = check.cost.trials;
    json["trials_are_estimated"] = has_estimated_trials(*check.protocol);
    json["contacts"] = check.cost.contacts;
    json["contact_s"] = check.cost.contact_s;
    json["total_s"] = check.cost.total_s;
    json["longest_without_break_s"] = check.cost.longest_without_break_s;
    for (const auto& [block, design] : check.designs) json["designs"][block] = design.english();
    json["drag"] = json_of(drags);
    json["files_not_examined"] =
        examines_files ? std::set<std::string>{} : named_files(*check.protocol);
    if (check.protocol->groups) {
      json["groups"] = {{"factor", check.protocol->groups->factor},
                        {"levels", groups_of(*check.protocol)},
                        {"assigned", text_of(check.protocol->groups->assigned)}};
    }
  }
  return json;
}

const char* assignment_text(Protocol::Groups::Assignment assigned) {
  switch (assigned) {
    case Protocol::Groups::Assignment::balanced:
      return "balanced by the program";
    case Protocol::Groups::Assignment::permuted_blocks:
      return "assigned by the program in permuted blocks";
    case Protocol::Groups::Assignment::by_experimenter:
      return "assigned by the experimenter";
  }
  return "";
}

/// "training (haptic, visual), balanced by the program"
std::string groups_text(const Protocol& protocol) {
  std::string levels{};
  for (const std::string& group : groups_of(protocol)) {
    levels += (levels.empty() ? "" : ", ") + group;
  }
  return protocol.groups->factor + " (" + levels + "), " +
         assignment_text(protocol.groups->assigned);
}

/// Both as an author meets them, from the first line to the last; of one place the problem first.
void say_in_order(const std::vector<Diagnostic>& problems,
                  const std::vector<Diagnostic>& warnings) {
  auto warning = warnings.begin();
  const auto say_warnings_before = [&](const Diagnostic* problem) {
    for (; warning != warnings.end(); ++warning) {
      if (problem != nullptr &&
          std::pair(warning->line, warning->column) >= std::pair(problem->line, problem->column)) {
        return;
      }
      say(warning_text(*warning));
    }
  };
  for (const Diagnostic& problem : problems) {
    say_warnings_before(&problem);
    say(text_of(problem));
  }
  say_warnings_before(nullptr);
}

/// Adds what the stimuli whose files are available show, and returns their drag; none where a session would fail.
std::vector<StimulusDrag> examined(ProtocolCheck& check, const CheckedProtocol& checked,
                                   const std::filesystem::path& study, const ModelRegistry& models,
                                   const std::stop_token& stop) {
  StimulusBuilder builder(models, study);
  {
    const ShownCourse shown("examining the stimuli of " + check.protocol->name, stop);
    add_examination(check, examine_stimuli(checked, study, builder, shown.course()));
  }
  if (!check.diagnostics.empty()) return {};
  const ShownCourse shown("measuring the drag of " + check.protocol->name, stop);
  return drag_of_stimuli(checked, builder, shown.course());
}

}  // namespace

void add_check(CLI::App& program, Job& job) {
  struct Options {
    std::vector<std::string> files{};
    std::optional<std::string> study{};
    std::optional<std::string> device{};
    DriverOptions drivers{};
    bool json = false;
    std::vector<std::filesystem::path> plugins{};
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "check", "Check protocols: list every problem, or summarise the plan.");
  command->add_option("FILE", options->files, "Protocol files")->required();
  command->add_option("--study", options->study,
                      "Folder of the study: also check the files that the protocols name");
  command->add_option(
      "--device", options->device,
      "Compare with this device: a name listed by asperity devices, "
      "simulated:MODEL[,PROPERTY=VALUE…] or replay:FILE; NAME:SERIAL if several are "
      "attached");
  add_driver_options(*command, options->drivers);
  command->add_flag("--json", options->json, "Print one JSON document");
  add_plugin_option(*command, options->plugins);
  command->callback([options, &job] {
    job = watched_with(options->plugins, [options] {
      if (options->study && !std::filesystem::is_directory(*options->study)) {
        throw std::runtime_error("there is no folder " + *options->study +
                                 "; --study takes the folder of a study, which contains the files "
                                 "that the protocols name");
      }
      if (options->device) require_device("--device", *options->device);
      const ModelRegistry models = models_with(options->plugins);
      nlohmann::ordered_json json{{"format", "asperity.check/1"},
                                  {"protocols", nlohmann::ordered_json::array()}};
      if (options->study && is_readable_by_others(*options->study)) {
        const std::string warning =
            *options->study +
            ": warning: every user of this computer can read the study; to keep " +
            "other users out, run: chmod o-rwx " + shell_word(*options->study);
        say(warning);
        if (options->json) json["study_warning"] = warning;
      }
      bool acceptable = true;
      // Looked for once, for the first to be compared with it.
      std::optional<SoughtDevice> device{};
      const std::string now_utc = SystemClock(0).utc();
      const InterruptWatch interrupt("stopping after this stimulus; its protocol is not reported");
      const std::stop_token stop = interrupt.token();
      for (const std::string& file : options->files) {
        ProtocolCheck check = check_protocol(file, models, options->study, options->device);
        std::vector<StimulusDrag> drags{};
        try {
          if (check.is_valid()) {
            const CheckedProtocol checked(*check.protocol, check.file);
            const std::filesystem::path study = options->study.value_or("");
            if (options->study) {
              append(check.warnings, warnings_about_sessions(checked, study, models));
            }
            drags = examined(check, checked, study, models, stop);
          }
        } catch (const std::exception& error) {  // the other files are checked all the same
          check.diagnostics.push_back({check.file, 1, 1, "", message_of(error)});
        }
        DeviceComparison comparison{};
        if (options->device && check.protocol && check.diagnostics.empty() &&
            !stop.stop_requested()) {
          if (!device) {
            device = sought_device(*options->device, options->drivers, built_in_drivers());
          }
          const ShownCourse shown("comparing " + check.protocol->name + " with the device", stop);
          comparison = compare_with(*device, *check.protocol, check.file, options->study, now_utc,
                                    models, shown.course());
          append(check.warnings, comparison.warnings);
          if (!comparison.refusal.empty()) {
            check.diagnostics.push_back(JsonDocument(check.protocol->source, check.file)
                                            .at_key("/device", comparison.refusal));
          }
        }
        if (stop.stop_requested()) {
          say("asperity: the check was stopped, and " + check.file +
              " is not reported; repeat the command to check it");
          return 1;
        }
        acceptable = acceptable && check.diagnostics.empty();
        sort_by_line(check.diagnostics);
        sort_by_line(check.warnings);
        say_in_order(check.diagnostics, check.warnings);
        if (options->json) {
          json["protocols"].push_back(json_of(check, drags, options->study.has_value()));
          if (options->device) {
            json["protocols"].back()["device"] =
                json_of(*options->device, comparison,
                        device ? device->not_known : std::vector<DeviceTrait>{});
          }
        } else if (check.diagnostics.empty()) {
          std::cout << check.file << ": " << check.protocol->name << ' ' << check.protocol->version
                    << ": valid, " << (has_estimated_trials(*check.protocol) ? "about " : "")
                    << counted(check.cost.trials, "trial") << ", "
                    << counted(check.cost.contacts, "contact") << ", "
                    << fixed(check.cost.contact_s / 60.0, 1) << " min of contact, about "
                    << fixed(check.cost.total_s / 60.0, 0) << " min in all, at most "
                    << fixed(check.cost.longest_without_break_s / 60.0, 1)
                    << " min without a break\n";
          for (const auto& [block, design] : check.designs) {
            std::cout << check.file << ": block " << block << ": " << design.english() << '\n';
          }
          if (check.protocol->groups) {
            std::cout << check.file << ": groups: " << groups_text(*check.protocol) << '\n';
          }
          for (const std::string& line : drag_lines(drags)) {
            std::cout << check.file << ": " << line << '\n';
          }
          if (!comparison.compared.empty()) {
            std::cout << check.file << ": " << comparison.compared << '\n';
          }
          if (const std::size_t files = named_files(*check.protocol).size();
              !options->study && files > 0) {
            std::cout << check.file
                      << ": not examined without --study: " << counted(files, "file", "files")
                      << " that the protocol names, and the stimuli made from them\n";
          }
        }
      }
      if (options->json) std::cout << json.dump(2) << '\n';
      return acceptable ? 0 : 1;
    });
  });
}

}  // namespace asperity
