// Declares the tables of the command bench.

#pragma once

#include <string>
#include <vector>

#include "app/timing/timed_scenes.h"
#include "app/timing/timing_machine.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// All columns, in SI units, with the machine in each row: what `--out` writes.
Table tick_table(const std::vector<TimedRow>& rows, const TimingMachine& machine);

/// The columns that fit a terminal, in microseconds and kilohertz with three significant digits.
Table short_tick_table(const std::vector<TimedRow>& rows);

/// Sentences under that table: cold caches, the sizes of the bodies, the reasons of rows without times or with too few ticks for
/// quantiles, what the forces are, the sources of quoted figures.
std::vector<std::string> tick_notes(const std::vector<TimedRow>& rows);

}  // namespace asperity
