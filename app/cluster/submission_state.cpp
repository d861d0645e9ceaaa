// Combines existing files with the active or latest task of each shard, and lists the shards to submit.

#include "app/cluster/submission_state.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>

namespace asperity {

namespace {

/// Numbers of jobs grow; they are compared as numbers without being converted.
bool is_later(const QueuedJob& a, const QueuedJob& b) {
  return a.job.size() != b.job.size() ? a.job.size() > b.job.size() : a.job > b.job;
}

/// The task of a shard: an active one rather than one that ended, a later one rather than an earlier one.
std::optional<QueuedJob> task_of(const std::vector<QueuedJob>& tasks, int index) {
  std::optional<QueuedJob> found{};
  for (const QueuedJob& task : tasks) {
    if (task.task != index) continue;
    const bool is_better =
        !found ||
        (task.is_active() == found->is_active() ? is_later(task, *found) : task.is_active());
    if (is_better) found = task;
  }
  return found;
}

}  // namespace

SubmissionFiles files_of(const Submission& submission) {
  SubmissionFiles files{};
  for (int index = 1; index <= submission.shards; ++index) {
    files.shards.push_back(std::filesystem::exists(submission.shard(index)));
  }
  files.result = std::filesystem::exists(submission.result());
  return files;
}

std::vector<int> SubmissionState::indices_of(ShardState state) const {
  std::vector<int> indices{};
  for (const ShardReport& shard : shards) {
    if (shard.state == state) indices.push_back(shard.index);
  }
  return indices;
}

bool SubmissionState::is_untouched() const {
  return !is_complete && gathers.empty() && failed_gathers.empty() &&
         std::all_of(shards.begin(), shards.end(), [](const ShardReport& shard) {
           return shard.state == ShardState::missing && !shard.job;
         });
}

SubmissionState state_of(const Submission& submission, const std::vector<QueuedJob>& jobs,
                         const SubmissionFiles& files) {
  SubmissionState state{.is_complete = files.result};
  std::vector<QueuedJob> tasks{};
  for (const QueuedJob& job : jobs) {
    if (job.name == submission.job_name && job.task) tasks.push_back(job);
    if (job.name != submission.gather_name()) continue;
    const bool can_run = job.is_active() && !job.waits_for_ever();
    (can_run ? state.gathers : state.failed_gathers).push_back(job);
  }
  std::sort(state.failed_gathers.begin(), state.failed_gathers.end(), is_later);
  for (int index = 1; index <= submission.shards; ++index) {
    ShardReport shard{.index = index, .job = task_of(tasks, index)};
    if (files.shards.at(static_cast<std::size_t>(index) - 1)) {
      shard.state = ShardState::complete;
    } else if (shard.job && shard.job->is_active()) {
      shard.state = ShardState::queued;
    }
    state.shards.push_back(std::move(shard));
  }
  return state;
}

NextJobs next_jobs(const SubmissionState& state) {
  NextJobs next{};
  if (state.is_complete) return next;
  next.tasks = state.indices_of(ShardState::missing);
  next.gather = !next.tasks.empty() || state.gathers.empty();
  if (!next.gather) return next;
  for (const std::vector<QueuedJob>& gathers : {state.gathers, state.failed_gathers}) {
    for (const QueuedJob& gather : gathers) {
      if (gather.is_pending()) next.to_cancel.push_back(gather.job);
    }
  }
  std::set<std::string> arrays{};
  for (const ShardReport& shard : state.shards) {
    if (shard.state == ShardState::queued) arrays.insert(shard.job->job);
  }
  next.arrays.assign(arrays.begin(), arrays.end());
  return next;
}

std::vector<std::string> waiting_options(const NextJobs& next, const std::string& new_array) {
  std::string conditions{};
  if (!new_array.empty()) conditions = "afterok:" + new_array;
  for (const std::string& array : next.arrays) {
    conditions += (conditions.empty() ? "afterany:" : ",afterany:") + array;
  }
  if (conditions.empty()) return {};
  return {"--dependency=" + conditions, "--kill-on-invalid-dep=yes"};
}

std::string ranges_of(const std::vector<int>& indices) {
  std::string text{};
  for (std::size_t at = 0; at < indices.size();) {
    std::size_t last = at;
    while (last + 1 < indices.size() && indices[last + 1] == indices[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(indices[at]);
    if (last > at) text += '-' + std::to_string(indices[last]);
    at = last + 1;
  }
  return text;
}

}  // namespace asperity
