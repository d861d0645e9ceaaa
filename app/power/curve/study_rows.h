// The rows of simulated studies in a table: written, and read again.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/power/curve/power_order.h"
#include "app/power/simulated_run.h"

namespace asperity {

/// The first line, without its end: run, effect, participants, family, test, method, p, corrected_p, estimate, lower, upper, status.
std::string study_columns();

/// The rows of one study in the order of its outcomes, as `tsv_of` writes cells; `n/a` for a missing number.
std::string rows_of(const PowerOrder& order, const StudyPlace& place,
                    std::span<const SimulatedOutcome> outcomes);

/// One row.
struct StudyRow {
  std::int64_t run = 0;
  std::string effect{};
  int participants = 0;
  SimulatedOutcome outcome{};

  bool is_of(const PowerOrder& order, const StudyPlace& place) const;
};
/// Reads a line that `rows_of` wrote, without its end; nothing for another one.
std::optional<StudyRow> study_row_in(std::string_view line);

}  // namespace asperity
