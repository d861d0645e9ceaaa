// The passing of time in a session, and what is shown, played and stored meanwhile.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/session/respondents/respondent.h"
#include "app/session/rig/device_complaints.h"
#include "app/session/rig/record_watch.h"
#include "app/session/rig/recorder.h"
#include "app/session/rig/rig.h"
#include "app/session/session_links.h"
#include "app/session/session_monitor.h"
#include "app/session/session_requests.h"
#include "app/session/session_setup.h"
#include "app/session/sound/sound.h"
#include "protocols/design/protocol.h"
#include "results_schema/study.h"

namespace asperity {

/// An event that ends an attempt before its answer, or a text or question outside an attempt.
struct Interruption {
  AttemptOutcome outcome = AttemptOutcome::aborted;
  Phrase reason{};
  /// The session continues: the interrupted step is repeated.
  bool ask_again = false;
  Fault fault = Fault::none;  ///< the fault that the loop reported, if any
};

/// An interruption by a fault of the loop, or by the emergency stop.
Interruption interruption_by(const ServoStatus& status);
/// "a fault occurred in trial 3: the device does not respond"; without a trial "the emergency stop was pressed between
/// trials".
Phrase fault_sentence(const Interruption& interruption, std::optional<int> trial);

/// The operations that the plan and an attempt have in common: waiting, entering a phase, showing
/// the participant a scene, storing an event.
///
/// Waiting is done in slices of a few hundredths of a second. In each slice the rig ticks, button
/// changes of the device are passed to the respondent, the monitor is updated, and the
/// experimenter's requests are handled. Without a monitor nothing is published and changes of phase
/// are not stored, which keeps simulated studies small.
///
/// Events within an attempt are kept until `take_attempt_events` and belong to its row; those
/// outside are stored at once.
///
/// A problem that the device reports is displayed unchanged, and is reported and stored
/// (`device_trouble`, `device_well`) as DeviceComplaints specifies.
///
/// Threads: the conductor's.
class SessionCourse final {
 public:
  /// All must outlive the course.
  SessionCourse(Study& study, const Protocol& protocol, Rig& rig, Respondent& respondent,
                SessionRequests& requests, const SessionLinks& links);
  SessionCourse(const SessionCourse&) = delete;
  SessionCourse& operator=(const SessionCourse&) = delete;

  /// Begins the session of this row.
  void begin(const SessionRow& row);

  Study& study() noexcept { return study_; }
  const Protocol& protocol() const noexcept { return protocol_; }
  Rig& rig() noexcept { return rig_; }
  Respondent& respondent() noexcept { return respondent_; }
  Recorder& recorder() noexcept { return recorder_; }
  std::int64_t now_ns() const noexcept { return rig_.clock().now_ns(); }
  const SessionRow& row() const noexcept { return row_; }
  bool has_monitor() const noexcept { return links_.monitor != nullptr; }
  std::optional<int> last_trial() const noexcept { return links_.last_trial; }

  // --- time ---

  /// Throws Interruption on a fault, when the session is aborted, when the current trial is
  /// skipped, and when required masking noise stops.
  void wait(double duration_s);
  /// As `wait`, outside a trial: a requested stop after the trial ends it as well.
  void wait_outside_trial(double duration_s);
  /// As `wait`, within an attempt while neither a surface can be felt nor the question is shown:
  /// the respondent refuses answers meanwhile.
  void wait_refusing_answers(double duration_s);
  /// One slice, without regard to requests.
  void pass_slice();
  /// Called in each slice, also within attempts; it returns at once and throws nothing.
  void set_each_slice(std::function<void()> call) { each_slice_ = std::move(call); }
  static constexpr double kSlice_s = 0.02;

  // --- what is seen and heard ---

  /// Enters a phase: stores an event and informs the monitor.
  void enter(SessionPhase phase);
  /// Informs only the monitor, where the event was stored before.
  void publish(SessionPhase phase);
  SessionPhase phase() const noexcept { return phase_; }
  void show(ParticipantScene scene);
  /// States something at once to a user who has no window that shows it.
  void report_to_experimenter(const std::string& sentence) const;
  void set_facts(SessionFacts facts);
  /// The plan of the session has further trials.
  void set_plan(const Plan& plan);
  /// The plan as windows show it: that of a session which only tries a protocol ends with its last trial.
  Plan shown_of(const Plan& plan) const;
  /// The position of the last block that it has, from 1.
  int last_shown_block(const Plan& plan) const;
  void update(const std::function<void(SessionSnapshot&)>& change);
  void add_attempt(AttemptSummary attempt);
  void play(Cue cue, int number = 0);
  /// Does nothing where the protocol requests no noise or there is no sound.
  void set_masking(bool on);
  /// Tones warn the participant who feels a surface when force or speed leave the instructed range.
  void set_guiding_tones(bool on);
  bool is_masking() const noexcept { return masking_; }
  /// The protocol requests noise, a card is available to play it, and it is not playing. Without a
  /// card nothing was heard before either: the checklist and the window state this, and nothing can
  /// be repaired.
  bool has_lost_noise() const;
  /// The noise has played since the session was begun or resumed.
  bool has_masked() const noexcept { return has_masked_; }
  /// Asks the experimenter to do something (place a sample before a trial) and waits for the
  /// confirmation; the participant is not shown the request. Without an experimenter the respondent
  /// reads it.
  void ask_experimenter(const Phrase& prompt, const Wait& waiting);
  /// Whether the experimenter is asked, and not the respondent.
  bool asks_experimenter() const;
  /// Has a participant who wears an eye mask put it on or take it off, if that is not already done.
  void put_mask(bool on, const Wait& waiting);

  // --- what is written down ---

  void event(const std::string& kind, const Phrase& text, const std::string& data_json = "null");
  /// Stores the experimenter's remarks since the last call.
  void store_remarks();
  /// Stores the events at the participant's side outside an attempt.
  void store_respondent_events();
  void begin_attempt();
  /// Counts force and speed against these bands from now on.
  void watch_hand(const HandBands& bands) { watch_.begin_attempt(bands); }
  /// Ends the attempt: its events, in the order of time.
  std::vector<EventRow> take_attempt_events();

 private:
  void wait_in_slices(double duration_s, const std::function<void()>& after_each);
  void pass(double duration_s);
  void look(bool outside_trial);
  void listen_to_device();
  void publish_now();
  bool plays_noise() const;
  MaskingState masking_state() const;

  Study& study_;
  const Protocol& protocol_;
  Rig& rig_;
  Respondent& respondent_;
  SessionRequests& requests_;
  SessionLinks links_{};
  RecordWatch watch_;
  Recorder recorder_;
  SessionRow row_{};
  SessionPhase phase_ = SessionPhase::idle;
  bool in_attempt_ = false;
  bool masking_ = false;
  bool guiding_ = false;
  bool has_masked_ = false;
  bool mask_on_ = false;
  std::vector<EventRow> attempt_events_{};
  std::int64_t health_shown_ns_ = 0;
  DeviceComplaints complaints_{};
  std::function<void()> each_slice_{};
};

}  // namespace asperity
