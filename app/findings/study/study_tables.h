// Formats the tables of a study's analysis for display, by their names.

#pragma once

#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// A table for display (reading_table.h), its quantities with the prefix of their unit. In the table of tests a statistic is combined with its
/// degrees of freedom and its value in one cell, "t(19) = 12.25", an effect size with its interval
/// in another, "d = 2.74 [1.75, 3.71]".
Table reading_table(const NamedTable& table);

}  // namespace asperity
