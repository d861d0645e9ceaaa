// Reads the column `time_s` of a table of response times.

#pragma once

#include <optional>
#include <vector>

#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// Natural logarithms of the seconds, by row; nothing where there is no time. Rejects a time that
/// is not above 0.
std::vector<std::optional<double>> logarithms_of_times(const TidyTable& table);

}  // namespace asperity
