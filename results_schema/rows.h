// What a study remembers, row by row.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/stored_words.h"

namespace asperity {

/// A person, or a virtual one (marked so for ever).
struct ParticipantRow {
  std::string label{};  ///< [0-9A-Za-z]{1,32}
  bool is_virtual = false;
  std::optional<double> age_years{};
  std::optional<std::string> sex{};         ///< "F", "M", "X"
  std::optional<std::string> handedness{};  ///< "left", "right", "ambidextrous"
  std::string answers_json = "{}";          ///< the other questions of the protocol
  std::string created_utc{};
  bool withdrawn = false;  ///< as read: their data are kept and never used, see Study::withdraw
};

struct ProtocolRow {
  std::int64_t id = 0;
  std::string name{};
  std::string version{};
  std::string kind{};
  std::string design{};
  std::string source_sha256{};
  std::string source{};  ///< the file, byte for byte
};

/// A file that a session used, identified by its content.
struct StimulusFileRow {
  std::string path{};  ///< study-relative
  std::string sha256{};
  std::int64_t bytes = 0;
};

enum class SessionMode { run, pilot, simulate };
enum class SessionState { open, completed, stopped, crashed };

/// One participant, one protocol, one sitting, with everything needed to know later how it was run.
struct SessionRow {
  std::int64_t id = 0;
  std::string participant{};
  int session = 0;  ///< ordinal within the participant, 1-based
  std::int64_t protocol_id = 0;
  SessionMode mode = SessionMode::run;
  SessionState state = SessionState::open;
  std::string seed{};  ///< decimal, 64-bit
  std::string generator{};
  int counterbalance_row = 0;
  std::optional<std::string> group_level{};  ///< of the participant, where the protocol has groups
  /// Where the trials depend on responses: the number expected when the session began.
  std::optional<int> expected_trials{};
  std::string program_version{};
  std::string program_commit{};
  std::string program_build{};
  std::string program_sha256{};
  std::string instruction_set{};
  std::string os{};
  std::string device{};       ///< driver and model
  std::string device_json{};  ///< the capability record
  std::string pacing{};       ///< "stepped", "real_time"
  std::string scheduling{};
  double rate_Hz = 0.0;
  std::string started_utc{};
  std::int64_t clock_zero_ns =
      0;  ///< monotonic time at started_utc; every time_ns is on this clock
  std::optional<std::string> ended_utc{};
  std::optional<std::string> consent_version{};
  std::optional<std::string> consent_utc{};
  std::string observer_json = "null";     ///< of a virtual participant
  bool mirrored = false;                  ///< left-handed layout: x of the workspace is negated
  std::optional<StoredWords> excluded{};  ///< why analyses leave the session out, if they do
  bool withdrawn = false;                 ///< as read: see ParticipantRow::withdrawn
  std::vector<StimulusFileRow> files{};
};

/// A place in a study that is divided among stations, and what the participant at this place is assigned.
struct ClaimedPlace {
  int place = 0;        ///< in the whole study, from 1
  std::string group{};  ///< empty where the protocol has no groups
  int row = 0;          ///< of the counterbalancing, from 0

