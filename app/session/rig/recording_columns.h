// Converts tick records to the floats of a recording, and back.

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "renderers/servo/tick_record.h"
#include "results_schema/recording.h"

namespace asperity {

inline constexpr std::size_t kRecordingColumns = 32;

/// Name, unit and meaning of each column, in order.
const std::vector<RecordingColumn>& recording_columns();

std::array<float, kRecordingColumns> columns_of(const TickRecord& record) noexcept;
TickRecord record_of(std::int64_t time_ns,
                     std::span<const float, kRecordingColumns> values) noexcept;

/// The record as its recording will give it. All measures of an attempt are computed from these
/// values, so that live and later results are identical.
TickRecord as_recorded(const TickRecord& record) noexcept;

/// All records of a recording, which was read from `file`. Errors: ResultsError naming the file when
/// its columns are not those of this program.
std::vector<TickRecord> records_of(const Recording& recording,
                                   const std::filesystem::path& file = {});

}  // namespace asperity
