// Prints the results of a sweep.

#pragma once

#include "app/sweep/sweep.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The results, a row per level.
Table summary_table(const Sweep& sweep, SweepMeasure measure);

/// Prints that the model cannot depend on the varied quantity, if this is so.
void say_without_effect(const Sweep& sweep);

/// Prints the number of rows that are left out because the tool lost contact, and what keeps it, if there are any.
void say_lost_contact(const Sweep& sweep);

/// Prints a sentence for each reason for which a column of the summary has no number.
void say_absent_numbers(const Sweep& sweep, SweepMeasure measure);

}  // namespace asperity
