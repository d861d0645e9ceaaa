// Keeps a submission going until its result exists.

#pragma once

#include <functional>

#include "app/cluster/slurm.h"
#include "app/cluster/submission.h"
#include "app/cluster/submission_state.h"
#include "app/cluster/submit_jobs.h"

namespace asperity {

/// What the caller does in a watch.
struct WatchActions {
  std::function<void(const SubmissionState&)> on_state{};  ///< at every look
  std::function<void(const NextJobs&, const SubmittedJobs&)> on_submitted{};
  /// Waits for the time of the next look. False ends the watch.
  std::function<bool()> wait{};
};

struct WatchEnd {
  enum class Why {
    complete,  ///< the result exists
    stopped,   ///< by `wait`
    failed     ///< the same job was submitted `kMostAttempts` times and did not succeed
  };
  Why why = Why::stopped;
  int shard = 0;  ///< whose task failed; 0: the gather job
};

/// How often one watch submits the task of a shard, or the gather job alone.
inline constexpr int kMostAttempts = 3;

/// Looks, and submits what is missing, until the result exists. Errors: those of Slurm and SubmissionTurn.
WatchEnd watch_submission(const Submission& submission, const Slurm& slurm,
                          const WatchActions& actions);

}  // namespace asperity
