// One part of a computation that is divided among processes.

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace asperity {

/// Part k of N of a computation with numbered items (spacings of a sweep, runs of a power analysis, participants of
/// a simulation).
///
/// Item i, from 0, belongs to shard (i mod N) + 1: every item belongs to exactly one shard, the numbers of items of two shards
/// differ by at most one, and items whose cost rises with their number are spread over the shards. What an item gives is a
/// function of its number and of the whole computation, never of its shard.
///
/// The result of a shard has the name of the whole result with `.shard-K-of-N` appended, so that the commands of all shards
/// differ in `--shard K/N` alone:
///
///     asperity sweep … --out FILE.tsv --shard 3/7       writes FILE.tsv.shard-3-of-7
///     asperity power … --out FOLDER --shard 3/7         writes FOLDER/studies.tsv.shard-3-of-7
///     asperity simulate … --study STUDY --shard 3/7     makes the study STUDY.shard-3-of-7
struct Shard {
  int index = 1;  ///< k, from 1 to `count`
  int count = 1;  ///< N

  bool has(std::size_t item) const noexcept {
    return item % static_cast<std::size_t>(count) == static_cast<std::size_t>(index - 1);
  }
  /// Of so many items, from 0.
  std::size_t number_of(std::size_t items) const noexcept;

  bool operator==(const Shard&) const = default;
};

/// The largest N: that of a Slurm job array with the default of MaxArraySize.
inline constexpr int kMostShards = 1000;

/// "3/7"
std::string text_of(const Shard& shard);
/// Reads `text_of`; nothing for another text, and where not 1 ≤ k ≤ N ≤ kMostShards.
std::optional<Shard> shard_in(std::string_view text);

/// FILE.tsv → FILE.tsv.shard-3-of-7. A slash at the end of a folder's name is left out, and "." is
/// replaced by the name of that folder.
std::filesystem::path shard_path(const std::filesystem::path& whole, const Shard& shard);

/// The results that are missing: the names that they have next to `given`, the result of the shard `of_given`, or "shard 2/3"
/// where that was renamed. Empty if none is missing. `present`: the indices of the shards that are there.
std::string missing_shards(const std::set<int>& present, const Shard& of_given,
                           const std::filesystem::path& given);

/// Refuses a division into more shards than there are items, some of which would be empty. `items`: in words, such as
/// "spacings".
///
/// Errors: std::invalid_argument naming both numbers.
void require_items(const Shard& shard, std::size_t number, const std::string& items);

}  // namespace asperity
