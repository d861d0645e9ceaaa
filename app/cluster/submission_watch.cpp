// Submits what is missing until the result exists or a shard has failed too often.

#include "app/cluster/submission_watch.h"

#include <map>
#include <optional>
#include <vector>

#include "app/cluster/submission_turn.h"

namespace asperity {

namespace {

/// What `next` submits, by shard; 0 is the gather job where it is submitted alone.
std::vector<int> attempted(const NextJobs& next) {
  if (next.tasks.empty() && next.gather) return {0};
  return next.tasks;
}

}  // namespace

WatchEnd watch_submission(const Submission& submission, const Slurm& slurm,
                          const WatchActions& actions) {
  std::map<int, int> attempts{};
  do {
    const SubmissionTurn turn(submission);
    const SubmissionState state = current_state(submission, slurm);
    actions.on_state(state);
    if (state.is_complete) return {.why = WatchEnd::Why::complete};
    const NextJobs next = next_jobs(state);
    for (const int shard : attempted(next)) {
      if (++attempts[shard] > kMostAttempts) return {.why = WatchEnd::Why::failed, .shard = shard};
    }
    if (!next.is_empty()) actions.on_submitted(next, submit_jobs(submission, next, slurm));
  } while (actions.wait());
  return {.why = WatchEnd::Why::stopped};
}

}  // namespace asperity
