// Maps the studies of an order to the items of a divided computation.

#include "app/power/curve/power_shard.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>

#include "app/power/curve/study_rows.h"
#include "app/shards/table_shard.h"
#include "app/study_files/program.h"

namespace asperity {

DividedComputation divided(const PowerOrder& order) {
  return {.command = "power",
          .declaration = declaration_of(order),
          .results = static_cast<std::size_t>(order.runs),
          .program = numerical_identity()};
}

PowerShard simulate_power_shard(const PowerOrder& order, const Shard& shard,
                                const SimulateStudy& simulate, int jobs, const PowerFiles& files,
                                const std::stop_token& stop,
                                const std::function<void(double)>& progress) {
  require_order(order);
  require_items(shard, static_cast<std::size_t>(order.runs), "runs");
  make_folder(files);
  TableShard part{.identity = {divided(order), shard}, .heading = study_columns()};
  const std::filesystem::path file = shard_path(files.studies(), shard);
  if (files.overwrite == Overwrite::refuse && is_stored(file, part.identity)) {
    return PowerShard::stored_before;
  }
  const auto runs = static_cast<std::int64_t>(shard.number_of(part.identity.whole.results));
  const StudyRange range{.last = runs * studies_per_run(order), .shard = shard};
  const StudyReceiver receiver{
      .add = [&](const StudyPlace& place, std::span<const SimulatedOutcome> outcomes) {
        part.lines[static_cast<std::size_t>(place.run)] += rows_of(order, place, outcomes);
      }};
  if (simulate_studies(order, simulate, range, jobs, receiver, stop, progress) < range.last) {
    return PowerShard::stopped;
  }
  store(file, part, files.overwrite);
  return PowerShard::simulated;
}

}  // namespace asperity
