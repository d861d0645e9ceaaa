// One attempt with everything that a person looks at afterwards.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "results_schema/table.h"

namespace asperity {

struct AttemptDetail {
  SessionRow session{};
  std::string protocol_name{};
  std::string protocol_version{};
  PlannedTrialRow planned{};
  AttemptRow attempt{};
  /// About this attempt or its whole session, in the order of deciding.
  std::vector<DecisionRow> decisions{};
  int ordinal = 0;  ///< among the attempts of the session, from 1
  int count = 0;    ///< of them
  // By trial and attempt, in the same session; absent at its ends.
  std::optional<std::int64_t> previous_id{};
  std::optional<std::int64_t> next_id{};

  /// By a decision about itself, whatever was decided about its session.
  bool is_excluded_itself() const noexcept;
};

/// Reads no recording. Errors: ResultsError, also when there is no such attempt.
AttemptDetail attempt_detail(const Study& study, std::int64_t attempt_id);

/// The recording that belongs to an attempt. Errors: ResultsError as read_recording's, and when the
/// file is a sound recording but not the one that was stored.
Recording recording_of(const std::filesystem::path& study, const RecordingRow& row);

/// A recording as it stands in its file: one row per tick, the columns by their names.
Table table_of(const Recording& recording);

}  // namespace asperity
