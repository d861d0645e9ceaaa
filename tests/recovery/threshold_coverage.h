// How often the intervals of thresholds after adaptive placement contain the true threshold.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/procedures/procedure.h"

namespace asperity {

/// Observers as in recovery.h, whose thresholds are analysed as those of a study: `fit_discrimination` for the threshold at 75 %
/// correct, `procedure_interval` for its interval.
struct CoverageCell {
  std::string_view procedure{};  ///< in files and tables
  std::vector<ProcedureSettings> tracks{};
  double beta = 3.5;

  std::size_t trials() const;  ///< of all tracks
};
/// On the grid of recovery.h; tracks begin at 10^0.6, second tracks at 10^0.3.
std::vector<CoverageCell> coverage_cells();

struct IntervalCoverage {
  std::size_t observers = 0;
  std::size_t thresholds = 0;  ///< observers with a threshold
  std::size_t intervals = 0;   ///< of those: with an interval
  std::size_t below = 0;       ///< of those: the interval is below the true threshold
  std::size_t above = 0;       ///< of those: above it
  double ratio = 0.0;          ///< median of the upper over the lower end
  std::size_t without = 0;     ///< repetitions without a threshold, of all intervals
  std::size_t of_delta = 0;    ///< delta intervals of a fit without limits of the slope
  std::size_t delta_below = 0;
  std::size_t delta_above = 0;

  bool operator==(const IntervalCoverage&) const = default;
};

struct IntervalCoverageRun {
  std::size_t observers = 1000;
  std::size_t jobs = 1;  ///< the numbers do not depend on it
  std::uint64_t seed = 1;
};
IntervalCoverage interval_coverage(const CoverageCell& cell, const IntervalCoverageRun& run);

std::string interval_coverage_header();
std::string row_text(const CoverageCell& cell, const IntervalCoverage& coverage);

}  // namespace asperity
