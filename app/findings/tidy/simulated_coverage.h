// States the simulated coverage of an interval in the method of its number.

#pragma once

#include <string>

namespace asperity {

/// The lowest and the highest coverage of a 95 % interval over the settings of docs/data/coverage.tsv in which one table in
/// twenty or more has it, rounded outwards to whole per cent.
struct CoverageSpan {
  int lowest_percent = 0;
  int highest_percent = 0;
};

inline std::string text_of(const CoverageSpan& coverage) {
  return std::to_string(coverage.lowest_percent) + " to " +
         std::to_string(coverage.highest_percent) + " %";
}

/// "; in simulations the coverage of the 95 % interval was 88 to 95 %"
inline std::string simulated_coverage(const CoverageSpan& coverage) {
  return "; in simulations the coverage of the 95 % interval was " + text_of(coverage);
}

/// Of an interval that treats the responses of participants as independent: of participants who are alike, and of those who
/// differ.
inline std::string simulated_coverage(const CoverageSpan& alike, const CoverageSpan& different) {
  return simulated_coverage(alike) + " where participants are alike, and " + text_of(different) +
         " where they differ";
}

}  // namespace asperity
