// Looks at a submission and submits what it lacks.

#pragma once

#include <string>
#include <vector>

#include "app/cluster/slurm.h"
#include "app/cluster/submission.h"
#include "app/cluster/submission_state.h"

namespace asperity {

/// The state now. Asks the queue first, then looks at the files (state_of). Errors: those of Slurm.
SubmissionState current_state(const Submission& submission, const Slurm& slurm);

/// The jobs that were submitted, by their numbers; empty where there is none.
struct SubmittedJobs {
  std::string array{};
  std::string gather{};
};

/// Cancels and submits. After an error it can be repeated with the state of then: what was submitted is in the queue under the
/// name of the submission. Errors: those of Slurm.
SubmittedJobs submit_jobs(const Submission& submission, const NextJobs& next, const Slurm& slurm);

}  // namespace asperity
