// Groups shards by their state in the queue, and shortens long lists of missing ones.

#include "app/cli/output/submission_output.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/output/terminal.h"
#include "app/cluster/submission_logs.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

std::string named_shards(const std::vector<int>& indices) {
  return (indices.size() == 1 ? "shard " : "shards ") + ranges_of(indices);
}

/// "running", "pending (Resources)"
std::string state_of_job(const QueuedJob& job) {
  std::string text = job.state;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::replace(text.begin(), text.end(), '_', ' ');
  return job.reason.empty() || job.reason == "None" ? text : text + " (" + job.reason + ')';
}

std::string end_of_log(const std::optional<LogEnd>& end) {
  if (!end) return "; there is no log";
  return "; " +
         (end->line.empty() ? "its log is empty" : "its log ends with \"" + end->line + '"') +
         " (" + end->file.string() + ')';
}

/// One line for each state of the tasks in the queue.
std::string queued_lines(const SubmissionState& state) {
  std::map<std::string, std::vector<int>> shards{};
  for (const ShardReport& shard : state.shards) {
    if (shard.state == ShardState::queued) {
      shards[state_of_job(*shard.job)].push_back(shard.index);
    }
  }
  std::string lines{};
  for (const auto& [words, indices] : shards) lines += words + ": " + named_shards(indices) + '\n';
  return lines;
}

/// One line for each missing shard of which there is a task or a log, at most `kMost`, and one line for those that were not
/// submitted yet.
std::string missing_lines(const Submission& submission, const SubmissionState& state) {
  constexpr std::size_t kMost = 5;
  std::vector<int> unsubmitted{};
  std::vector<int> further{};
  std::string lines{};
  std::size_t shown = 0;
  for (const ShardReport& shard : state.shards) {
    if (shard.state != ShardState::missing) continue;
    const std::optional<LogEnd> log = log_end_of_shard(submission, shard.index);
    if (!shard.job && !log) {
      unsubmitted.push_back(shard.index);
    } else if (shown == kMost) {
      further.push_back(shard.index);
    } else {
      lines += "missing: " + named_shards({shard.index}) + ", task " +
               (shard.job ? state_of_job(*shard.job) : "no longer in the queue") + end_of_log(log) +
               '\n';
      ++shown;
    }
  }
  if (!further.empty()) lines += "also missing: " + named_shards(further) + '\n';
  if (!unsubmitted.empty()) lines += "not submitted: " + named_shards(unsubmitted) + '\n';
  return lines;
}

std::string gather_lines(const Submission& submission, const SubmissionState& state) {
  std::string lines{};
  for (const QueuedJob& gather : state.gathers) {
    lines += "gather job " + gather.job + ": " + state_of_job(gather) + '\n';
  }
  if (!state.gathers.empty() || state.failed_gathers.empty()) return lines;
  const QueuedJob& last = state.failed_gathers.front();
  if (last.waits_for_ever()) {
    return "gather job " + last.job +
           " would wait for ever: a task on which it depends did not end successfully (" +
           last.reason + ")\n";
  }
  if (last.state == "CANCELLED") {
    return "gather job " + last.job + " was cancelled" +
           (last.reason == kDependencyNeverSatisfied
                ? " by Slurm: a task on which it depends did not end successfully\n"
                : " (" + last.reason + ")\n");
  }
  return "gather job " + last.job + ": " + state_of_job(last) +
         end_of_log(log_end_of_gather(submission)) + '\n';
}

nlohmann::ordered_json json_of_job(const QueuedJob& job) {
  return {{"job", job.job}, {"state", job.state}, {"reason", job.reason}};
}

}  // namespace

std::string state_text(const Submission& submission, const SubmissionState& state) {
  const std::string result = submission.result().string();
  if (state.is_complete) return result + ": complete\n";
  const std::size_t complete = state.indices_of(ShardState::complete).size();
  return result + ": " + std::to_string(complete) + " of " +
         counted(static_cast<std::size_t>(submission.shards), "shard") + " complete\n" +
         queued_lines(state) + missing_lines(submission, state) + gather_lines(submission, state);
}

std::string submitted_text(const NextJobs& next, const SubmittedJobs& submitted) {
  std::string lines{};
  for (const std::string& job : next.to_cancel) lines += "cancelled: gather job " + job + '\n';
  std::vector<std::string> jobs{};
  if (!submitted.array.empty()) {
    jobs.push_back("job array " + submitted.array + " (" + named_shards(next.tasks) + ')');
  }
  if (!submitted.gather.empty()) jobs.push_back("gather job " + submitted.gather);
  return jobs.empty() ? lines : lines + "submitted: " + listed(jobs) + '\n';
}

nlohmann::ordered_json state_json(const Submission& submission, const SubmissionState& state,
                                  const NextJobs& next, const SubmittedJobs& submitted) {
  nlohmann::ordered_json queued = nlohmann::ordered_json::array();
  for (const ShardReport& shard : state.shards) {
    if (shard.state != ShardState::queued) continue;
    nlohmann::ordered_json entry{{"shard", shard.index}};
    entry.update(json_of_job(*shard.job));
    queued.push_back(std::move(entry));
  }
  nlohmann::ordered_json gathers = nlohmann::ordered_json::array();
  for (const auto& jobs : {state.gathers, state.failed_gathers}) {
    for (const QueuedJob& job : jobs) gathers.push_back(json_of_job(job));
  }
  const auto number = [](const std::string& job) {
    return job.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(job);
  };
  return {{"format", "asperity.submit/1"},
          {"result", submission.result().string()},
          {"is_complete", state.is_complete},
          {"shards", submission.shards},
          {"complete", state.indices_of(ShardState::complete)},
          {"queued", std::move(queued)},
          {"missing", state.indices_of(ShardState::missing)},
          {"gathers", std::move(gathers)},
          {"cancelled", next.to_cancel},
          {"submitted",
           {{"shards", next.tasks},
            {"array", number(submitted.array)},
            {"gather", number(submitted.gather)}}}};
}

}  // namespace asperity
