// Stores one attempt with everything that its detail page shows.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

struct AttemptDetail {
  SessionRow session{};
  std::string protocol_name{};
  std::string protocol_version{};
  PlannedTrialRow planned{};
  AttemptRow attempt{};
  /// About this attempt or its whole session, in chronological order.
  std::vector<DecisionRow> decisions{};
  int ordinal = 0;  ///< among the attempts of the session, from 1
  int count = 0;    ///< the number of attempts of the session
  // By trial and attempt, in the same session; absent for the first and last.
  std::optional<std::int64_t> previous_id{};
  std::optional<std::int64_t> next_id{};

  /// By a decision about the attempt, regardless of decisions about its session.
  bool is_excluded_itself() const noexcept;
};

/// Does not read the recording. Errors: ResultsError, also when there is no such attempt.
AttemptDetail attempt_detail(const Study& study, std::int64_t attempt_id);

/// Reads the recording of an attempt. Errors: ResultsError as for read_recording, and when the file
/// is a valid recording but not the one that was stored.
Recording recording_of(const std::filesystem::path& study, const RecordingRow& row);

/// A recording as a table: one row per tick, the columns by their names in the file.
Table table_of(const Recording& recording);

}  // namespace asperity
