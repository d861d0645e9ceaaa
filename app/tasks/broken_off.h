// Sessions whose program crashed, which a user who returns to the study is shown first.

#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "results_schema/study.h"

namespace asperity {

struct BrokenOffSession {
  SessionRow row{};
  std::string protocol_name{};
  std::string protocol_version{};
  /// The file of the study's `protocols/` with the very text that the session began with; without
  /// one it cannot go on.
  std::optional<std::filesystem::path> protocol_file{};
  int trials_done = 0;
  int trials = 0;
};

/// Sessions that crashed, or are open without a process that holds them; people's before virtual participants',
/// each the latest first. Excluded sessions are left out: the experimenter has seen them.
///
/// Reads, and writes nothing. Ends early, with what it has, when it is asked to stop. Errors:
/// ResultsError as Study's.
std::vector<BrokenOffSession> broken_off_sessions(const Study& study, const std::stop_token& stop);

}  // namespace asperity
