// Declares a session of two trials with the mouse, in a temporary study.

#pragma once

#include <filesystem>
#include <string>

#include "app/tasks/run_session.h"
#include "app/tasks/work_folder.h"
#include "protocols/design/protocol.h"

namespace asperity {

/// A temporary study with one protocol and the files that it names; nothing of the study that has them is changed. It is removed
/// with the object.
///
/// The protocol begins with `introduction`, a text for the participant; the texts before its first block follow, then its first
/// main block, without breaks, for a participant of `group` (empty: the first one). Checks of the device, masking noise and limits of the servo loop are left out: what remains is
/// what a participant reads, feels, sees and answers.
class MouseTrial final {
 public:
  /// After this trial the session ends.
  static constexpr int kLastTrial = 2;

  /// Errors: PhrasedError for a protocol that takes its levels from an external program; those of WorkFolder and Study::create; of
  /// `hash_files` and std::filesystem for files that cannot be copied.
  MouseTrial(const Protocol& protocol, const std::filesystem::path& study,
             const std::string& introduction, std::uint64_t seed, const std::string& group = {});

  /// A pilot session with the device "mouse" of a participant who has agreed.
  const RunInputs& inputs() const noexcept { return inputs_; }

 private:
  WorkFolder work_{"mouse"};
  RunInputs inputs_{};
};

/// The text of the protocol in that study.
std::string mouse_trial_text(const Protocol& protocol, const std::string& introduction);

}  // namespace asperity
