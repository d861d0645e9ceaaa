// Estimates the progress and the remaining time of a session, for the experimenter.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/session/session_course.h"
#include "app/session/trial_tally.h"
#include "protocols/plan/course.h"

namespace asperity {

/// Reports completed and remaining trials to the monitor; does nothing without one.
///
/// Expected time: the planned time of the remaining trials × the pace of this participant, plus the
/// planned time of the other steps. The pace is the time taken by the session's attempts, earlier
/// stretches included, divided by the planned time of the trials that they completed. It is
/// undefined before the third trial. While the plan can grow, the expected number of trials is an
/// estimate (SessionRow::expected_trials), and a trial that is still unknown takes as long as the last
/// known one.
class SessionProgress final {
 public:
  /// All must outlive it. Shows the attempts that are already in the tally.
  SessionProgress(SessionCourse& course, const Course& trials, const TrialTally& tally,
                  std::int64_t began_ns);

  /// The plan has further trials and steps.
  void extend();
  /// Adds an attempt that is on disk and in the tally. Its trial is over, and `coming` is the next
  /// one (0: none); `step` is the current step of the plan.
  void add(const AttemptRow& attempt, std::size_t step, int coming);
  /// Invalidates an attempt in the tally.
  void set_aside(const AttemptRow& attempt);
  void show(std::size_t step, int coming);

 private:
  AttemptSummary summary_of(const AttemptRow& attempt) const;
  std::optional<double> pace() const;
  void publish(std::size_t step, int coming, std::optional<AttemptSummary> added);

  SessionCourse& course_;
  /// The expected number of trials that are not in the plan.
  int unknown_trials() const;

  const Course& trials_;
  const Plan& plan_;
  const TrialTally& tally_;
  std::vector<double> planned_s_{};  ///< each step's cost; empty without a monitor
  /// Of each trial of the plan, by its index; empty without a monitor.
  std::vector<double> trial_s_{};
};

}  // namespace asperity
