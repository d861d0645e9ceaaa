// The commands of Slurm: the queue, the submission and the cancellation of jobs.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The reason of a job that depends on one that did not end successfully.
inline constexpr std::string_view kDependencyNeverSatisfied = "DependencyNeverSatisfied";

/// A job, or one task of a job array, as squeue lists it.
struct QueuedJob {
  std::string name{};
  std::string job{};          ///< its number; of a task, that of the array
  std::optional<int> task{};  ///< the index in the array
  std::string state{};        ///< "PENDING", "RUNNING", "OUT_OF_MEMORY", …
  std::string
      reason{};  ///< why it is pending or ended: "Resources", "Dependency", …; "None" where there is none

  /// Whether Slurm has still to run it or is running it. Slurm lists ended jobs for some minutes (MinJobAge).
  bool is_active() const noexcept;
  bool is_pending() const noexcept { return state == "PENDING"; }
  bool waits_for_ever() const noexcept {
    return is_pending() && reason == kDependencyNeverSatisfied;
  }

  bool operator==(const QueuedJob&) const = default;
};

/// Reads the lines of squeue in the format `kQueueFormat`. Errors: std::runtime_error quoting a line of another form.
std::vector<QueuedJob> queued_jobs_in(std::string_view text);
inline constexpr const char* kQueueFormat = "%j|%F|%K|%T|%r";

/// sbatch, squeue and scancel, run as processes without a shell. Accounting (sacct) is not needed.
///
/// Errors of its functions: std::runtime_error naming the command, its exit status, the first line of its standard error and the
/// remedy.
class Slurm final {
 public:
  /// Finds the commands in the folders of `search_path`, as PATH has them. Errors: std::runtime_error naming the command that
  /// is missing; `otherwise` completes the sentence.
  Slurm(const std::string& search_path, const std::string& otherwise);

  /// The user's jobs with these names, every task of an array by itself, those that ended recently included.
  std::vector<QueuedJob> jobs_named(const std::vector<std::string>& names) const;

  /// Submits a batch script with further options and returns the number of the job.
  std::string submit(const std::filesystem::path& script, std::vector<std::string> options) const;

  void cancel(const std::string& job) const;

 private:
  std::filesystem::path sbatch_{};
  std::filesystem::path squeue_{};
  std::filesystem::path scancel_{};
};

}  // namespace asperity
