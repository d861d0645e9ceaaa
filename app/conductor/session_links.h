// What a session run from windows has beside its participant.

#pragma once

namespace asperity {

class SessionMonitor;
class SessionRequests;
class Sound;

/// All may be null: nobody watches, nobody asks for anything, nothing sounds. All outlive the
/// session.
struct SessionLinks {
  SessionRequests* requests = nullptr;
  SessionMonitor* monitor = nullptr;
  Sound* sound = nullptr;
  /// An experimenter is there: after a fault, or when the masking noise stops, the session waits for
  /// what they decide; otherwise it ends and can be gone on with.
  bool experimenter_is_there = false;
};

}  // namespace asperity
