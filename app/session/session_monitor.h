// The state of a running session as it is shown to other threads: one writer, any number of
// readers.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "analysis/words/phrase.h"
#include "app/session/respondents/participant_scene.h"
#include "protocols/plan/plan.h"
#include "protocols/procedures/level_answer.h"
#include "renderers/servo/servo_loop.h"
#include "results_schema/rows.h"

namespace asperity {

/// The phase of a session. Every change is an event in the store.
enum class SessionPhase {
  idle,      ///< not begun
  ready,     ///< before a block: a text is read or a check is made
  iti,       ///< between trials
  fore,      ///< the trial has begun, no contact yet
  contact,   ///< a surface is felt
  response,  ///< the question is open
  feedback,
  rest,       ///< a break
  questions,  ///< of a questionnaire
  paused,
  fault,  ///< force latched at zero; waits for `clear_fault` or the end
  ended,
};
const char* text_of(SessionPhase phase) noexcept;

/// A summary of one attempt that is stored on disk.
struct AttemptSummary {
  int trial = 0;
  int attempt = 0;
  AttemptPurpose purpose = AttemptPurpose::trial;
  AttemptOutcome outcome = AttemptOutcome::answered;
  bool valid = true;
  bool flagged = false;
  Phrase reason{};                     ///< why it does not count, or is flagged; may be empty
  std::vector<std::string> answers{};  ///< labels as shown ("4", "B"), one per item
  /// Of all items together; absent where there are no correct responses.
  std::optional<bool> correct{};
  /// What the response means for the track of the trial; absent where it does not count for one.
  std::optional<LevelAnswer> answer_of_track{};
  std::optional<double> from_cue_s{};  ///< response times
  std::optional<double> from_contact_s{};
  double duration_s = 0.0;
};

/// What stopped the force or the session, for a banner.
struct SessionTrouble {
  enum class Remedy {
    none,
    clear_fault,  ///< once the cause is corrected, resume
    resume,       ///< paused by the program
    confirm,      ///< no problem: `what` is to be done before the trial, and confirmed
    /// The session ended; everything is stored, and it can be resumed from the start page.
    try_again,
  };
  Phrase what{};  ///< a sentence: what happened and how the program responded
  std::int64_t time_ns = 0;
  Remedy remedy = Remedy::none;
};

/// Properties that are constant while a session runs.
struct SessionFacts {
  std::shared_ptr<const Protocol> protocol{};
  std::shared_ptr<const Plan> plan{};
  SessionRow row{};
  std::string study_folder{};
  bool mirrored = false;  ///< left-handed layout
  /// Of the session's clock, relative to the machine's steady clock.
  std::int64_t clock_ahead_ns = 0;
  /// Of a resumed session: the time taken by its trials so far, and its notes.
  double earlier_s = 0.0;
  std::vector<Phrase> earlier_notes{};
};

/// The state of the masking noise.
enum class MaskingState {
  /// The protocol requests none, there is no sound in this session, or the session has ended.
  none,
  off,       ///< available, and not needed now
  on,        ///< playing
  silent,    ///< the sound card does not play
  no_card,   ///< there is no sound card, and the noise cannot be heard
  elsewhere  ///< there is no sound card, but the noise from another source was measured by a person
};

/// The timing of the servo loop in the last seconds.
struct LoopHealth {
  double rate_Hz = 0.0;  ///< measured
  double lateness_p50_s = 0.0;
  double lateness_p99_s = 0.0;
  double lateness_maximum_s = 0.0;
  std::uint64_t missed_deadlines = 0;  ///< of the session
  std::uint64_t lost_records = 0;
  std::uint64_t saturated_ticks = 0;
};

/// One quantity of a contact so far, compared with its band: the force in every tick, the speed of
/// every stroke.
struct QuantitySoFar {
  std::int64_t samples = 0;
  double mean = 0.0;
  double sd = 0.0;
  std::optional<double> fraction_in_band{};  ///< absent without samples or band
};

/// The exploration of the surface that was presented last: the measures by which the attempt would
/// be judged if feeling ended now. Agrees with the stored compliance to 1e-9.
struct HandSoFar {
  int surface = 0;  ///< position; 0 before the first of an attempt
  QuantitySoFar force_N{};
  QuantitySoFar speed_m_per_s{};
};

/// The session at one moment.
struct SessionSnapshot {
  std::uint64_t version = 0;  ///< grows with every change
  /// Before the session begins: the progress of the comparison of its plan with the device, 0 to 1.
  std::optional<double> compared{};
  SessionPhase phase = SessionPhase::idle;
  std::int64_t phase_began_ns = 0;
  std::int64_t now_ns = 0;    ///< the session's clock at this update
  std::int64_t began_ns = 0;  ///< of this stretch
  int trial = 0;              ///< current, or otherwise the next one; 0 where there is none
  int attempt = 0;            ///< of the trial
  AttemptPurpose purpose = AttemptPurpose::trial;  ///< of the current attempt; `trial` is its trial
  int last_done = 0;       ///< the trial that `repeat_last` would repeat; 0: none yet
  int surface = 0;         ///< position, from 1; 0 while none is felt
  double contact_s = 0.0;  ///< with the current surface
  double wanted_contact_s = 0.0;
  /// The surface appeared around the probe, which has not left it yet: there is no force.
  bool is_inside = false;
  HandSoFar hand{};  ///< kept until the next attempt begins
  int block = 0;     ///< 1-based; 0 outside blocks
  int blocks = 0;
  int trials_done = 0;
  int trials = 0;
  /// Of `trials_done`, those without an attempt that completes them: their block needed no more (TrialTally::is_over).
  int trials_not_needed = 0;
  bool trials_are_estimated = false;  ///< their number depends on responses
  /// Absent until enough trials have been completed for an estimate.
  std::optional<double> expected_left_s{};
  std::int64_t rows_stored = 0;  ///< attempts in the store, of this session
  LoopHealth health{};
  Fault fault = Fault::none;
  MaskingState masking = MaskingState::none;
  std::optional<SessionTrouble> trouble{};
  /// The problem that the device reports (HapticDevice::complaint), and since when; empty while
  /// there is none.
  std::string device_complaint{};
  std::int64_t device_complains_since_ns = 0;
  std::shared_ptr<const ParticipantScene> scene = std::make_shared<const ParticipantScene>();
  std::shared_ptr<const std::vector<AttemptSummary>> attempts =
      std::make_shared<const std::vector<AttemptSummary>>();
};

/// The motion and force of the probe in 1/60 s, as extremes, so that a plot shows every peak.
struct LiveBin {
  std::int64_t time_ns = 0;      ///< of its end
  float force_minimum_N = 0.0F;  ///< magnitude of the force that was sent
  float force_maximum_N = 0.0F;
  float speed_minimum_m_per_s = 0.0F;
  float speed_maximum_m_per_s = 0.0F;
  /// At its end, by the measures that judge the attempt (HandWatch): whether a completely faded-in
  /// surface is felt; how hard the hand presses, 0 where none is felt; and the displayed speed of
  /// its strokes.
  bool is_felt = false;
  double pressing_N = 0.0;
  std::optional<double> stroking_m_per_s{};
  float x_m = 0.0F;  ///< at its end
  float y_m = 0.0F;
  float z_m = 0.0F;
  glm::quat orientation{1.0F, 0.0F, 0.0F, 0.0F};  ///< at its end
  bool touching = false;                          ///< at its end: `is_in_contact` (contact.h)
  int surface = 0;
};

/// Publishes the state of a session: written by the conductor's thread, read by any other.
///
/// A reader's call copies, and waits only for other copies; bins are kept for `kKept_s`.
class SessionMonitor final {
 public:
  static constexpr double kBin_s = 1.0 / 60.0;
  static constexpr double kKept_s = 60.0;

