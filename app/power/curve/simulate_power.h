// Simulates the studies of a power analysis, and keeps each in a table that can be resumed and extended.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/power/curve/power_files.h"
#include "app/power/curve/power_order.h"
#include "app/power/curve/power_tally.h"
#include "app/power/curve/study_simulation.h"

namespace asperity {

/// The studies so far.
struct SimulatedPower {
  std::vector<PowerCurve> curves{};
  std::int64_t runs = 0;   ///< complete ones
  std::int64_t there = 0;  ///< studies that the table had before
  bool is_complete = false;
};

/// Simulates the studies that are missing in the table, all of the order without `files`. The table is written in the order of
/// `place_of`, about once a second and at the end. A table that was stopped within a study ends with the study before it when it is
/// resumed; its last study is always simulated again. A table with more runs than the order has is used as a whole: its last run is
/// completed.
///
/// Bytes and curves do not depend on `jobs`, on stops, or on whether runs were added later. Memory does not depend on the number of
/// runs. Stops and `progress` are those of `simulate_studies`.
///
/// Errors: std::invalid_argument (`require_order`), ResultsError (the folder, a file), std::runtime_error for a table of another order,
/// naming the differences, for a row that is not of this order, naming its line; those of `simulate_studies`. What was simulated
/// before is kept.
SimulatedPower simulate_power(const PowerOrder& order, const SimulateStudy& simulate, int jobs,
                              const std::optional<PowerFiles>& files, const std::stop_token& stop,
                              const std::function<void(double)>& progress);

}  // namespace asperity
