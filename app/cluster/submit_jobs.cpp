// Submits an array job for the missing shards and a gather job that waits for it.

#include "app/cluster/submit_jobs.h"

namespace asperity {

SubmissionState current_state(const Submission& submission, const Slurm& slurm) {
  const std::vector<QueuedJob> jobs =
      slurm.jobs_named({submission.job_name, submission.gather_name()});
  return state_of(submission, jobs, files_of(submission));
}

SubmittedJobs submit_jobs(const Submission& submission, const NextJobs& next, const Slurm& slurm) {
  SubmittedJobs submitted{};
  for (const std::string& job : next.to_cancel) slurm.cancel(job);
  if (!next.tasks.empty()) {
    submitted.array = slurm.submit(submission.array_script(), {"--array=" + ranges_of(next.tasks)});
  }
  if (next.gather) {
    submitted.gather =
        slurm.submit(submission.gather_script(), waiting_options(next, submitted.array));
  }
  return submitted;
}

}  // namespace asperity