  bool operator==(const ClaimedPlace&) const = default;
};

/// EventRow::kind of the event that states the place of a session's participant; the data have `place`.
inline constexpr const char* kDealtEvent = "dealt";

/// What a new session is assigned from, inside the transaction that stores it.
struct SessionClaim {
  int rows = 1;                       ///< of the counterbalancing, from 0
  std::vector<std::string> groups{};  ///< levels to choose from where the session states none
  /// The group of a participant who is assigned after so many others, including those who withdrew. Null: the group with
  /// the fewest participants.
  std::function<std::string(std::size_t assigned)> group_after{};
  /// The places that are dealt to this study, in the order in which they are taken; empty for a study that is not divided. They
  /// determine row and group in place of the members above.
  std::vector<ClaimedPlace> places{};
  /// A participant who dropped out or withdrew keeps the place, as in a sequence that nobody must be able to foresee.
  bool keeps_places = false;
};

struct PlannedTrialRow {
  int trial = 0;  ///< ordinal within the session
  std::string block{};
  int block_ordinal = 0;
  std::string phase{};
  int repetition = 1;
  /// Where a procedure chose its level: the track within the run of its block, and the place in it.
  std::optional<int> track{};
  std::optional<int> step{};
  bool is_catch = false;  ///< a catch trial of a procedure
  std::string factors_json = "{}";
  std::string plan_json = "{}";  ///< json_of(Trial)
};

/// How often a force model was asked beyond what it can render as it should.
struct ModelLimitRow {
  std::string kind{};
  std::int64_t ticks = 0;
};

/// What a stimulus was made from, identified by its content.
struct AssetRow {
  std::string
      role{};  ///< "height_field", "surface", "tool", "plugin", or declared by the force model
  std::string sha256{};
  bool operator==(const AssetRow&) const = default;
};

/// The SHA-256 of the asset of that role, if there is one.
std::optional<std::string> asset_sha256(const std::vector<AssetRow>& assets, std::string_view role);

/// AssetRow::role of the shared library in which the force model is.
inline constexpr std::string_view kPluginRole = "plugin";

/// A plug-in that rendered surfaces.
struct PluginUse {
  std::string model{};
  std::string model_version{};
  std::string sha256{};
  std::int64_t attempts = 0;
};

/// One visit of the hand to a surface: from a contact until another surface is presented or touched, or until this one
/// is presented again.
struct VisitRow {
  std::int64_t contact_ns = 0;  ///< first tick of contact
  std::int64_t offset_ns = 0;   ///< last tick of contact
  double contact_s = 0.0;       ///< above 0
  double path_m = 0.0;          ///< travelled along the surface in contact
  /// Of the pressing force; absent where the surface was never completely faded in.
  std::optional<double> force_mean_N{};
  std::optional<double> force_sd_N{};
  double speed_mean_m_per_s = 0.0;  ///< tangential, over the ticks of contact
  double speed_sd_m_per_s = 0.0;