  SessionMonitor() = default;
  SessionMonitor(const SessionMonitor&) = delete;
  SessionMonitor& operator=(const SessionMonitor&) = delete;

  SessionSnapshot snapshot() const;
  /// Null until the session has begun.
  std::shared_ptr<const SessionFacts> facts() const;
  /// The bins from number `first` on (those that are still kept), and the number after the last.
  std::uint64_t bins_from(std::uint64_t first, std::vector<LiveBin>& bins) const;

  // --- the conductor's side ---

  void set_facts(SessionFacts facts);
  /// The plan of the session has further trials.
  void set_plan(std::shared_ptr<const Plan> plan);
  /// `change` alters the snapshot under the lock and has to be short. `version` is incremented.
  void update(const std::function<void(SessionSnapshot&)>& change);
  void show(ParticipantScene scene);
  void add_attempt(AttemptSummary attempt);
  void add_bin(const LiveBin& bin);

 private:
  mutable std::mutex mutex_{};
  SessionSnapshot snapshot_{};
  std::shared_ptr<const SessionFacts> facts_{};
  std::vector<LiveBin> bins_{};  // a ring
  std::uint64_t bins_added_ = 0;
};

/// Whether the surfaces of a trial have the codes of their places, "A" and "B", while stimuli are concealed: in a
/// discrimination a code of the standard would return in every trial and reveal the correct response, and that of a
/// level the next level of a procedure.
bool is_named_by_places(const Trial& trial);

/// The codes for stimuli while these are concealed: one per distinct presentation of the plan, "S1"
/// … in an order drawn from the session's seed.
class BlindCodes final {
 public:
  BlindCodes(const Plan& plan, const std::string& seed);
  /// The code of one surface.
  const std::string& of(const PlannedPresentation& surface) const;
  /// The codes of a trial's surfaces in order, "S3 S1 S2".
  std::string of(const Trial& trial) const;

 private:
  std::vector<std::pair<std::string, std::string>> codes_{};
};

/// The same with names: "height_map brick, sinusoid brick", for users who may see them.
std::string unblinded_text(const Trial& trial);

}  // namespace asperity
