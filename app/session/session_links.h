// What a session run from windows has beside its participant.

#pragma once

#include <functional>
#include <string>

namespace asperity {

class SessionMonitor;
class SessionRequests;
class Sound;

/// All may be null: no window follows the session, none requests anything, nothing sounds. All outlive the
/// session.
struct SessionLinks {
  SessionRequests* requests = nullptr;
  SessionMonitor* monitor = nullptr;
  Sound* sound = nullptr;
  /// An experimenter is there: after a fault, or when the masking noise stops, the session waits for
  /// what they decide; otherwise it ends and can be resumed.
  bool experimenter_is_there = false;
  /// Receives, as lines, what is wrong with the device, that it is well again, and why a trial is repeated; for who has
  /// no monitor.
  std::function<void(const std::string& line)> tell{};
};

}  // namespace asperity
