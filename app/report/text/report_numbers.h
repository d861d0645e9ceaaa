// What an analysis has found besides its answers and tables, to look up.

#pragma once

#include <span>

#include "analysis/finding.h"
#include "app/report/text/report.h"
#include "app/report/text/report_tests.h"

namespace asperity {

/// Tests that no table of the analysis has, a row each. Those of single participants and those that
/// only repeat another in a different form are left out. Without rows where there are none.
ReportTable further_tests_table(std::span<const ReportedTest> tests);

/// What a number is called in `further_numbers_table`; empty for those that it leaves out.
std::string words_of_number(const std::string& quantity);

/// Numbers that no table of the analysis has, in words, counts as counts, each with its interval.
/// Without rows where there are none.
ReportTable further_numbers_table(std::span<const Finding> findings);

}  // namespace asperity
