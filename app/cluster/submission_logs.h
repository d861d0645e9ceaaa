// What the jobs of a submission printed.

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cluster/submission.h"

namespace asperity {

/// The last line of a log.
struct LogEnd {
  std::filesystem::path file{};
  std::string line{};  ///< without blank lines after it; empty where the log is empty
};

/// Of the latest task of a shard, or of the latest gather job; nothing where there is no log yet. Errors: ResultsError.
std::optional<LogEnd> log_end_of_shard(const Submission& submission, int index);
std::optional<LogEnd> log_end_of_gather(const Submission& submission);

}  // namespace asperity
