// What a running session looks like from outside: one writer, any readers.

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

#include "app/session/respondents/participant_scene.h"
#include "app/words/phrase.h"
#include "protocols/plan/plan.h"
#include "renderers/servo/servo_loop.h"
#include "results_schema/rows.h"

namespace asperity {

/// Where a session is. Every change is an event in the store.
enum class SessionPhase {
  idle,      ///< not begun
  ready,     ///< something is read or checked before a block
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

/// One attempt that is on disk, in few words.
struct AttemptSummary {
  int trial = 0;
  int attempt = 0;
  AttemptOutcome outcome = AttemptOutcome::answered;
  bool valid = true;
  bool flagged = false;
  Phrase reason{};                     ///< why it does not count, or is flagged; may be empty
  std::vector<std::string> answers{};  ///< labels as shown ("4", "B"), one per item
  std::optional<bool> correct{};       ///< all of them; absent where nothing is right or wrong
  std::optional<double> from_cue_s{};  ///< reaction times
  std::optional<double> from_contact_s{};
  double duration_s = 0.0;
};

/// What stopped the force or the session, for a banner.
struct SessionTrouble {
  enum class Remedy {
    none,
    clear_fault,  ///< when the reason is mended, go on
    resume,       ///< paused by the program
    confirm,      ///< nothing is wrong: `what` is to be done before the trial, and confirmed
    try_again,    ///< the session ended; everything stored, go on with it from the start page
  };
  Phrase what{};  ///< a sentence: what happened and what was done about it
  std::int64_t time_ns = 0;
  Remedy remedy = Remedy::none;
};

/// What does not change while a session runs.
struct SessionFacts {
  std::shared_ptr<const Protocol> protocol{};
  std::shared_ptr<const Plan> plan{};
  SessionRow row{};
  std::string study_folder{};
  bool mirrored = false;            ///< left-handed layout
  std::int64_t clock_ahead_ns = 0;  ///< of the session's clock against the machine's steady clock
  /// Of a resumed session: how long its trials have taken so far, and what was noted.
  double earlier_s = 0.0;
  std::vector<Phrase> earlier_notes{};
};

/// What is to be heard of the masking noise.
enum class MaskingState {
  none,      ///< the protocol requests none, nothing plays in this session, or it has ended
  off,       ///< it can sound, and there is nothing to mask now
  on,        ///< sounding
  silent,    ///< the sound card does not play
  no_card,   ///< there is no sound card, and it cannot be heard
  elsewhere  ///< likewise, but a person has measured the noise that something else plays
};

/// How the servo loop has kept time in the last seconds.
struct LoopHealth {
  double rate_Hz = 0.0;  ///< measured
  double lateness_p50_s = 0.0;
  double lateness_p99_s = 0.0;
  double lateness_maximum_s = 0.0;
  std::uint64_t missed_deadlines = 0;  ///< of the session
  std::uint64_t lost_records = 0;
  std::uint64_t saturated_ticks = 0;
};

/// One quantity of a contact so far, against its band: the force in every tick, the speed of every stroke.
struct QuantitySoFar {
  std::int64_t samples = 0;
  double mean = 0.0;
  double sd = 0.0;
  std::optional<double> fraction_in_band{};  ///< absent without samples or band
};

/// How the hand has explored the surface that was presented last: what the attempt would be judged by
/// if feeling ended now. Agrees with the stored compliance to 1e-9.
struct HandSoFar {
  int surface = 0;  ///< position; 0 before the first of an attempt
  QuantitySoFar force_N{};
  QuantitySoFar speed_m_per_s{};
};

/// The session at one moment.
struct SessionSnapshot {
  std::uint64_t version = 0;  ///< grows with every change
  /// Before the session begins: how far the comparison of its plan with the device is, 0 to 1.
  std::optional<double> compared{};
  SessionPhase phase = SessionPhase::idle;
  std::int64_t phase_began_ns = 0;
  std::int64_t now_ns = 0;    ///< the session's clock when this was written
  std::int64_t began_ns = 0;  ///< of this stretch
  int trial = 0;              ///< under way, or else the one that comes; 0 where none does
  int attempt = 0;            ///< at it
  int last_done = 0;          ///< trial that would be repeated as the last one; 0: none yet
  int surface = 0;            ///< position, from 1; 0 while none is felt
  double contact_s = 0.0;     ///< with the present surface
  double wanted_contact_s = 0.0;
  HandSoFar hand{};  ///< stays until the next attempt begins
  int block = 0;     ///< 1-based; 0 outside blocks
  int blocks = 0;
  int trials_done = 0;
  int trials = 0;
  std::optional<double> expected_left_s{};  ///< absent while too few trials have been done to know
  std::int64_t rows_stored = 0;             ///< attempts in the store, of this session
  LoopHealth health{};
  Fault fault = Fault::none;
  MaskingState masking = MaskingState::none;
  std::optional<SessionTrouble> trouble{};
  /// The problem that the device reports (HapticDevice::complaint), and since when; empty while all is well.
  std::string device_complaint{};
  std::int64_t device_complains_since_ns = 0;
  std::shared_ptr<const ParticipantScene> scene = std::make_shared<const ParticipantScene>();
  std::shared_ptr<const std::vector<AttemptSummary>> attempts =
      std::make_shared<const std::vector<AttemptSummary>>();
};

/// What the probe did in 1/60 s: extremes, so that a plot shows every peak.
struct LiveBin {
  std::int64_t time_ns = 0;      ///< of its end
  float force_minimum_N = 0.0F;  ///< magnitude of the force that was sent
  float force_maximum_N = 0.0F;
  float speed_minimum_m_per_s = 0.0F;
  float speed_maximum_m_per_s = 0.0F;
  /// At its end, as the attempt is judged by (HandWatch): a surface that is wholly there is felt; how
  /// hard the hand presses, 0 where none is felt; and what is shown of the speed of its strokes.
  bool is_felt = false;
  double pressing_N = 0.0;
  std::optional<double> stroking_m_per_s{};
  float x_m = 0.0F;  ///< at its end
  float y_m = 0.0F;
  float z_m = 0.0F;
  glm::quat orientation{1.0F, 0.0F, 0.0F, 0.0F};  ///< likewise
  bool touching = false;
  int surface = 0;
};

/// Written by the conductor's thread, read by any other.
///
/// A reader's call copies and never waits for more than another copy; bins are kept for
/// `kKept_s`.
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
  /// `change` alters the snapshot under the lock: keep it short. `version` is counted up.
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

/// The codes that stand for stimuli while these are concealed: one per distinct presentation of
/// the plan, "S1" … in an order drawn from the session's seed.
class BlindCodes final {
 public:
  BlindCodes(const Plan& plan, const std::string& seed);
  /// Of one surface.
  const std::string& of(const PlannedPresentation& surface) const;
  /// Of a trial: the codes of its surfaces in order, "S3 S1 S2".
  std::string of(const Trial& trial) const;

 private:
  std::vector<std::pair<std::string, std::string>> codes_{};
};

/// The same with names: "height_map brick, sinusoid brick", for who may know.
std::string unblinded_text(const Trial& trial);

}  // namespace asperity
