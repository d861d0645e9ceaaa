// Looks a protocol up in a study, and refuses one that cannot run.

#include "app/tasks/protocol_files.h"

#include <utility>
#include <vector>

#include "app/study_files/protocol_languages.h"
#include "app/tasks/warnings/checked_protocol.h"
#include "app/tasks/warnings/named_files.h"
#include "app/tasks/warnings/plugin_stimuli.h"
#include "app/tasks/warnings/rehearsed_stimuli.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

std::filesystem::path found_protocol(const std::filesystem::path& file,
                                     const std::optional<std::filesystem::path>& study) {
  if (std::filesystem::exists(file) || !study) return file;
  for (const auto& candidate : {*study / file, *study / "protocols" / file,
                                *study / "protocols" / (file.string() + ".json")}) {
    if (std::filesystem::is_regular_file(candidate)) return candidate;
  }
  return file;
}

Protocol load_protocol(const std::filesystem::path& file, const ModelRegistry& models,
                       const std::optional<std::filesystem::path>& study) {
  const std::filesystem::path found = found_protocol(file, study);
  const ProtocolSource source = protocol_source(found);
  return read_protocol(source.text, source.file.string(), declarations_of(models));
}

Protocol load_protocol_to_run(const std::filesystem::path& file, const std::filesystem::path& study,
                              StimulusBuilder& builder, RehearsalMemory* memory) {
  Protocol protocol = load_protocol(file, builder.models(), study);
  const std::string found = found_protocol(file, study).string();
  const CheckedProtocol checked(protocol, found);
  std::vector<Diagnostic> problems = problems_of_files(checked, study, builder);
  if (problems.empty()) problems = problems_of_plugin_stimuli(checked, builder);
  const auto rehearsed = [&] { return rehearse(checked, builder); };
  if (problems.empty()) {
    problems = memory == nullptr ? rehearsed()
                                 : memory->problems_once(content_key(protocol, study), rehearsed);
  }
  if (!problems.empty()) throw ProtocolError(std::move(problems));
  return protocol;
}

}  // namespace asperity
