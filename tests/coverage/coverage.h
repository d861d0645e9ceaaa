// Coverage of intervals and size of tests, by simulation.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/proportion.h"
#include "app/findings/outcome/found_numbers.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

/// What became of one interval or test in the tables of a setting.
struct CoverageCount {
  std::string part{};
  CoverageSetting setting{};
  std::string what{};  ///< "interval" or "test"
  std::string quantity{};
  std::string key{};
  double truth = 0.0;          ///< of an interval
  std::uint64_t tables = 0;    ///< drawn
  std::uint64_t given = 0;     ///< of them: with an interval, or with a p
  std::uint64_t below = 0;     ///< of those: the interval lies below the truth
  std::uint64_t above = 0;     ///< of those: the interval lies above the truth
  std::uint64_t rejected = 0;  ///< of those with a p: p ≤ .05
  double smallest_p = 1.0;
};

/// Nothing where the findings have none.
std::optional<ConfidenceInterval> interval_in(const FoundNumbers& found,
                                              const CheckedInterval& checked);

struct CoverageRun {
  std::uint64_t seed = 1;
  std::optional<std::size_t> tables{};  ///< of each setting, instead of the part's own number
  std::size_t jobs = 1;
};

/// Draws the tables of a setting and analyses each. Table i is drawn from a stream of its own, so
/// that the counts are the same for any number of jobs.
std::vector<CoverageCount> counts_in(const CoveragePart& part, const CoverageSetting& setting,
                                     const CoverageRun& run);

/// The columns of a file of counts, and a count as its row; tab-separated.
std::string coverage_header();
std::string row_of(const CoverageCount& count);
/// What the rows of a setting begin with: whether a file has it already.
std::string name_of(const CoveragePart& part, const CoverageSetting& setting);

/// Appends to the file what it lacks of the parts, one setting after the other, and so goes on where it was stopped.
/// `told` is called with the rows of each. Throws std::runtime_error for a file with other columns or a part cut off.
void append_counts(const std::string& file, const std::vector<CoveragePart>& parts,
                   const CoverageRun& run, const std::function<void(const std::string&)>& told);

}  // namespace asperity