  bool operator==(const VisitRow&) const = default;
};

/// The detectors of perceived instability of one presentation. Each of the three has a value or the reason why it has none
/// ("too_short", "no_force", "low_rate", "no_crests").
struct InstabilityRow {
  std::optional<double> buzz{};  ///< vibration relative to the texture force
  std::optional<double> buzz_force_N{};
  std::optional<std::int64_t> buzz_ns{};
  std::optional<std::string> no_buzz{};
  std::optional<double> resting_s{};
  std::optional<double> alive_force_N{};
  std::optional<double> alive_plate_force_N{};
  std::optional<double> alive_motion_m{};
  std::optional<double> alive_work_J{};  ///< absent without a closed part of the path
  std::optional<std::string> no_aliveness{};
  std::optional<double> crest_share{};
  std::optional<double> slow_s{};
  std::optional<std::string> no_crest_share{};
  bool operator==(const InstabilityRow&) const = default;
};

struct PresentationRow {
  int position = 0;  ///< 1-based
  std::string role{};
  std::string item{};
  std::string stimulus{};
  std::string model{};
  std::string model_version{};
  std::string texture{};
  std::string parameters_json = "{}";  ///< complete, as rendered, matching solved
  std::string seed{};
  /// Of the surface without its texture, and the height of its plane above that of the workspace.
  double stiffness_N_per_m = 0.0;
  double friction = 0.0;
  double raised_m = 0.0;
  std::optional<std::int64_t> onset_ns{};    ///< first tick with the surface rendered
  std::optional<std::int64_t> contact_ns{};  ///< first tick with the probe in the surface
  std::optional<std::int64_t> offset_ns{};
  double contact_s = 0.0;
  /// Gaps of more than two periods between two ticks, where this surface was touched in one of the two.
  std::int64_t gaps_in_contact = 0;
  std::optional<double> matched_texture_force_N{};   ///< target of an equal-force request
  std::optional<double> achieved_texture_force_N{};  ///< RMS in the same band, from the record
  std::vector<AssetRow> assets{};                    ///< as read: by role
  std::vector<ModelLimitRow> limits{};               ///< by kind; of a model that watches any
  /// In temporal order.
  std::vector<VisitRow> visits{};
  /// Absent in interrupted attempts, and where it could not be computed.
  std::optional<InstabilityRow> instability{};
};

/// ResponseRow::source of a question of the session whose condition was not met. Such a question has one row with an empty
/// answer, and so has one that was left empty, with the source of the participant.
inline constexpr std::string_view kNotAsked = "not_asked";

struct ResponseRow {
  std::string question{};
  int item = 1;  ///< 1 for a choice; the presentation's position for an assignment
  std::string answer{};
  std::optional<double> answer_number{};
  std::optional<bool> correct{};
  std::string options_json = "[]";  ///< as shown, in order
  std::int64_t time_ns = 0;
  std::optional<double> from_contact_s{};  ///< reaction time from the first contact
  std::optional<double> from_cue_s{};      ///< reaction time from the question
  std::string source{};                    ///< "keyboard", "virtual", "virtual_guess", kNotAsked
};

struct ServoQualityRow {
  double rate_Hz = 0.0;
  std::int64_t ticks = 0;
  double period_mean_s = 0.0;
  double period_sd_s = 0.0;
  double period_p50_s = 0.0;
  double period_p99_s = 0.0;
  double period_p99_9_s = 0.0;
  double period_maximum_s = 0.0;
  double lateness_p50_s = 0.0;
  double lateness_p99_s = 0.0;
  double lateness_maximum_s = 0.0;
  double execution_p99_s = 0.0;
  double execution_maximum_s = 0.0;
  std::int64_t missed_deadlines = 0;
  std::int64_t missed_in_contact = 0;  ///< those while a surface was touched
  std::int64_t gaps_in_contact = 0;    ///< more than two periods, while any surface was touched
  std::int64_t held_readings = 0;      ///< implausible ones, replaced by the last plausible one
  std::int64_t saturated_ticks = 0;
  std::int64_t slew_limited_ticks = 0;
  std::int64_t not_finite_ticks = 0;
  std::int64_t lost_records = 0;
  std::string fault = "none";
};

/// One quantity of one presentation against its band.
struct ComplianceRow {
  int position = 0;
  std::string
      quantity{};  ///< "normal_force_N", "speed_m_per_s", "contact_s", "strokes", "stroke_length_m"
  std::optional<double> minimum{};
  std::optional<double> maximum{};
  double mean = 0.0;
  double sd = 0.0;
  double p05 = 0.0;
  double p50 = 0.0;
  double p95 = 0.0;
  std::optional<double> fraction_in_band{};
  std::optional<bool> passed{};  ///< absent where the protocol declares nothing
};

struct RecordingRow {
  std::string path{};  ///< study-relative
  std::string format{};
  std::string sha256{};
  std::int64_t records = 0;
  std::int64_t bytes = 0;
};

struct EventRow {
  std::int64_t time_ns = 0;
  std::string kind{};
  std::string text{};
  std::string data_json = "null";
  /// Of a text in words: as StoredWords::json. Empty of names and data.
  std::string text_json{};
  StoredWords words() const { return {text, text_json}; }
};

/// EventRow::kind of the event that states from which study a session was merged, and its `id` there: the data have `study`,
/// `created_utc`, `source` and `session_id`. A session that was merged twice has two, the earlier one first.
inline constexpr const char* kMergedEvent = "merged";

enum class AttemptOutcome {
  answered,
  timed_out,
  not_compliant,
  aborted,
  device_fault,
  /// It was pressed, and nothing failed. In the database `device_fault` with this fault in
  /// servo_quality.
  emergency_stop,
  skipped,
};
/// The force was latched at zero: by a fault of the device or by the emergency stop.
constexpr bool is_fault(AttemptOutcome outcome) noexcept {
  return outcome == AttemptOutcome::device_fault || outcome == AttemptOutcome::emergency_stop;
}

/// What an attempt is made for.
enum class AttemptPurpose {
  trial,      ///< to complete its trial
  refresher,  ///< to practise again when a session is resumed; it never counts
};

/// One go at a trial, with all that hangs on it: written in one transaction or not at all.
struct AttemptRow {
  std::int64_t id = 0;
  int trial = 0;
  int attempt = 0;  ///< 1-based within the trial
  int segment = 0;  ///< which uninterrupted stretch of the session
  AttemptPurpose purpose = AttemptPurpose::trial;
  AttemptOutcome outcome = AttemptOutcome::answered;
  bool valid = true;  ///< as read: and not set aside
  std::optional<StoredWords> invalid_reason{};
  /// As read: why analyses leave it out although it is valid, if they do (it or its session was
  /// excluded).
  std::optional<StoredWords> excluded{};
  bool flagged = false;
  std::optional<StoredWords> flag_reason{};
  std::int64_t onset_ns = 0;
  std::int64_t offset_ns = 0;
  std::vector<PresentationRow> presentations{};
  std::vector<ResponseRow> responses{};
  std::optional<ServoQualityRow> servo{};
  std::vector<ComplianceRow> compliance{};
  std::optional<RecordingRow> recording{};
  std::vector<EventRow> events{};
};

/// A decision about data: they stay, and the decision is stored next to them.
enum class Verdict {
  set_aside,  ///< of an attempt: no longer the valid one of its trial, which is asked again; final
  flag,       ///< of an attempt: counts, but look at it
  exclude,    ///< of an attempt or a session: analyses leave it out
  include,    ///< takes an exclusion back
};

struct DecisionRow {
  std::optional<int> trial{};  ///< both absent: about the whole session
  std::optional<int> attempt{};
  Verdict verdict = Verdict::exclude;
  StoredWords reason{};
  std::string decided_by{};   ///< may be empty
  std::string decided_utc{};  ///< empty: now
};

/// Who answers for a study, and what an archive asks of a dataset. All of it can be changed later.
struct StudyMetadata {
  std::vector<std::string> authors{};            ///< in the order of a byline, "Family, Given"
  std::optional<std::string> license{};          ///< of the data: "CC-BY-4.0"
  std::optional<std::string> ethics_approval{};  ///< committee and number
  bool operator==(const StudyMetadata&) const = default;
};

/// What was made of a study and left its folder.
enum class OutputKind { export_, public_export, report, copy, merge };

struct OutputRow {
  OutputKind kind = OutputKind::export_;
  std::string
      path{};  ///< absolute, where it was written; empty where it contained the label of a deleted participant
  std::string program_version{};
  std::string made_utc{};  ///< empty: it is being made, or its program was killed
};

/// What becomes of the data of a participant who withdraws.
enum class WithdrawnData {
  kept,     ///< and never used: no analysis, no public export, no further session
  deleted,  ///< with every trace in the folder of the study
};

enum class WithdrawalReason { consent_withdrawn, not_eligible, other };

/// That a participant withdrew, without saying which: of one whose data were deleted nothing else remains.
struct WithdrawalRow {
  WithdrawnData data = WithdrawnData::kept;
  bool is_virtual = false;  ///< as read, like the counts
  WithdrawalReason reason = WithdrawalReason::consent_withdrawn;
  std::string decided_by{};
  std::string withdrawn_utc{};  ///< empty: now
  int sessions = 0;
  int attempts = 0;
  int answers = 0;     ///< to trials and to questions of sessions
  int recordings = 0;  ///< files
};

/// What a withdrawal did, and what it left to the user.
struct Withdrawal {
  WithdrawalRow row{};
  /// That may contain data of the participant: of a person those made since they were added, otherwise all that were made.
  std::vector<OutputRow> outputs{};
};

const char* text_of(Verdict verdict) noexcept;
const char* text_of(SessionMode mode) noexcept;
const char* text_of(SessionState state) noexcept;
const char* text_of(AttemptOutcome outcome) noexcept;
const char* text_of(AttemptPurpose purpose) noexcept;
const char* text_of(OutputKind kind) noexcept;
const char* text_of(WithdrawnData data) noexcept;
const char* text_of(WithdrawalReason reason) noexcept;

}  // namespace asperity
