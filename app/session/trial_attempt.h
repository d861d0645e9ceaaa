// Runs one attempt at a trial: surfaces are felt, the question is asked, the record is checked.

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/session/attempt_instability.h"
#include "app/session/rig/visit_reader.h"
#include "app/session/session_course.h"
#include "app/session/stimulus_builder.h"
#include "app/session/trial_surfaces.h"
#include "device/virtual_hand.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// The attempt to be made.
struct AttemptOrder {
  const Trial& trial;
  int attempt = 1;
  int segment = 1;
  AttemptPurpose purpose = AttemptPurpose::trial;
  /// Earlier attempts at this trial that did not comply with the instructed exploration.
  int explored_wrongly = 0;
  /// Of the same stimulus by the same participant, where a number is requested.
  std::optional<double> earlier_estimate{};
  /// Earlier attempts at this trial that were repeated because a force vibrated.
  int repeated_for_buzz = 0;
  bool record = true;  ///< keep the tick records
};

/// Takes the surfaces, whose renderers are made → lets every surface be felt as the trial arranges them → asks → checks the
/// record (servo quality, visits, compliance, features) → syncs and renames the recording. The row is then
/// ready to be stored; nothing is in the store before.
///
/// An attempt that was interrupted has a row as well, invalid, with the reason.
///
/// Pages of questions (pages_of) are asked one after another, each with its own cue and deadline.
/// Where a deadline passes, the attempt has timed out; the answers to earlier pages are stored.
/// A question whose condition is not met is stored as not asked.
///
/// Where surfaces are felt again the page is asked more than once. The response time from the cue
/// counts from the first time, feeling again included: it is the time until the decision. The
/// deadline limits the time in which an answer was possible: it stands still from the wish to feel
/// again until the page is asked again.
///
/// A number that is ten times an earlier one of the same stimulus, or a tenth of it, is asked for
/// once more: the second number is the answer, and the first is stored as the event
/// "estimate_doubted". Where the deadline comes before a second one, the first is the answer.
///
/// Feeling ends when the surface was felt for the specified time or number of strokes, or at the participant's request:
/// in all cases the cue `next` sounds and the scene shows it until the hand has lifted. Surfaces side by side are felt in
/// one presentation, which ends when each of them was visited and felt for long enough.
///
/// An exploration that complied when the page was asked is not repeated for what feeling again added to it: the attempt is flagged.
///
/// Phases: fore → contact (with the first touch) → fore before the next surface → … → response, and
/// fore and contact again where a surface is felt again.
///
/// Errors: errors of a renderer, a file or the recording; the recorder then has to be abandoned.
class TrialAttempt final {
 public:
  /// Course and order must outlive the attempt.
  TrialAttempt(SessionCourse& course, TrialSurfaces surfaces, const AttemptOrder& order);
  ~TrialAttempt();
  TrialAttempt(const TrialAttempt&) = delete;
  TrialAttempt& operator=(const TrialAttempt&) = delete;

  AttemptRow make();
  /// The interruption, if there was one.
  const std::optional<Interruption>& interruption() const noexcept { return interruption_; }

 private:
  /// A page of questions while it is asked.
  struct Asking {
    std::span<const Question> page{};
    std::optional<std::int64_t> cue_ns{};  ///< when it was asked first
    std::int64_t answer_ns = 0;            ///< of the last reply
    double answerable_s = 0.0;             ///< how long an answer was possible, over all times
    std::optional<Reply> doubted{};        ///< the answer before it was asked for once more
  };
  /// An answer as it is stored; none where the question was not asked.
  struct Answered {
    const Question& question;
    std::optional<Answer> answer{};
    std::int64_t cue_ns = 0;
    std::int64_t answer_ns = 0;
    std::string source{};
  };

  void prepare();
  HandHabits habits_of_hand() const;  ///< of a virtual hand
  void carry_out();
  /// Whether the condition of the question is met by the answers so far.
  bool is_to_be_asked(const Question& question) const;
  /// Asks until the page is answered (true) or its deadline has passed (false).
  bool answer_page(std::span<const Question> page);
  Reply ask(Asking& asking);
  /// Whether the reply is a number that has to be confirmed.
  bool is_doubtful(const Asking& asking, const Reply& reply) const;
  void doubt(Asking& asking, const Reply& reply);
  void wait_between_surfaces();
  /// Whether the hand touched a surface while it was presented.
  enum class Contact { none, made };
  /// Presents a surface, or all of them side by side, until it was felt.
  Contact feel(std::size_t index);
  /// The same for a visit that the arrangement prescribes: without a contact the attempt ends.
  void feel_once(std::size_t index);
  /// Throws Interruption where the surface was not touched.
  void require_touch(int position) const;
  /// Throws Interruption where the surface was felt less often than the arrangement requires.
  void require_visits(int position) const;
  bool has_required_visits() const;
  int required_visits() const noexcept;  ///< to each surface
  int visits_to(int position) const;
  void let_hand_stroke();
  void explore(int position);
  void explore_patches();
  void lift_and_take_back(std::size_t index);
  /// Reads on from the record that was read last. `records`: all of the attempt up to now.
  void read_visits(const std::vector<TickRecord>& records);
  /// States the error of a plug-in as the reason of the fault that it caused.
  void name_failed_plugin();
  void name_hanging_tick();
  void measure(const std::vector<TickRecord>& records);
  void store_answers();
  void judge();
  JudgedSurface judged_surface(std::size_t index) const;
  /// Flags the attempt because of a vibration, or makes it invalid (true).
  bool judge_buzz(Phrase& flags);
  /// Force, speed, contact time and strokes of each surface that was presented in these records.
  std::vector<ComplianceRow> compliance_in(std::span<const TickRecord> records) const;
  void take_surface_away();
  /// The question requires sight: it has pictures to choose from or to compare with.
  bool has_to_be_seen() const;
  double wanted_contact_s() const;
  std::string recording_path() const;

  SessionCourse& course_;
  AttemptOrder order_;
  const Trial& trial_;
  const Protocol::Block& block_;
  Exploration exploration_{};  ///< in the session's layout
  SurfacePatch patch_{};
  Wait waiting_{};
  Random random_{0};  ///< the stream of the attempt
  TrialSurfaces surfaces_;
  VisitReader visits_;
  AttemptInstability instability_{};
  std::size_t records_read_ = 0;  ///< by visits_
  std::int64_t lifted_ns_ = 0;    ///< the last contact before the surfaces were changed
  std::set<int> cut_short_{};     ///< positions of visits that ended before their exposure
  std::uint64_t intervals_ = 0;   ///< between surfaces so far
  std::vector<int> felt_{};       ///< the position of every visit, in the order of feeling
  /// The number of records of the attempt at each wish to feel again after the required visits.
  std::vector<std::size_t> records_before_revisit_{};
  bool explored_before_revisit_ = false;  ///< as instructed, at one of them, and not in all records
  std::vector<Answered> answered_{};
  std::optional<Interruption> interruption_{};
  std::optional<TickProgress> hanging_tick_{};  ///< one that the interruption left under way
  AttemptRow row_{};
};

}  // namespace asperity
