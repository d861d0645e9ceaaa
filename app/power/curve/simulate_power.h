// Simulates the studies of a power analysis on several threads, and keeps each in a table that can be resumed and extended.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/power/curve/power_order.h"
#include "app/power/curve/power_tally.h"
#include "app/power/simulated_run.h"
#include "results_schema/files/atomic_file.h"

namespace asperity {

/// One study of an effect (its place in PowerOrder::effects): a function of its arguments, called from several threads. It returns at
/// least one outcome.
using SimulateStudy = std::function<std::vector<SimulatedOutcome>(
    std::size_t effect, int participants, std::uint64_t seed, std::int64_t run)>;

/// The files of a power analysis in its folder.
inline constexpr const char* kStudiesFile = "studies.tsv";
/// How `studies.tsv` was made: `declaration_of`.
inline constexpr const char* kDeclarationFile = "studies.tsv.json";

struct PowerFiles {
  std::filesystem::path
      folder{};  ///< made where it is missing; the folder that it is in must exist
  Overwrite overwrite = Overwrite::refuse;  ///< of the studies of another order
};

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
/// runs: a thread waits where its study is far ahead of the last one that was written. After a stop request, current studies are
/// completed; `progress` receives fractions, from any thread, and may be empty.
///
/// Errors: std::invalid_argument (`require_order`), ResultsError (the folder, a file), std::runtime_error for a table of another order,
/// naming the differences, for a row that is not of this order, naming its line, for a study without outcomes, and for the error of a
/// study, naming the study. What was simulated before is kept.
SimulatedPower simulate_power(const PowerOrder& order, const SimulateStudy& simulate, int jobs,
                              const std::optional<PowerFiles>& files, const std::stop_token& stop,
                              const std::function<void(double)>& progress);

}  // namespace asperity
