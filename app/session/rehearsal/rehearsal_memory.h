// Keeps the last results of a rehearsal while its inputs are unchanged.

#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/session/rehearsal/rehearsal.h"
#include "protocols/file/diagnostic.h"

namespace asperity {

/// The last results for a protocol and its files: the checklist before a session asks first, then the session.
///
/// Threads: any; a caller waits while another one compares.
class RehearsalMemory final {
 public:
  /// The warnings for `key`. `compare` is called if the last key was another one; its result is kept unless `stop` was
  /// requested meanwhile.
  std::vector<RehearsalWarning> recall(
      const std::string& key, const std::stop_token& stop,
      const std::function<std::vector<RehearsalWarning>()>& compare);

  /// The problems for `key`. `rehearse` is called unless `key` is the last one without problems.
  std::vector<Diagnostic> problems_once(const std::string& key,
                                        const std::function<std::vector<Diagnostic>()>& rehearse);

 private:
  std::mutex mutex_{};
  std::optional<std::string> sound_key_{};
  std::optional<std::string> key_{};
  std::vector<RehearsalWarning> warnings_{};
};

/// Identifies a protocol and the files of the study that it names, by their content. Errors: as `hash_files`.
std::string content_key(const Protocol& protocol, const std::filesystem::path& study);

/// `rehearse_on_device`, unless `memory` (null: none) has the result for the same protocol, profile and files of the
/// study.
std::vector<RehearsalWarning> rehearse_once(RehearsalMemory* memory, const Protocol& protocol,
                                            const DeviceProfile& profile,
                                            const std::filesystem::path& study,
                                            StimulusBuilder& builder,
                                            const StimuliCourse& course = {});

}  // namespace asperity
