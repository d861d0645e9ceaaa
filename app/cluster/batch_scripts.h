// The batch scripts of a submission, as text, and the same computation without a batch system.

#pragma once

#include <filesystem>
#include <string>

#include "app/cluster/submission.h"

namespace asperity {

/// The script of the job array, which runs the command with `--shard "$SLURM_ARRAY_TASK_ID/N"`.
///
/// Errors: std::invalid_argument for a value of the request that is not one word of printable characters, and for a further
/// option that does not begin with "--".
std::string array_script_of(const Submission& submission, const SlurmRequest& request,
                            const std::filesystem::path& program);

/// The script of the job that joins all shards. Errors: as array_script_of.
std::string gather_script_of(const Submission& submission, const SlurmRequest& request,
                             const std::filesystem::path& program);

/// A line for a shell that computes all shards with GNU parallel, then joins them. It belongs in the directory of the submission.
std::string parallel_line_of(const Submission& submission, const std::filesystem::path& program);

}  // namespace asperity
