// Keeps the last results of a rehearsal.

#include "app/session/rehearsal/rehearsal_memory.h"

#include <utility>

#include "app/session/session_setup.h"
#include "results_schema/hashes/sha256.h"

namespace asperity {

std::vector<RehearsalWarning> RehearsalMemory::recall(
    const std::string& key, const std::stop_token& stop,
    const std::function<std::vector<RehearsalWarning>()>& compare) {
  const std::lock_guard lock(mutex_);
  if (key_ == key) return warnings_;
  std::vector<RehearsalWarning> warnings = compare();
  if (stop.stop_requested()) return warnings;
  key_ = key;
  warnings_ = std::move(warnings);
  return warnings_;
}

std::vector<Diagnostic> RehearsalMemory::problems_once(
    const std::string& key, const std::function<std::vector<Diagnostic>()>& rehearse) {
  const std::lock_guard lock(mutex_);
  if (sound_key_ == key) return {};
  std::vector<Diagnostic> problems = rehearse();
  if (problems.empty()) sound_key_ = key;
  return problems;
}

std::string content_key(const Protocol& protocol, const std::filesystem::path& study) {
  std::string key = sha256_of(protocol.source) + '\n';
  for (const StimulusFileRow& file : hash_files(protocol, study)) {
    key += file.path + ' ' + file.sha256 + '\n';
  }
  return key;
}

std::vector<RehearsalWarning> rehearse_once(RehearsalMemory* memory, const Protocol& protocol,
                                            const DeviceProfile& profile,
                                            const std::filesystem::path& study,
                                            StimulusBuilder& builder, const StimuliCourse& course) {
  const auto compare = [&] { return rehearse_on_device(protocol, profile, builder, course); };
  if (memory == nullptr) return compare();
  return memory->recall(content_key(protocol, study) + json_text_of(profile), course.stop, compare);
}

}  // namespace asperity
