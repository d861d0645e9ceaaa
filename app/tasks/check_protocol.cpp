// Collects the problems and warnings of all layers, in the order of lines.

#include "app/tasks/check_protocol.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "analysis/numbers/random.h"
#include "app/profiles/device_kind.h"
#include "app/session/stimulus_builder.h"
#include "app/session/trial_attempt.h"
#include "app/study_files/protocol_languages.h"
#include "app/tasks/checks/device_requirements.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "app/tasks/warnings/level_problems.h"
#include "app/tasks/warnings/named_files.h"
#include "app/words/phrase_of_error.h"
#include "device/simulated_device.h"
#include "device/simulated_models.h"
#include "protocols/design/wording.h"
#include "protocols/file/protocol_problems.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/block_design.h"
#include "protocols/plan/course.h"
#include "protocols/warnings/analysis_warnings.h"
#include "protocols/warnings/design_warnings.h"
#include "protocols/warnings/plan_warnings.h"
#include "protocols/warnings/text_warnings.h"
#include "protocols/warnings/texture_use_warnings.h"
#include "protocols/warnings/warnings.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// `sentence`: with the language, the name of its file and the problems in place of %1 to %3.
Diagnostic unusable_language(const std::string& file, const ProtocolInLanguage& translation,
                             const Phrase& sentence, const std::vector<Diagnostic>& problems) {
  const Diagnostic& first = problems.front();
  const Phrase found =
      (problems.size() == 1 ? phrase("Protocols", "a problem at line %2: %3")
                            : phrase("Protocols", "%1 problems, the first at line %2: %3"))
          .with(std::to_string(problems.size()), std::to_string(first.line), first.message);
  return {
      file, 1, 1, "",
      sentence.with(in_quotes(translation.language), translation.file.filename().string(), found)};
}

/// A warning for every translation of the protocol that cannot be used, and for translated texts that contradict the design.
std::vector<Diagnostic> warnings_about_translations(const std::string& file,
                                                    const ModelRegistry& models) {
  std::vector<Diagnostic> warnings{};
  for (const ProtocolInLanguage& each : languages_of_protocol(file)) {
    if (each.file == file) continue;
    try {
      const std::string text = protocol_source(each.file).text;
      const ProtocolReading reading =
          read_protocol_with_problems(text, file, declarations_of(models));
      if (!reading.problems.empty()) {
        warnings.push_back(unusable_language(
            file, each,
            phrase("Protocols",
                   "no session can run in the language %1: with %2 the protocol has %3"),
            reading.problems));
        continue;
      }
      const Plan example = example_plan(*reading.protocol, {1, 0});
      for (Diagnostic& warning : warnings_about_texts(*reading.protocol, file, example)) {
        warning.message = Phrase("%1: %2").with(each.file.filename().string(), warning.message);
        warnings.push_back(std::move(warning));
      }
    } catch (const ProtocolError& error) {
      warnings.push_back(unusable_language(
          file, each, phrase("Protocols", "no session can run in the language %1: %2 has %3"),
          error.diagnostics()));
    }
  }
  return warnings;
}

/// For a protocol with other problems: the problems of files that are named in valid places.
void add_problems_of_files(const ProtocolReading& reading, const std::filesystem::path& study,
                           StimulusBuilder& builder, ProtocolCheck& check) {
  const auto is_looked_at = [&reading](const Diagnostic& place) {
    return !may_follow_from(reading.repair, place.pointer, {}) &&
           std::none_of(
               reading.problems.begin(), reading.problems.end(),
               [&place](const Diagnostic& problem) { return problem.pointer == place.pointer; });
  };
  append(check.diagnostics,
         problems_of_named_files(*reading.protocol, check.file, study, builder, is_looked_at));
}

}  // namespace

ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device) {
  const std::string found = found_protocol(file, study).string();
  ProtocolCheck check{};
  try {
    const ProtocolSource source = protocol_source(found);
    check = check_protocol_text(source.text, source.file.string(), models, study, device);
    append(check.warnings, source.warnings);
    // Problems of the protocol itself would be those of every translation.
    if (found == source.file && check.is_valid()) {
      append(check.warnings, warnings_about_translations(found, models));
    }
  } catch (const ProtocolError& error) {
    check.diagnostics = error.diagnostics();
  } catch (const std::exception& error) {
    check.diagnostics.push_back({found, 0, 0, "", phrase_of(error)});
  }
  check.file = found;
  return check;
}

ProtocolCheck check_protocol_text(const std::string& text, const std::string& file_name,
                                  const ModelRegistry& models,
                                  const std::optional<std::filesystem::path>& study,
                                  const std::optional<std::string>& device,
                                  KeptHeightFields* kept) {
  ProtocolCheck check{};
  check.file = file_name;
  check.text = text;
  const auto whole_file = [&check](const Phrase& message) {
    check.diagnostics.push_back({check.file, 1, 1, "", message});
  };
  ProtocolReading reading{};
  try {
    reading = read_protocol_with_problems(text, file_name, declarations_of(models));
    if (reading.has_form) check.warnings = warnings_about(*reading.protocol, file_name);
  } catch (const std::exception& error) {
    whole_file(phrase_of(error));
    return check;
  }
  check.diagnostics = reading.problems;
  if (!reading.problems.empty()) {
    if (study && reading.protocol) {
      StimulusBuilder builder(models, *study, kept);
      add_problems_of_files(reading, *study, builder, check);
    }
    sort_by_line(check.diagnostics);
    return check;
  }
  check.protocol = std::move(reading.protocol);
  const CheckedProtocol checked(*check.protocol, check.file);
  if (study) {
    StimulusBuilder builder(models, *study, kept);
    check.diagnostics = problems_of_files(checked, *study, builder);
    if (check.diagnostics.empty()) check.diagnostics = problems_of_scaled_heights(checked, builder);
  }
  append(check.diagnostics, problems_of_values(*check.protocol, check.file));
  sort_by_line(check.diagnostics);
  // A real device is not opened: it may be on another machine.
  if (device) {
    if (const std::optional<SimulatedDeviceSettings> settings = simulated_settings(*device)) {
      VirtualHand hand(HandHabits{}, Random(0));
      const SimulatedDevice simulated(hand, *settings);
      for (const Phrase& complaint :
           complaints_about_device(*check.protocol, simulated.capability())) {
        whole_file(phrase("Protocols",
                          "%1; choose another device, or relax the requirement in the protocol")
                       .with(complaint));
      }
    }
  }
  const Plan example = example_plan(*check.protocol, {1, 0});
  check.cost = cost_of(*check.protocol, example);
  append(check.warnings, warnings_about_plan(*check.protocol, check.file, example));
  append(check.warnings, warnings_about_texts(*check.protocol, check.file, example));
  append(check.warnings, warnings_about_analysis(*check.protocol, check.file));
  append(check.warnings, warnings_about_design(*check.protocol, check.file));
  append(check.warnings, warnings_about_texture_use(*check.protocol, check.file));
  for (const auto& [name, block] : check.protocol->blocks) {
    if (block.phase != Phase::main) continue;
    if (Phrase design = design_of(*check.protocol, block, example); !design.empty()) {
      check.designs.emplace(name, std::move(design));
    }
  }
  return check;
}

}  // namespace asperity
