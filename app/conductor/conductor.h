// Runs one session: the only thing that knows everybody.

#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/conductor/recorder.h"
#include "app/conductor/respondent.h"
#include "app/conductor/rig.h"
#include "app/conductor/session_setup.h"
#include "app/conductor/stimulus_builder.h"
#include "protocols/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// An attempt that is on disk.
struct AttemptDone {
  std::string participant{};
  int session = 0;
  int trial = 0;
  int attempt = 0;
};

struct ConductorSettings {
  bool record = true;  ///< keep the tick records of every attempt
  /// What runs this stretch of the session (program, scheduling); stored with its beginning.
  std::string conditions_json = "null";
  /// Called after each commit, and only then.
  std::function<void(const AttemptDone&)> done{};
};

/// How a session ended.
struct SessionEnd {
  SessionState state = SessionState::completed;
  std::string reason{};  ///< a sentence, where the session was stopped
  /// Stopped by a rule of the protocol (a criterion), not by a person or a fault.
  bool as_the_protocol_says = false;
  int attempts = 0;         ///< made now
  double duration_s = 0.0;  ///< on the session's clock
};

/// Takes a participant through the plan of a session.
///
/// For each trial: build the renderers off the servo thread → let every surface be felt → ask →
/// look at the record (servo quality, compliance, features) → recording synced and renamed → one
/// transaction → `done`. Nothing is reported that is not on disk. An attempt that does not count
/// stays in the store and the trial is asked again, now or at the end of its block, as the protocol
/// says. A fault of the device stores the attempt and stops the session, which can be resumed.
///
/// Threads: `run` belongs to one thread, the only writer of the session's rows. The requests may
/// come from any thread. `stop_after` and `pause` take effect between trials, `abort` and `skip`
/// within a few hundredths of a second (a skip between trials skips nothing); `emergency_stop` is
/// immediate and does not pass the conductor.
///
/// Errors: `run` throws ResultsError when the store fails; every attempt reported done is on disk.
class Conductor final {
 public:
  /// All must outlive the conductor.
  Conductor(Study& study, const Protocol& protocol, StimulusBuilder& builder, Rig& rig,
            Respondent& respondent, ConductorSettings settings);

  SessionEnd run(OpenSession session);

  enum class After { trial, block };
  void stop_after(After what);
  /// Ends the session at once; the attempt under way is kept as aborted.
  void abort(const std::string& reason);
  /// The trial under way is kept as skipped and not asked again.
  void skip(const std::string& reason);
  /// Between trials, until `resume`.
  void pause();
  void resume();
  void note(const std::string& text);
  void emergency_stop() noexcept { rig_.emergency_stop(); }

 private:
  struct Requests {
    std::optional<After> stop{};
    std::optional<std::string> abort{};
    std::optional<std::string> skip{};
    bool paused = false;
    std::vector<std::string> notes{};
  };
  /// What ends an attempt before its answer.
  struct Interruption {
    AttemptOutcome outcome = AttemptOutcome::aborted;
    std::string reason{};
  };
  struct Surfaces;  // what was built for the surfaces of one attempt

  void run_steps();
  void run_other(const PlanStep& step);
  void stop(const std::string& reason);
  void check_device();
  void end_after(const std::exception& error) noexcept;
  void finish_block(int block_ordinal);
  void run_trial(const Trial& trial);
  AttemptRow run_attempt(const Trial& trial, int attempt);
  void feel(std::size_t index, Surfaces& surfaces, const Exploration& exploration);
  void measure(const Trial& trial, const Surfaces& surfaces, const Exploration& exploration,
               const std::vector<TickRecord>& records, AttemptRow& row) const;
  void judge(const Exploration& exploration, AttemptRow& row) const;
  void take_surface_away();
  void between_trials();
  void wait(double duration_s);
  void store_notes();
  void event(const std::string& kind, const std::string& text);
  bool is_done(const Trial& trial) const;
  BlockState criterion_of(const Trial& trial) const;
  /// The block of this trial is practised to a criterion and needs no more trials.
  bool is_over(const Trial& trial) const;
  int attempts_of(int trial) const;
  int explored_wrongly(int trial) const;
  bool is_asked_to_stop();
  std::string recording_path(const Trial& trial, int attempt) const;
  const Exploration& exploration_of(const Trial& trial) const;

  Study& study_;
  const Protocol& protocol_;
  StimulusBuilder& builder_;
  Rig& rig_;
  Respondent& respondent_;
  ConductorSettings settings_{};
  Recorder recorder_{};
  OpenSession session_{};
  int segment_ = 0;
  std::optional<SessionEnd> stopped_{};  ///< set once the session is to end early
  int attempts_made_ = 0;
  bool in_attempt_ = false;
  std::mutex requests_mutex_{};
  Requests requests_{};
};

}  // namespace asperity
