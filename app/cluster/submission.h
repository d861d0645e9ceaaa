// A divided computation that was submitted to a cluster: its command, its shards and its folder.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What the jobs request of Slurm. Empty: the default of the cluster.
struct SlurmRequest {
  std::string partition{};
  std::string time{};                  ///< of one task, as sbatch takes it: "02:00:00"
  std::string memory{};                ///< of one task, as sbatch takes it: "2G"
  int cpus = 1;                        ///< of one task, and the number of its threads
  std::vector<std::string> further{};  ///< options of sbatch, each one word: "--account=lab"
};

/// A command that is computed in shards, one task of a job array each, and joined by a job that depends on them.
///
/// A submission is its folder:
///
///     submission.json   the command, the folder in which it runs, the number of shards, the result, the name of the jobs
///     shards.sbatch     the batch script of the array
///     gather.sbatch     the batch script of the job that joins the shards
///     logs/             what the jobs printed
///     lock              empty; of the process that submits now (SubmissionTurn)
///
/// Nothing else is stored. Which shards are complete is determined from their files, and what is in the queue from squeue by the
/// name of the jobs, so that an interrupted `submit` can be repeated and no database of jobs is needed.
struct Submission {
  std::filesystem::path folder{};     ///< absolute
  std::filesystem::path directory{};  ///< absolute: that of the command's relative paths
  std::vector<std::string> command{};  ///< without the name of the program: {"sweep", "--model", …}
  int shards = 1;
  std::filesystem::path out{};  ///< the result, absolute or relative to `directory`
  std::string job_name{};  ///< of the array; unique, because it contains a digest of all the above

  /// Absolute.
  std::filesystem::path result() const { return directory / out; }
  std::filesystem::path shard(int index) const;
  std::string gather_name() const { return job_name + "-gather"; }
  std::filesystem::path array_script() const { return folder / "shards.sbatch"; }
  std::filesystem::path gather_script() const { return folder / "gather.sbatch"; }
  /// What the jobs print. `job`: the number of the array or of the gather job; "%A" and "%j" in a batch script.
  std::filesystem::path shard_log(const std::string& index, const std::string& job) const;
  std::filesystem::path gather_log(const std::string& job) const;
};

/// A new submission, with absolute paths and its name. `out`: the result; empty for the value of the command's option with the
/// ending of its declaration.
///
/// Errors: std::invalid_argument for a command that cannot be divided (whole_of), and for characters that a batch script cannot
/// contain: control characters and what is not UTF-8, and " % \ in the path of the folder.
Submission new_submission(const std::filesystem::path& folder,
                          const std::filesystem::path& directory, std::vector<std::string> command,
                          int shards, std::filesystem::path out = {});

/// Writes the folder; submission.json is last. `program`: the executable that the tasks run. Does nothing where the folder
/// holds the same files already.
///
/// Errors: std::invalid_argument as array_script_of (app/cluster/batch_scripts.h); std::runtime_error where the folder holds
/// another submission, or scripts that were edited or written with another request, and where the result exists already;
/// ResultsError.
void write_submission(const Submission& submission, const SlurmRequest& request,
                      const std::filesystem::path& program);

/// The submission of a folder; nothing where there is none. Errors: ResultsError for a file that cannot be read or is not one.
std::optional<Submission> submission_in(const std::filesystem::path& folder);

}  // namespace asperity
