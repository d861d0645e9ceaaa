// Runs one session: the steps of its plan, and the pauses, repetitions and faults between them.

#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/session/levels/external_program.h"
#include "app/session/session_course.h"
#include "app/session/session_links.h"
#include "app/session/session_progress.h"
#include "app/session/session_requests.h"
#include "app/session/session_setup.h"
#include "app/session/stimulus_builder.h"
#include "app/session/trial_tally.h"
#include "app/session/upcoming_surfaces.h"
#include "protocols/design/protocol.h"
#include "protocols/texts/design_numbers.h"
#include "results_schema/study.h"

namespace asperity {

class LevelProgram;
struct SuppliedStep;

/// An attempt that is stored on disk.
struct AttemptDone {
  std::string participant{};
  int session = 0;
  int trial = 0;
  int attempt = 0;
  /// It completes its trial; otherwise it is kept, and the trial may be repeated.
  bool counts = true;
  AttemptOutcome outcome = AttemptOutcome::answered;
};

struct ConductorSettings {
  bool record = true;  ///< keep the tick records of every attempt
  /// Make the surfaces of the trials that can follow while a trial is carried out (UpcomingSurfaces).
  bool makes_ahead = false;
  /// States the levels of the procedure `external`; required by a protocol that has it.
  std::optional<ExternalProgram> level_program{};
  /// The conditions of this stretch of the session (program, scheduling), stored when it begins.
  std::string conditions_json = "null";
  /// Called after each commit, and only then.
  std::function<void(const AttemptDone&)> done{};
  SessionLinks links{};
};

/// How a session ended.
struct SessionEnd {
  SessionState state = SessionState::completed;
  Phrase reason{};  ///< why the session was stopped, if it was
  /// Stopped by a rule of the protocol (a criterion), not by a user or a fault.
  bool as_the_protocol_says = false;
  int attempts = 0;               ///< made in this run
  double duration_s = 0.0;        ///< on the session's clock
  std::vector<Phrase> anchors{};  ///< as `anchor_summary`, of the whole session
};

/// Runs the trial sequence of a session with one participant.
///
/// For each trial a TrialAttempt is made and stored in one transaction → `done`. Only attempts that
/// are on disk are reported. An attempt that does not count stays in the store and the trial is asked
/// again, at once or at the end of its block, as the protocol specifies. An attempt that the
/// experimenter has repeated is invalidated first, so that the new one can be the valid one.
///
/// A fault of the device, or an emergency stop, stores the attempt and stops the session, which can be
/// resumed. With an experimenter the session waits instead until the fault is cleared, and then
/// resumes with what was interrupted, or until it is stopped. After a standstill it resumes without a
/// request, unless a tick still does not return: then no request can clear the fault. The third standstill
/// since it was begun or resumed stops it.
///
/// Threads: `run` belongs to one thread, the only writer of the session's rows. Requests may come
/// from any.
///
/// Where an external program states the levels and fails, every completed trial is stored, and the session waits for the
/// experimenter, who has the program started again or stops the session; without an experimenter the session stops.
///
/// Errors: `run` throws ResultsError when the store fails; every attempt reported done is on disk.
class Conductor final {
 public:
  /// All must outlive the conductor.
  Conductor(Study& study, const Protocol& protocol, StimulusBuilder& builder, Rig& rig,
            Respondent& respondent, ConductorSettings settings);
  ~Conductor();

  SessionEnd run(OpenSession session);

  /// The requests to this session: those of the settings, or the conductor's own.
  SessionRequests& requests() noexcept { return requests_; }

 private:
  enum class Next { trial, other };

  void begin();
  SessionFacts facts_of_session() const;
  void note_guidance();
  /// Computes the values of placeholders, and stores every text that has one as it is read.
  void note_texts();
  std::string as_read(const std::string& text) const;
  SessionEnd finish(std::int64_t began_ns);
  void end_after(const std::exception& error) noexcept;
  void stop(const Phrase& reason);

