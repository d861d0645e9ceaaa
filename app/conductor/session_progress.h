// How far a session is and how long it will take, for whoever watches it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/conductor/session_course.h"
#include "app/conductor/trial_tally.h"
#include "protocols/plan.h"

namespace asperity {

/// Tells the monitor what was done and what is left; does nothing without one.
///
/// Expected time: the plan's guess for the steps that are left, times the pace of this person, which is
/// how long attempts took over what was planned for the trials that they did. A minute of the guess
/// counts as experience, so that the first trial decides nothing.
class SessionProgress final {
 public:
  /// All must outlive it. Shows the attempts that the tally has already.
  SessionProgress(SessionCourse& course, const Plan& plan, const TrialTally& tally,
                  std::int64_t began_ns);

  /// An attempt that is on disk and in the tally. Its trial is over, and `coming` the one that comes
  /// (0: none); `step` of the plan is under way.
  void add(const AttemptRow& attempt, std::size_t step, int coming);
  /// An attempt in the tally was set aside.
  void set_aside(const AttemptRow& attempt);
  void show(std::size_t step, int coming);

 private:
  AttemptSummary summary_of(const AttemptRow& attempt);
  void publish(std::size_t step, int coming, std::optional<AttemptSummary> added);

  SessionCourse& course_;
  const Plan& plan_;
  const TrialTally& tally_;
  std::vector<double> planned_s_{};  ///< each step's cost; empty without a monitor
  double planned_so_far_s_ = 0.0;    ///< of the trials that are done
  double spent_so_far_s_ = 0.0;      ///< by all attempts
};

}  // namespace asperity
