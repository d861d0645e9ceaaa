// Makes the tables of further findings of an analysis, for reference.

#pragma once

#include <span>

#include "analysis/numbers/finding.h"
#include "app/report/text/report.h"
#include "app/report/text/report_tests.h"

namespace asperity {

/// Tests that are in no table of the analysis, one row each. Those of single participants and those
/// that repeat another in a different form are omitted. Without rows where there are none.
ReportTable further_tests_table(std::span<const ReportedTest> tests);

/// The text for a number in `further_numbers_table`; empty for those that it omits.
std::string words_of_number(const std::string& quantity);

/// Numbers that are in no table of the analysis, as text, counts as integers, each with its
/// interval. Without rows where there are none.
ReportTable further_numbers_table(std::span<const Finding> findings);

}  // namespace asperity
