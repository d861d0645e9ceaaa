// A session that a test watches and steers from outside: its monitor, its requests, its sound.

#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/app/scripted_session.h"
#include "tests/support/scripted_sound.h"

namespace asperity {

class WatchedSession : public SessionTest {
 protected:
  WatchedSession() {
    links_ = {.requests = &requests_, .monitor = &monitor_, .experimenter_is_there = true};
  }

  void play_sound() {
    sound_.now_ns = [this] { return rig_->clock().now_ns(); };
    links_.sound = &loudspeakers_;
  }

  /// Once, when the session is first in this phase.
  void once_in(SessionPhase phase, const std::function<void()>& act) {
    rig_->at_pass = [this, phase, act, done = false]() mutable {
      if (done || monitor_.snapshot().phase != phase) return;
      done = true;
      act();
    };
  }

  std::vector<std::string> phases() const {
    std::vector<EventRow> events = study_->events(session_.row.id);
    for (const AttemptRow& attempt : attempts()) {
      events.insert(events.end(), attempt.events.begin(), attempt.events.end());
    }
    std::stable_sort(events.begin(), events.end(), [](const EventRow& one, const EventRow& other) {
      return one.time_ns < other.time_ns;
    });
    std::vector<std::string> names{};
    for (const EventRow& event : events) {
      if (event.kind == "phase") names.push_back(event.text);
    }
    return names;
  }

  std::vector<EventRow> events_of(const std::string& kind) const {
    std::vector<EventRow> found{};
    for (const EventRow& event : study_->events(session_.row.id)) {
      if (event.kind == kind) found.push_back(event);
    }
    return found;
  }

  SessionMonitor monitor_{};
  SessionRequests requests_{};
  SoundLog sound_{};
  ScriptedSound loudspeakers_{sound_};
};

/// The text with an addition before its first `before`.
inline std::string with(std::string text, const std::string& before, const std::string& added) {
  text.insert(text.find(before), added);
  return text;
}

inline std::string with_noise(const std::string& text) {
  return with(text, "\"textures\"",
              R"("environment": {"masking_noise": {"kind": "pink", "level_dBA": 60}}, )");
}

/// One trial only.
inline std::string one_trial(std::string text = small_protocol()) {
  return text.replace(text.find("[1, 2, 3]"), 9, "[1]");
}

}  // namespace asperity
