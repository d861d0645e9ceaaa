// Declares the trials of a block before they are ordered.

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/plan/trial_order.h"

namespace asperity {

/// Factor levels of one trial.
using FactorLevels = std::map<std::string, Level, std::less<>>;

/// What distinguishes a trial of a block from the others of one repetition.
struct BlockRow {
  FactorLevels factors{};
  /// With `all_pairs`: the levels of its factor for the first and the second surface; otherwise empty.
  std::vector<Level> pair{};
  /// Of another design than two alternatives: the type of this trial. Null: all listed surfaces are presented, or the type is
  /// drawn for every trial of a track (LevelTracks).
  const DesignTrial* type = nullptr;
  /// The part of the pairs that it belongs to, from 0; nothing for a row that belongs to every part.
  std::optional<std::size_t> part{};
};

/// The types of trials of the block's design; none where all listed surfaces are presented, and while the standard has no
/// value.
std::span<const DesignTrial> trial_types(const Protocol::Block& block);

/// The number of rounds in which all pairs of k levels occur once and no level twice in a round: k − 1 for an even k, k for
/// an odd one. It is the greatest number of parts of the pairs.
std::size_t round_count(std::size_t levels);

/// The combinations of the crossed factors (the last one fastest), or the listed rows, once; one empty combination if
/// there are none. Each of them with every level of the dimension, where the block varies a parameter without a
/// procedure, with every pair, where it has pairs, and as every type of trial of its design, unless a procedure makes the
/// trials. The level of a trial without the varied surface is the value of the standard. Excluded combinations are absent;
/// each row has its derived levels.
std::vector<BlockRow> rows_of(const Protocol& protocol, const Protocol::Block& block);

/// The rows of one part of the pairs (Protocol::Block::AllPairs::parts); all rows where the block has no parts.
std::vector<BlockRow> rows_of_part(const Protocol& protocol, const Protocol::Block& block,
                                   std::size_t part);

/// The number of rows of all parts, built only where combinations are excluded.
std::size_t row_count(const Protocol& protocol, const Protocol::Block& block);

/// Adds the levels that the block computes from those of the row; none whose formula has no finite value.
void add_derived_levels(const Protocol::Block& block, FactorLevels& row);

/// Whether the row has all of these levels.
bool has_levels(const FactorLevels& row, const FactorLevels& levels);

/// One trial of a block before it is ordered.
struct BlockTrial {
  std::size_t row = 0;
  int repetition = 1;
};
/// All trials: every row once, then the rows with a second repetition, and so on.
std::vector<BlockTrial> trials_of(const Protocol::Block& block, const std::vector<BlockRow>& rows);
/// Their number for one participant; where parts of the pairs differ in size, that of the largest part.
std::size_t trial_count(const Protocol& protocol, const Protocol::Block& block);

/// The ordering problem of `trials`, which are those of `rows`. Errors: none; see `random_order`.
OrderProblem order_problem(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                           const std::vector<BlockTrial>& trials);

}  // namespace asperity
