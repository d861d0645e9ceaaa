// One shard of a sweep, and its file.

#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>

#include "app/shards/table_shard.h"
#include "app/sweep/sweep.h"

namespace asperity {

/// The sweep as a computation that is divided.
DividedComputation divided(const SweepOrder& order);

/// The file of a shard whose rows are complete.
TableShard table_shard(const Sweep& sweep, const Shard& shard);

/// Computes the rows of one shard and writes `shard_path(file.out, shard)` when all of them are computed. Where this file
/// exists, nothing is computed; with Overwrite::allow it is replaced. Returns the rows, none where the file existed; after a
/// stop request `is_complete` is false, and nothing is written.
///
/// Errors: as `sweep_of_shard`, `is_stored` and `store`; std::invalid_argument for a folder that is missing.
Sweep sweep_into_shard(const SweepOrder& order, const Shard& shard, const SweepFile& file,
                       const std::stop_token& stop, const std::function<void(double)>& progress);

}  // namespace asperity
