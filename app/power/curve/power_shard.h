// One shard of a power analysis, and its file.

#pragma once

#include <functional>
#include <stop_token>

#include "app/power/curve/power_files.h"
#include "app/power/curve/power_order.h"
#include "app/power/curve/study_simulation.h"
#include "app/shards/divided_computation.h"

namespace asperity {

/// A power analysis as a computation that is divided into its runs, which cost the same. Its table is `studies.tsv`.
DividedComputation divided(const PowerOrder& order);

enum class PowerShard {
  simulated,
  stored_before,  ///< by an earlier command: nothing was simulated
  stopped,        ///< nothing was written
};

/// Simulates the runs of one shard and writes `shard_path(files.studies(), shard)` when all of them are simulated. With
/// Overwrite::allow a file of this name is replaced. Memory: the rows of the shard.
///
/// Errors: std::invalid_argument (`require_order`, `require_items`); those of `make_folder`, `is_stored`, `store` and
/// `simulate_studies`.
PowerShard simulate_power_shard(const PowerOrder& order, const Shard& shard,
                                const SimulateStudy& simulate, int jobs, const PowerFiles& files,
                                const std::stop_token& stop,
                                const std::function<void(double)>& progress);

}  // namespace asperity
