// Lists sessions whose program crashed, which are shown first to a user who returns to the study.

#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "results_schema/study.h"

namespace asperity {

struct InterruptedSession {
  SessionRow row{};
  std::string protocol_name{};
  std::string protocol_version{};
  /// The file of the study's `protocols/` with exactly the text with which the session began;
  /// without one it cannot be resumed.
  std::optional<std::filesystem::path> protocol_file{};
  int trials_done = 0;
  int trials = 0;
};

/// Sessions that crashed, or are open without a process that holds them; human participants' before
/// virtual participants', each in descending order of time. Excluded sessions are omitted: the
/// experimenter has already seen them.
///
/// Only reads. Ends early, with a partial result, when a stop is requested. Errors: ResultsError as
/// for Study.
std::vector<InterruptedSession> interrupted_sessions(const Study& study,
                                                     const std::stop_token& stop);

}  // namespace asperity
