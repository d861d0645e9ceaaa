// The state of a submission, from its files and the queue, and what has to be submitted next.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cluster/slurm.h"
#include "app/cluster/submission.h"

namespace asperity {

/// Which files of a submission exist.
struct SubmissionFiles {
  std::vector<bool> shards{};  ///< of shard k at k − 1
  bool result = false;
};
SubmissionFiles files_of(const Submission& submission);

enum class ShardState {
  complete,  ///< its file or study exists, whatever the queue contains
  queued,    ///< a task that Slurm has still to run or is running
  missing    ///< neither
};

struct ShardReport {
  int index = 1;
  ShardState state = ShardState::missing;
  /// The task in the queue; of a missing shard its last task, as long as Slurm lists it.
  std::optional<QueuedJob> job{};
};

struct SubmissionState {
  bool is_complete = false;  ///< the result exists
  std::vector<ShardReport> shards{};
  /// The gather jobs that are active and do not wait for ever; Slurm runs one, then the result exists.
  std::vector<QueuedJob> gathers{};
  /// The gather jobs that ended or wait for ever, the latest first.
  std::vector<QueuedJob> failed_gathers{};

  std::vector<int> indices_of(ShardState state) const;
  /// Whether nothing of it was ever submitted, as far as files and queue show.
  bool is_untouched() const;
};

/// `jobs`: those named job_name and gather_name. They are to be listed before the files: a task renames its shard before it
/// ends, so that one that is not listed any more and has no shard will have none.
SubmissionState state_of(const Submission& submission, const std::vector<QueuedJob>& jobs,
                         const SubmissionFiles& files);

/// What completes a submission.
struct NextJobs {
  std::vector<int> tasks{};  ///< of a new array
  bool gather = false;       ///< a new gather job
  std::vector<std::string>
      to_cancel{};  ///< gather jobs that would wait for ever, or without the new tasks
  std::vector<std::string> arrays{};  ///< with tasks in the queue, for which a new gather job waits

  bool is_empty() const noexcept { return tasks.empty() && !gather; }
};

/// Missing shards are submitted in a new array, with a new gather job: one that depends on the array of a task that ended
/// without its shard will not run. A gather job alone is submitted where there is none. Nothing once the result exists.
NextJobs next_jobs(const SubmissionState& state);

/// The options of sbatch that let a gather job wait: for the success of `new_array` (empty where there is none), and for the end
/// of the tasks of older ones, of which some may have failed and been submitted again.
std::vector<std::string> waiting_options(const NextJobs& next, const std::string& new_array);

/// Indices as sbatch --array takes them and as people read them: "3,5-7".
std::string ranges_of(const std::vector<int>& indices);

}  // namespace asperity
