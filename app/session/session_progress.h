// How far a session is and how long it will take, for the experimenter.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/session/session_course.h"
#include "app/session/trial_tally.h"
#include "protocols/plan/plan.h"

namespace asperity {

/// Reports to the monitor what was done and what is left; does nothing without one.
///
/// Expected time: the planned time of the trials that are left × the pace of this participant, and the
/// planned time of the other steps. The pace is how long the session's attempts took, earlier stretches
/// included, over what was planned for the trials that they did. There is none before the third trial.
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
  AttemptSummary summary_of(const AttemptRow& attempt) const;
  std::optional<double> pace() const;
  void publish(std::size_t step, int coming, std::optional<AttemptSummary> added);

  SessionCourse& course_;
  const Plan& plan_;
  const TrialTally& tally_;
  std::vector<double> planned_s_{};  ///< each step's cost; empty without a monitor
  std::vector<double> trial_s_{};    ///< likewise of each trial of the plan, by its index
};

}  // namespace asperity
