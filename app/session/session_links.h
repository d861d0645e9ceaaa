// The connections of a session with the windows, apart from its participant.

#pragma once

#include <functional>
#include <optional>
#include <string>

namespace asperity {

class SessionMonitor;
class SessionRequests;
class Sound;

/// All may be null: then no window follows the session, none sends requests, and no sound is
/// played. All outlive the session.
struct SessionLinks {
  SessionRequests* requests = nullptr;
  SessionMonitor* monitor = nullptr;
  Sound* sound = nullptr;
  /// An experimenter is present: after a fault, or when the masking noise stops, the session waits
  /// for their decision; otherwise it ends and can be resumed.
  bool experimenter_is_there = false;
  /// The session ends after this trial of its plan, at least 1, as one that only tries a protocol.
  std::optional<int> last_trial{};
  /// Receives, as lines, the problems of the device, that a problem is over, and why a trial is
  /// repeated; for callers without a monitor.
  std::function<void(const std::string& line)> tell{};
};

}  // namespace asperity
