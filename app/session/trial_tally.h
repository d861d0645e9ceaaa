// Records which trials of a plan are done.

#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/plan/plan.h"
#include "results_schema/rows.h"

namespace asperity {

/// Whether the trial had correct responses, and all responses were correct.
bool is_right(const AttemptRow& attempt);
/// Whether the attempt failed for a reason other than the participant's exploration: the machine
/// was too slow, or a surface could not be touched.
bool failed_technically(const AttemptRow& attempt);
/// Whether the attempt is invalid because a force vibrated.
bool has_excessive_buzz(const AttemptRow& attempt);

/// The attempts of a session, those of earlier stretches included, and their consequences for the
/// plan.
///
/// A trial is done when an attempt at it is valid, or was skipped and not invalidated since.
/// Refreshers are numbered among the attempts and change nothing else. A
/// block that is practised to a criterion is over once the criterion is met or can no longer be
/// met.
class TrialTally final {
 public:
  /// Both must outlive the tally.
  TrialTally(const Protocol& protocol, const Plan& plan) : protocol_(protocol), plan_(plan) {}

  void add(AttemptRow attempt) { attempts_.push_back(std::move(attempt)); }
  const std::vector<AttemptRow>& attempts() const noexcept { return attempts_; }

  /// The latest attempt that completed its trial; null when there is none.
  const AttemptRow* last_done() const;
  /// The attempt no longer completes its trial; `reason` states why it is invalid.
  void set_aside(int trial, int attempt, const StoredWords& reason);
  /// An attempt that was invalidated, and stored so, in an earlier stretch of the session.
  void remember_set_aside(int trial, int attempt) { set_aside_.insert({trial, attempt}); }
  /// Trial and attempt.
  const std::set<std::pair<int, int>>& those_set_aside() const noexcept { return set_aside_; }

  bool is_done(const Trial& trial) const;
  /// The state of the criterion of the trial's block; `go_on` where it has no criterion.
  BlockState criterion_of(const Trial& trial) const;
  /// Whether the trial's block needs no more trials.
  bool is_over(const Trial& trial) const { return criterion_of(trial) != BlockState::go_on; }
  int attempts_at(int trial) const;
  /// The next trial when nothing else is requested; 0 when none is left. The walk over the plan is
  /// at `step`, in `block` (0: between blocks). `tried` was attempted just now (0: none): it is
  /// asked again at once (`again`), or not before the others of its block.
  enum class Again { at_once, after_others };
  int coming(std::size_t step, int block, int tried, Again again) const;
  int explored_wrongly(int trial) const;
  /// Attempts at this trial that are invalid because a force vibrated (Reason::buzz_too_strong).
  int repeated_for_buzz(int trial) const;
  /// The last number given to the stimulus of this trial, in any trial of the session.
  std::optional<double> earlier_estimate(const Trial& trial) const;

 private:
  bool does_its_trial(const AttemptRow& attempt) const;
  static bool is_refresher(const AttemptRow& attempt) {
    return attempt.purpose == AttemptPurpose::refresher;
  }
  bool is_open(const Trial& trial) const { return !is_done(trial) && !is_over(trial); }

  const Protocol& protocol_;
  const Plan& plan_;
  std::vector<AttemptRow> attempts_{};
  std::set<std::pair<int, int>> set_aside_{};
};

}  // namespace asperity
