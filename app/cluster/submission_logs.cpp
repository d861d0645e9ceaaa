// Takes the last line from the end of the newest log of a shard or of the gather job.

#include "app/cluster/submission_logs.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <ios>

#include "results_schema/files/folder_entries.h"

namespace asperity {

namespace {

/// Where the longest line that is of use ends.
constexpr std::streamoff kMostBytes = 4096;

std::string last_line_of(const std::filesystem::path& file) {
  std::ifstream log(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = log.tellg();
  log.seekg(std::max<std::streamoff>(0, size - kMostBytes));
  std::string last{};
  for (std::string line{}; std::getline(log, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

/// The log of the latest job among those of a pattern: the one with the greatest number in place of "*".
std::optional<LogEnd> latest_log(const std::filesystem::path& pattern) {
  const std::string name = pattern.filename().string();
  const std::size_t star = name.find('*');
  const std::string before = name.substr(0, star);
  const std::string after = name.substr(star + 1);
  std::string latest{};
  for (const auto& entry : entries_in(pattern.parent_path())) {
    const std::string there = entry.path().filename().string();
    if (there.size() <= before.size() + after.size() || !there.starts_with(before) ||
        !there.ends_with(after)) {
      continue;
    }
    const std::string job =
        there.substr(before.size(), there.size() - before.size() - after.size());
    const bool is_later = job.size() != latest.size() ? job.size() > latest.size() : job > latest;
    if (is_later) latest = job;
  }
  if (latest.empty()) return std::nullopt;
  const std::filesystem::path file = pattern.parent_path() / (before + latest + after);
  return LogEnd{.file = file, .line = last_line_of(file)};
}

}  // namespace

std::optional<LogEnd> log_end_of_shard(const Submission& submission, int index) {
  return latest_log(submission.shard_log(std::to_string(index), "*"));
}

std::optional<LogEnd> log_end_of_gather(const Submission& submission) {
  return latest_log(submission.gather_log("*"));
}

}  // namespace asperity
