// A session as it looks from outside, without one: a protocol of the library, half of it done.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/gui/session/session_window.h"
#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"

namespace asperity {

class FilledMonitor final {
 public:
  explicit FilledMonitor(const std::string& protocol = "improved_recognition",
                         SessionMode mode = SessionMode::run);

  SessionMonitor monitor{};
  SessionRequests requests{};
  std::shared_ptr<const Protocol> protocol{};
  std::shared_ptr<const Plan> plan{};

  /// Trials 1 to `done` are answered, some after a second attempt; the next one is under way.
  void answer_up_to(int done);
  /// Of a protocol with a procedure: so many trials of its tracks are answered, two of three correctly or by the choice of
  /// the varied surface. With a threshold, those above this level and every third one below it instead.
  void answer_tracks(int answers, std::optional<double> threshold = {});
  void set_phase(SessionPhase phase);
  /// A question is open, and keys of any window answer it.
  void open_response(bool open);
  /// A hand that strokes and lifts, for so long.
  void stroke(double duration_s);
  std::unique_ptr<SessionWindow> window();

 private:
  double stroked_s_ = 0.0;
};

}  // namespace asperity
