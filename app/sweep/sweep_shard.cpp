// Numbers the rows by level and spacing, and computes those of one shard.

#include "app/sweep/sweep_shard.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "app/study_files/program.h"

namespace asperity {

namespace {

template <class Numbers>
std::size_t place_in(const Numbers& numbers, double number) {
  return static_cast<std::size_t>(std::find(numbers.begin(), numbers.end(), number) -
                                  numbers.begin());
}

}  // namespace

DividedComputation divided(const SweepOrder& order) {
  return {.command = "sweep",
          .declaration = declaration_of(order),
          .results = order.values.size() * order.spacings_m.size(),
          .program = numerical_identity()};
}

TableShard table_shard(const Sweep& sweep, const Shard& shard) {
  const SweepOrder& order = sweep.order;
  std::vector<std::size_t> numbers{};
  for (const SweepRow& row : sweep.rows) {
    numbers.push_back(place_in(order.values, row.value) * order.spacings_m.size() +
                      place_in(order.spacings_m, row.spacing_m));
  }
  return table_shard({divided(order), shard}, table_of(sweep), numbers);
}

Sweep sweep_into_shard(const SweepOrder& order, const Shard& shard, const SweepFile& file,
                       const std::stop_token& stop, const std::function<void(double)>& progress) {
  const std::filesystem::path out = shard_path(file.out, shard);
  require_folder_of(out);
  if (file.overwrite == Overwrite::refuse && is_stored(out, {divided(order), shard})) {
    return {.order = order, .is_complete = true};
  }
  Sweep sweep = sweep_of_shard(order, shard, file.jobs, stop, progress);
  if (sweep.is_complete) store(out, table_shard(sweep, shard), file.overwrite);
  return sweep;
}

}  // namespace asperity
