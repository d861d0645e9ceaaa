// The file of a shard whose result is rows of a table, and the joining of all shards to the whole table.

#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/shards/divided_computation.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The results of one shard, each of which is one row of the table or several.
///
/// The file (docs/shards.md) is text: a line of JSON that names the computation and the shard, the table with the number of
/// its result in front of each row, and the SHA-256 of all that, which reveals any damage.
struct TableShard {
  ShardIdentity identity{};
  std::string heading{};  ///< the line of column names of the whole table, without its end
  /// The rows of each result, by its number in the whole, from 0; each with its end.
  std::map<std::size_t, std::string> lines{};

  bool operator==(const TableShard&) const = default;
};

/// `table` has the rows of the shard, and `numbers` the number of each one's result in the whole.
TableShard table_shard(ShardIdentity identity, const Table& table,
                       const std::vector<std::size_t>& numbers);

/// The content of the file.
std::string text_of(const TableShard& shard);

/// Reads such a file. Errors: ResultsError for a file that cannot be read; std::runtime_error naming the file where it is no
/// shard, or where its SHA-256 does not hold.
TableShard read_table_shard(const std::filesystem::path& file);

/// Whether the file of this shard exists, so that a repeated command has nothing left to compute.
///
/// Errors: those of `read_table_shard`, and std::runtime_error where the file is of another computation or another shard.
bool is_stored(const std::filesystem::path& file, const ShardIdentity& identity);

/// Writes the file, complete under its name or not at all. The same bytes under this name, from a second process with the same
/// shard, are accepted.
///
/// Errors: std::runtime_error for other bytes under this name (and `refuse`); otherwise as write_file.
void store(const std::filesystem::path& file, const TableShard& shard, Overwrite overwrite);

/// All rows of a divided computation.
struct GatheredTable {
  DividedComputation whole{};
  int shards = 0;
  std::size_t rows = 0;
  std::string table{};  ///< the bytes of the table that the undivided command writes
};

/// Joins the files of all shards, in any order. The same shard twice, with the same bytes, is accepted.
///
/// Errors: those of `read_table_shard`, and std::runtime_error naming the files: of a shard that belongs to another
/// computation, of two files of one shard with other bytes, and the shards that are missing.
GatheredTable gathered(const std::vector<std::filesystem::path>& files);

}  // namespace asperity