  void run_steps();
  void lead_back(std::size_t first);
  void refresh_practice(std::size_t first);
  void resume_repeats(std::size_t first);
  void run_outside_trials(const std::function<void()>& step);
  void run_other(const PlanStep& step);
  void try_other(const PlanStep& planned);
  void let_read(const ParticipantScene& scene);
  void rest(const Protocol::Break& pause);
  void rest_after_contact(const Trial& next);
  void ask(const Protocol::Ask& questions);
  /// Whether the stored answers of the session meet a condition; an absent one always holds.
  bool holds(const std::optional<AnswerCondition>& condition) const;
  void store_answer(const std::vector<ResponseRow>& items);

  void finish_block(int block_ordinal);
  void run_trial(const Trial& trial, AttemptPurpose purpose = AttemptPurpose::trial);
  const Plan& plan() const noexcept { return session_.course->plan(); }
  void store_trials(std::size_t first);
  void extend_plan(const Trial& trial, const AttemptRow& attempt);
  TrialSurfaces surfaces_of(const Trial& trial, int attempt);
  void make_ahead(const Trial& trial, int attempt);
  std::vector<NextTrial> possible_after(const Trial& trial) const;
  AttemptRow make_attempt(const Trial& trial, AttemptPurpose purpose,
                          std::optional<Interruption>& interruption);
  void tell(const Trial& trial, const AttemptRow& attempt);
  void tell_of_repetition(const Trial& trial) const;
  /// Whether the trial is asked again after all others of its block.
  bool is_put_off(const Trial& trial) const;
  bool waits_for_others(const Trial& trial, const AttemptRow& attempt) const;
  void show_progress();

  // The levels that an external program states (conductor_levels.cpp).
  void supply_levels();
  std::optional<SuppliedStep> stated_step();
  void tell_program(const Trial& trial, const AttemptRow& attempt);
  void end_program();
  void wait_out_program(const Phrase& failure);

  // The matches of roughness (conductor_matches.cpp).
  void note_earlier_matches();
  void note_matches();

  // Suspensions of the session (conductor_holds.cpp).
  /// True when a trial was repeated meanwhile: the position in the session then has to be reported again.
  bool between_steps(Next next);
  void hold(Next next);
  void begin_pause();
  void end_pause(SessionPhase before);
  void pause_without_noise();
  void repeat_as_asked();
  void repeat_last(const Phrase& reason);
  void ask_again(const Trial& trial);
  bool outlives(const Interruption& interruption);
  void check_device();
  Phrase device_problem(const Wait& waiting);
  std::vector<TickRecord> records_without_surface(double duration_s, const Wait& waiting);
  static Phrase problem_in(const std::vector<TickRecord>& records);
  void check_drift(const Protocol::Break::DriftCheck& requested);
  void measure_drift(const char* part, const std::string& prompt, double duration_s);
  /// False when the session is to end; `stopped_` then has the reason.
  bool wait_out_fault(Phrase what);
  std::optional<Phrase> trouble_after_standstill(const Phrase& what);
  void forget_surface();

  void publish_trouble(const Phrase& what, SessionTrouble::Remedy remedy);

  Study& study_;
  const Protocol& protocol_;
  Rig& rig_;
  Respondent& respondent_;
  ConductorSettings settings_{};
  SessionRequests own_requests_{};
  SessionRequests& requests_;
  SessionCourse course_;
  OpenSession session_{};  ///< its attempts are in the tally
  UpcomingSurfaces upcoming_;
  std::optional<TrialTally> tally_{};
  std::optional<SessionProgress> progress_{};
  std::unique_ptr<LevelProgram> level_program_;  ///< of the run of a block that is under way
  int block_of_program_ = 0;                     ///< its ordinal
  int segment_ = 0;
  std::optional<SessionEnd> stopped_{};  ///< set once the session is to end early
  int attempts_made_ = 0;

  int standstills_ = 0;
  bool is_refreshing_ = false;
  /// Block, stimulus, model and texture of the matches that are stored: each has its own event.
  std::set<std::array<std::string, 4>> noted_matches_{};
  double contact_since_break_s_ = 0.0;  ///< or since the session was begun or resumed

  DesignValues values_{};  ///< of placeholders, where a text has one

  Wait outside_{};    ///< waits while there is no current trial
  Wait unheeding_{};  ///< waits regardless of requests and faults

  int block_ = 0;  ///< the current block, by ordinal; 0 between blocks

  std::size_t step_ = 0;  ///< the current step of the plan
};

}  // namespace asperity
