// Runs squeue, sbatch and scancel as child processes, and parses their output.

#include "app/cluster/slurm.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "app/processes/finished_command.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// The states in which a job has ended (squeue(1), JOB STATE CODES). Any other one is active, so that a state of a later
/// version of Slurm causes no second submission.
constexpr std::array<std::string_view, 10> kEndedStates{
    "BOOT_FAIL", "CANCELLED", "COMPLETED",     "DEADLINE", "FAILED",
    "NODE_FAIL", "PREEMPTED", "OUT_OF_MEMORY", "REVOKED",  "TIMEOUT"};

std::optional<int> index_in(const std::string& text) {
  int index = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, index);
  if (error != std::errc{} || read != end) return std::nullopt;  // "N/A": not a task of an array
  return index;
}

std::filesystem::path command_in(const std::string& search_path, const std::string& name,
                                 const std::string& otherwise) {
  if (auto file = program_in(search_path, name)) return *std::move(file);
  throw std::runtime_error(
      "the command " + name +
      " of Slurm is not in a folder of PATH; use a computer from which jobs can "
      "be submitted, or load Slurm first (such as: module load slurm). " +
      otherwise);
}

}  // namespace

bool QueuedJob::is_active() const noexcept {
  return std::find(kEndedStates.begin(), kEndedStates.end(), state) == kEndedStates.end();
}

std::vector<QueuedJob> queued_jobs_in(std::string_view text) {
  std::vector<QueuedJob> jobs{};
  for (const std::string& line : parts_of(std::string(text), '\n')) {
    if (line.empty()) continue;
    const std::vector<std::string> fields = parts_of(line, '|');
    constexpr std::size_t kFields = 5;
    if (fields.size() < kFields) {
      throw std::runtime_error("squeue wrote \"" + line + "\" where " + kQueueFormat +
                               " was requested; check that the command squeue is that of Slurm");
    }
    jobs.push_back({.name = fields[0],
                    .job = fields[1],
                    .task = index_in(fields[2]),
                    .state = fields[3],
                    .reason = fields[4]});
  }
  return jobs;
}

Slurm::Slurm(const std::string& search_path, const std::string& otherwise)
    : sbatch_(command_in(search_path, "sbatch", otherwise)),
      squeue_(command_in(search_path, "squeue", otherwise)),
      scancel_(command_in(search_path, "scancel", otherwise)) {}

std::vector<QueuedJob> Slurm::jobs_named(const std::vector<std::string>& names) const {
  std::string list{};
  for (const std::string& name : names) list += (list.empty() ? "" : ",") + name;
  return queued_jobs_in(output_of(
      {squeue_,
       {"--me", "--noheader", "--array", "--states=all", "--name=" + list,
        std::string("--format=") + kQueueFormat}},
      "nothing was submitted, because the state of the jobs is unknown; repeat the command when "
      "squeue works"));
}

std::string Slurm::submit(const std::filesystem::path& script,
                          std::vector<std::string> options) const {
  options.insert(options.begin(), "--parsable");
  options.push_back(script.string());
  const Command command{sbatch_, std::move(options)};
  const std::string output = output_of(
      command, "correct the options of sbatch in " + script.string() + ", and repeat the command");
  // "JOB" or "JOB;CLUSTER"
  const std::string job = output.substr(0, output.find_first_of(";\n"));
  if (index_in(job)) return job;
  throw std::runtime_error("the command \"" + text_of(command) + "\" wrote \"" + output +
                           "\" in place of the number of a job; check that the command sbatch is "
                           "that of Slurm, then repeat the command");
}

void Slurm::cancel(const std::string& job) const {
  output_of({scancel_, {job}}, "cancel the job " + job + ", then repeat the command");
}

}  // namespace asperity
