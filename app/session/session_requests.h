// Requests of an experimenter to a session that is running on another thread.

#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

class Rig;

enum class StopAfter { trial, block };

/// The requests to a running session, from any thread.
///
/// The conductor handles them: `pause`, `stop_after` and `repeat_last` between trials, `abort` and
/// `skip` within a few hundredths of a second (a skip between trials skips nothing), `clear_fault`
/// while a fault is latched. `emergency_stop` is immediate: it is sent to the servo loop and does
/// not wait for the conductor.
///
/// A request remains pending until it is fulfilled or withdrawn (`resume` withdraws a pause,
/// `go_on` a stop).
class SessionRequests final {
 public:
  SessionRequests() = default;
  SessionRequests(const SessionRequests&) = delete;
  SessionRequests& operator=(const SessionRequests&) = delete;

  void stop_after(StopAfter what);
  /// Withdraws `stop_after`.
  void go_on();
  void pause();
  void resume();
  /// Repeats the last trial that was answered or skipped, as a new attempt; the earlier attempt is
  /// kept, and no longer valid.
  void repeat_last(const Phrase& reason);
  /// Keeps the current trial as skipped; it is not asked again.
  void skip(const Phrase& reason);
  /// Ends the session at once; the current attempt is kept as aborted.
  void abort(const Phrase& reason);
  /// Stamped now, stored between trials.
  void note(const Phrase& text);
  /// An entry in the session's record other than a note, stamped now: "unblinded", "focus_changed".
  void remark(const std::string& kind, const Phrase& text);
  /// Zero force in the next servo tick, latched.
  void emergency_stop() noexcept;
  /// Presses or releases a button of a simulated device, which has no handle, within a few
  /// hundredths of a second. Buttons count from 1. Errors: std::invalid_argument where there is no
  /// such button.
  void press_button(int button);
  void release_button(int button);
  /// States that the cause of the fault is corrected: resume with the trial that it interrupted. A
  /// later emergency stop withdraws this.
  void clear_fault();

  /// States that the experimenter has done what the protocol requests before a trial.
  void confirm();

  struct Remark {
    std::int64_t time_ns = 0;
    std::string kind{};
    Phrase text{};
  };
  enum class Move { press, release };
  struct ButtonMove {
    int button = 0;
    Move move = Move::press;
  };
  /// The requests that are pending, for windows that show them.
  struct Pending {
    std::optional<StopAfter> stop{};
    bool pause = false;
    bool repeat_last = false;
  };
  Pending pending() const;

  // --- the conductor's side ---

  /// `rig` is the one that an emergency stop stops, and whose clock stamps remarks.
  void attach(Rig& rig);
  void detach();
  bool is_paused() const;
  /// Each returns the request and removes it.
  bool take_stop(StopAfter what);
  std::optional<Phrase> take_repeat();
  std::optional<Phrase> take_skip();
  std::optional<Phrase> take_abort();
  bool take_clear_fault();
  bool take_confirmation();
  /// Takes `clear_fault` and clears the rig's fault (Rig::clear_fault) in one operation: an
  /// emergency stop comes before or after it, and is never cleared by an earlier request. False
  /// when there was no request.
  bool lift_fault(Fault seen);
  std::vector<Remark> take_remarks();
  /// In the order of the requests.
  std::vector<ButtonMove> take_button_moves();

 private:
  void move_button(const ButtonMove& wish);

  mutable std::mutex mutex_{};
  Rig* rig_ = nullptr;
  bool stop_wanted_ = false;  ///< an emergency stop from before a rig was attached
  std::optional<StopAfter> stop_{};
  bool paused_ = false;
  std::optional<Phrase> repeat_{};
  std::optional<Phrase> skip_{};
  std::optional<Phrase> abort_{};
  bool clear_fault_ = false;
  bool confirmed_ = false;
  std::vector<Remark> remarks_{};
  std::vector<ButtonMove> button_moves_{};
};

}  // namespace asperity
