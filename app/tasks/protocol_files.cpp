#include "app/tasks/protocol_files.h"

#include <algorithm>

#include "app/conductor/stimulus_builder.h"
#include "results_schema/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

std::filesystem::path found_file(const std::filesystem::path& file,
                                 const std::optional<std::filesystem::path>& study) {
  if (std::filesystem::exists(file) || !study) return file;
  for (const auto& candidate : {*study / file, *study / "protocols" / file,
                                *study / "protocols" / (file.string() + ".json")}) {
    if (std::filesystem::is_regular_file(candidate)) return candidate;
  }
  return file;
}

}  // namespace

std::vector<ModelDeclaration> declarations_of(const ModelRegistry& models) {
  std::vector<ModelDeclaration> declarations{};
  for (const ForceModel& model : models.models()) declarations.push_back(model.declaration);
  return declarations;
}

Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study) {
  const std::filesystem::path found = found_file(file, study);
  return read_protocol(read_file(found), found.string(), declarations_of(models));
}

ProtocolCheck check_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                             const std::optional<std::filesystem::path>& study,
                             const std::optional<std::string>& device) {
  ProtocolCheck check{};
  check.file = found_file(file, study).string();
  const auto whole_file = [&check](const std::string& message) {
    check.diagnostics.push_back({check.file, 1, 1, "", message});
  };
  try {
    check.protocol = load_protocol(file, models, study);
  } catch (const ProtocolError& error) {
    check.diagnostics = error.diagnostics();
    return check;
  } catch (const std::exception& error) {
    whole_file(error.what());
    return check;
  }
  if (study) {
    StimulusBuilder builder(models, *study);
    for (const NamedFile& named : files_of(*check.protocol, check.file)) {
      Diagnostic problem = named.place;
      if (!std::filesystem::is_regular_file(*study / named.path)) {
        problem.message = "the file " + named.path + " is not in the study " + study->string();
        check.diagnostics.push_back(problem);
      } else if (named.is_height_field) {
        try {
          builder.height_field(named.path);
        } catch (const std::exception& error) {
          problem.message = error.what();
          check.diagnostics.push_back(problem);
        }
      }
    }
  }
  if (device && *device != "simulated") {
    whole_file("there is no device \"" + *device + "\"; this program has: simulated");
  }
  check.cost = cost_of(*check.protocol, make_plan(*check.protocol, {1, 0}));
  return check;
}

std::optional<std::string> complaint_about_label(const std::string& label, bool is_virtual) {
  const bool characters = std::all_of(label.begin(), label.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
  });
  if (characters && !label.empty() && label.size() <= 32) {
    if (is_virtual || !label.starts_with("virtual")) return {};
    return "the participant label \"" + label +
           "\" is not acceptable for a person: labels that begin with \"virtual\" are those of "
           "virtual participants";
  }
  return "the participant label \"" + label +
         "\" is not acceptable: 1 to 32 letters and digits (0-9, A-Z, a-z) are";
}

}  // namespace asperity
