// What an experimenter asks of a session that is running on another thread.

#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/words/phrase.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

class Rig;

enum class StopAfter { trial, block };

/// The verbs towards a running session, from any thread.
///
/// The conductor takes them up: `pause`, `stop_after` and `repeat_last` between trials, `abort` and
/// `skip` within a few hundredths of a second (a skip between trials skips nothing), `clear_fault`
/// while a fault is latched. `emergency_stop` is immediate: it goes to the servo loop and does not
/// wait for the conductor.
///
/// Everything stays asked for until it was done, or until it is withdrawn (`resume` withdraws a
/// pause, `go_on` a stop).
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
  /// The last trial that was answered or skipped is asked once more, as a new attempt; the earlier
  /// attempt stays, no longer valid.
  void repeat_last(const Phrase& reason);
  /// The trial under way is kept as skipped and not asked again.
  void skip(const Phrase& reason);
  /// Ends the session at once; the attempt under way is kept as aborted.
  void abort(const Phrase& reason);
  /// Stamped now, stored between trials.
  void note(const Phrase& text);
  /// What is to stand in the session's record beside notes, stamped now: "unblinded",
  /// "focus_changed".
  void remark(const std::string& kind, const Phrase& text);
  /// Zero force in the next servo tick, latched.
  void emergency_stop() noexcept;
  /// Of a simulated device, whose handle cannot be held: its button goes down or up within a few
  /// hundredths of a second. Buttons count from 1. Errors: std::invalid_argument where there is no
  /// such button.
  void press_button(int button);
  void release_button(int button);
  /// The reason of the fault is mended: go on with the trial that it interrupted. An emergency stop
  /// that comes later takes it back.
  void clear_fault();

  /// The experimenter has done what the protocol requests before a trial.
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

  /// `rig` is the one that is to be stopped in an emergency, and whose clock stamps remarks.
  void attach(Rig& rig);
  void detach();
  bool is_paused() const;
  /// Each gives what was asked for and forgets it.
  bool take_stop(StopAfter what);
  std::optional<Phrase> take_repeat();
  std::optional<Phrase> take_skip();
  std::optional<Phrase> take_abort();
  bool take_clear_fault();
  bool take_confirmation();
  /// Takes `clear_fault` and lifts the rig's fault (Rig::clear_fault), in one: an emergency stop comes before or after
  /// and is never lifted by what was asked for before it. False when it was not requested.
  bool lift_fault(Fault seen);
  std::vector<Remark> take_remarks();
  /// In the order of asking.
  std::vector<ButtonMove> take_button_moves();

 private:
  void move_button(const ButtonMove& wish);

  mutable std::mutex mutex_{};
  Rig* rig_ = nullptr;
  bool stop_wanted_ = false;  ///< an emergency stop from before there was a rig
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
