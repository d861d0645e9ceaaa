// asperity check: every problem of a protocol, and what its plan amounts to.

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "analysis/number_text.h"
#include "app/cli/command.h"
#include "app/cli/terminal.h"
#include "app/conductor/rehearsal.h"
#include "app/device_profile.h"
#include "app/tasks/device_choice.h"
#include "app/tasks/protocol_files.h"
#include "device/drivers.h"
#include "protocols/doubts.h"

namespace asperity {

namespace {

nlohmann::ordered_json json_of(const std::vector<Diagnostic>& diagnostics) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    json.push_back({{"line", diagnostic.line},
                    {"column", diagnostic.column},
                    {"pointer", diagnostic.pointer},
                    {"message", diagnostic.message}});
  }
  return json;
}

nlohmann::ordered_json json_of(const ProtocolCheck& check, const std::vector<Diagnostic>& doubts) {
  nlohmann::ordered_json json{{"file", check.file},
                              {"valid", check.diagnostics.empty()},
                              {"diagnostics", json_of(check.diagnostics)},
                              {"warnings", json_of(doubts)}};
  if (check.protocol) {
    json["name"] = check.protocol->name;
    json["version"] = check.protocol->version;
    json["trials"] = check.cost.trials;
    json["contacts"] = check.cost.contacts;
    json["contact_s"] = check.cost.contact_s;
    json["total_s"] = check.cost.total_s;
    json["longest_without_break_s"] = check.cost.longest_without_break_s;
  }
  return json;
}

std::string warning_of(const Diagnostic& doubt) {
  return doubt.file + ':' + std::to_string(doubt.line) + ':' + std::to_string(doubt.column) +
         ": warning: " + doubt.message + " (" + doubt.pointer + ')';
}

/// The serial number of the one device that this driver has attached now; nothing where there are none or
/// several, or it tells none.
std::string attached_serial(const std::string& driver_id) {
  const DriverRegistry drivers = built_in_drivers();
  const Driver* driver = drivers.find(driver_id);
  if (driver == nullptr) return {};
  const std::vector<AttachedDevice> attached = drivers.survey(*driver, {}).attached;
  return attached.size() == 1 ? attached.front().serial : std::string();
}

/// The device that protocols are compared with.
struct ComparedDevice {
  WhichDevice which{};
  /// Its serial number is that of the one that is attached, and was not said.
  bool is_found = false;
};

/// The one that is said, or else the one that is attached, which is looked for.
ComparedDevice compared_device(const std::string& device) {
  ComparedDevice compared{.which = which_device(device)};
  if (device.find(':') != std::string::npos) return compared;
  compared.which.serial = attached_serial(compared.which.name);
  compared.is_found = !compared.which.serial.empty();
  return compared;
}

/// What the device cannot render, as the study's profile of it says; nothing without a profile.
std::vector<Diagnostic> device_warnings(const ProtocolCheck& check,
                                        const std::filesystem::path& study,
                                        const ComparedDevice& device, const ModelRegistry& models) {
  const WhichDevice& which = device.which;
  std::vector<Diagnostic> warnings{};
  const std::optional<DeviceProfile> profile = latest_profile(study, which);
  if (!profile && device.is_found) {
    warnings.push_back({check.file, 1, 1, "",
                        "the study has no profile of the attached device " + which.name + " " +
                            which.serial +
                            ", and it is compared with none; measure it: asperity device-test " +
                            which.name + " --study " + study.string()});
  }
  if (!profile) return warnings;
  StimulusBuilder builder(models, study);
  for (const RehearsalWarning& warning : rehearse_on_device(*check.protocol, *profile, builder)) {
    warnings.push_back({check.file, 1, 1, "", warning.text.english()});
  }
  return warnings;
}

}  // namespace

void add_check(CLI::App& program, Job& job) {
  struct Options {
    std::vector<std::string> files{};
    std::optional<std::string> study{};
    std::optional<std::string> device{};
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "check", "Check protocols: every problem, or what the plan amounts to.");
  command->add_option("FILE", options->files, "Protocol files")->required();
  command->add_option("--study", options->study, "Look also for the files that the protocols name");
  command->add_option("--device", options->device, "Compare with this device");
  command->add_flag("--json", options->json, "Print one JSON document");
  command->callback([options, &job] {
    job = [options] {
      if (options->study && !std::filesystem::is_directory(*options->study)) {
        throw std::runtime_error("there is no folder " + *options->study +
                                 "; --study takes the folder of a study, where the files that the "
                                 "protocols name are looked for");
      }
      const ModelRegistry models = built_in_models();
      nlohmann::ordered_json json{{"format", "asperity.check/1"},
                                  {"protocols", nlohmann::ordered_json::array()}};
      bool acceptable = true;
      // Looked for once, for the first to be compared with it.
      std::optional<ComparedDevice> device{};
      for (const std::string& file : options->files) {
        ProtocolCheck check = check_protocol(file, models, options->study, options->device);
        if (options->study && check.protocol && check.diagnostics.empty()) {
          StimulusBuilder builder(models, *options->study);
          check.diagnostics = rehearse(*check.protocol, check.file, builder);
        }
        acceptable = acceptable && check.diagnostics.empty();
        for (const Diagnostic& diagnostic : check.diagnostics) say(text_of(diagnostic));
        std::vector<Diagnostic> doubts{};
        if (check.protocol) doubts = doubts_about(*check.protocol, check.file);
        if (options->study && options->device && check.protocol && check.diagnostics.empty()) {
          if (!device) device = compared_device(*options->device);
          for (const Diagnostic& warning :
               device_warnings(check, *options->study, *device, models)) {
            doubts.push_back(warning);
          }
        }
        for (const Diagnostic& doubt : doubts) say(warning_of(doubt));
        if (options->json) {
          json["protocols"].push_back(json_of(check, doubts));
        } else if (check.diagnostics.empty()) {
          std::cout << check.file << ": " << check.protocol->name << ' ' << check.protocol->version
                    << ": " << counted(check.cost.trials, "trial") << ", "
                    << counted(check.cost.contacts, "contact") << ", "
                    << fixed(check.cost.contact_s / 60.0, 1) << " min of contact, about "
                    << fixed(check.cost.total_s / 60.0, 0) << " min in all, at most "
                    << fixed(check.cost.longest_without_break_s / 60.0, 1)
                    << " min without a break\n";
        }
      }
      if (options->json) std::cout << json.dump(2) << '\n';
      return acceptable ? 0 : 1;
    };
  });
}

}  // namespace asperity
