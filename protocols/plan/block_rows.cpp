// Implements crossed and listed rows, their levels and repetitions, pairs, and the constraints on their order.

#include "protocols/plan/block_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "analysis/numbers/rounded_text.h"
#include "protocols/design/arithmetic.h"

namespace asperity {

namespace {

/// Every row with every level of a further factor.
std::vector<FactorLevels> crossed_with(const std::vector<FactorLevels>& rows,
                                       const std::string& factor,
                                       const std::vector<Level>& levels) {
  std::vector<FactorLevels> longer{};
  for (const FactorLevels& row : rows) {
    for (const Level& level : levels) {
      longer.push_back(row);
      longer.back()[factor] = level;
    }
  }
  return longer;
}

/// 12 significant digits, so that 3 · 0.1 is the level 0.3. Nothing where a level is a name or absent, and where the
/// value is not finite; the check of meaning refuses these.
std::optional<double> derived_level(const FactorLevels& row, const std::string& formula) {
  const auto parsed = Arithmetic::parse(formula);
  const auto* const arithmetic = std::get_if<Arithmetic>(&parsed);
  if (arithmetic == nullptr) return {};
  const double value = arithmetic->value([&row](const std::string& name) {
    const auto level = row.find(name);
    const double* const number = level == row.end() ? nullptr : std::get_if<double>(&level->second);
    return number == nullptr ? std::numeric_limits<double>::quiet_NaN() : *number;
  });
  if (!std::isfinite(value)) return {};
  return without_rounding_errors(value);
}

std::vector<FactorLevels> combinations_of(const Protocol& protocol, const Protocol::Block& block) {
  std::vector<FactorLevels> rows = block.listed;
  if (rows.empty()) rows.emplace_back();
  for (const std::string& name : block.crossed) {
    rows = crossed_with(rows, name, protocol.factors.at(name).levels);
  }
  if (block.vary && !block.procedure) {
    const std::vector<double> values = block.vary->values();
    rows = crossed_with(rows, block.vary->factor, {values.begin(), values.end()});
  }
  std::erase_if(rows, [&block](const FactorLevels& row) {
    return std::any_of(block.exclude.begin(), block.exclude.end(),
                       [&row](const FactorLevels& levels) { return has_levels(row, levels); });
  });
  for (FactorLevels& row : rows) add_derived_levels(block, row);
  return rows;
}

/// The round of the pair i < j of k levels, by the circle method. With n rounds (n odd), the levels 0 … n − 1 meet in the
/// round (i + j) mod n. As i and the round determine j, no level occurs twice in a round; the level with 2·i = round (mod n)
/// is left over, and meets the level n where k is even.
std::size_t round_of(std::size_t i, std::size_t j, std::size_t levels) {
  const std::size_t rounds = round_count(levels);
  return j == rounds ? 2 * i % rounds : (i + j) % rounds;
}

/// A part is a sequence of rounds, so that its levels occur equally often; for an odd number of levels, one is absent from
/// each round. The sizes of parts differ by at most one round, and the first one is the largest.
///
/// Two successive rounds r and r + 1 connect all levels: i meets r − i, which meets (r + 1) − (r − i) = i + 1. A participant
/// with a part of at least two rounds therefore relates every level to every other one, directly or through others. Rounds at
/// a distance that divides n would not do so.
std::size_t part_of_round(std::size_t round, std::size_t rounds, std::size_t parts) {
  return round * parts / rounds;
}

/// A pair of levels, and its part.
struct PlacedPair {
  std::vector<Level> levels{};
  std::optional<std::size_t> part{};
};

/// Each pair in the order of the levels, followed by the other order, and before those of a level this level with itself,
/// which belongs to every part; one empty pair without pairs.
std::vector<PlacedPair> pairs_of(const Protocol& protocol, const Protocol::Block& block) {
  if (!block.all_pairs) return {PlacedPair{}};
  const std::vector<Level>& levels = protocol.factors.at(block.all_pairs->factor).levels;
  const std::size_t rounds = round_count(levels.size());
  const auto parts = static_cast<std::size_t>(std::max(block.all_pairs->parts, 1));
  std::vector<PlacedPair> pairs{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (block.all_pairs->with_identical) pairs.push_back({{levels[i], levels[i]}, {}});
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      const std::size_t part = part_of_round(round_of(i, j, levels.size()), rounds, parts);
      pairs.push_back({{levels[i], levels[j]}, part});
      if (block.all_pairs->in_both_orders) pairs.push_back({{levels[j], levels[i]}, part});
    }
  }
  return pairs;
}

/// Of the first entry that the row matches, or that of the block.
int repetitions_of(const Protocol::Block& block, const BlockRow& row) {
  for (const Protocol::Block::RowRepetitions& each : block.repetitions_of) {
    if (has_levels(row.factors, each.levels)) return each.repetitions;
  }
  return block.repetitions;
}

/// The types of the rows; one null type where there are none, and where the trials of a track have several types.
std::vector<const DesignTrial*> types_of(const Protocol::Block& block) {
  const std::span<const DesignTrial> trials = trial_types(block);
  if (trials.empty() || (block.procedure && trials.size() > 1)) return {nullptr};
  std::vector<const DesignTrial*> types{};
  for (const DesignTrial& trial : trials) types.push_back(&trial);
  return types;
}

BlockRow row_of_type(const Protocol::Block& block, BlockRow row, const DesignTrial* type) {
  row.type = type;
  if (type != nullptr && !type->presents(block.vary->role)) {
    row.factors[block.vary->factor] = *block.vary->standard;
    add_derived_levels(block, row.factors);
  }
  return row;
}

}  // namespace

std::span<const DesignTrial> trial_types(const Protocol::Block& block) {
  if (block.design() == &two_alternatives() || !block.vary || !block.vary->standard) return {};
  return block.design()->trials;
}

std::size_t round_count(std::size_t levels) { return levels % 2 == 0 ? levels - 1 : levels; }

void add_derived_levels(const Protocol::Block& block, FactorLevels& row) {
  for (const auto& [name, formula] : block.derived) {
    if (const auto level = derived_level(row, formula)) row[name] = *level;
  }
}

bool has_levels(const FactorLevels& row, const FactorLevels& levels) {
  return std::all_of(levels.begin(), levels.end(), [&row](const auto& stated) {
    const auto own = row.find(stated.first);
    return own != row.end() && own->second == stated.second;
  });
}

std::size_t row_count(const Protocol& protocol, const Protocol::Block& block) {
  constexpr std::size_t kEnough = 1U << 20U;  // prevents overflow of the product of many factors
  std::size_t count = std::max<std::size_t>(block.listed.size(), 1);
  if (block.all_pairs) {
    const std::size_t levels = protocol.factors.at(block.all_pairs->factor).levels.size();
    const std::size_t identical = block.all_pairs->with_identical ? levels : 0;
    count *= levels * (levels - 1) / (block.all_pairs->in_both_orders ? 1 : 2) + identical;
  }
  count *= types_of(block).size();
  for (const std::string& name : block.crossed) {
    count = std::min(count * protocol.factors.at(name).levels.size(), kEnough);
  }
  if (block.vary && !block.procedure)
    count = std::min(count * block.vary->levels().size(), kEnough);
  // So many rows are refused in any case, and are not built.
  constexpr std::size_t kMostRowsToExclude = 1U << 16U;
  if (block.exclude.empty() || count > kMostRowsToExclude) return count;
  return rows_of(protocol, block).size();
}

std::vector<BlockTrial> trials_of(const Protocol::Block& block, const std::vector<BlockRow>& rows) {
  int most = block.repetitions;
  for (const Protocol::Block::RowRepetitions& each : block.repetitions_of) {
    most = std::max(most, each.repetitions);
  }
  std::vector<BlockTrial> trials{};
  for (int repetition = 1; repetition <= most; ++repetition) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (repetition <= repetitions_of(block, rows[row])) trials.push_back({row, repetition});
    }
  }
  return trials;
}

std::size_t trial_count(const Protocol& protocol, const Protocol::Block& block) {
  const std::size_t of_all =
      row_count(protocol, block) * static_cast<std::size_t>(block.repetitions);
  constexpr std::size_t kMostRowsToCount = 1U << 16U;
  const bool has_equal_trials =
      block.repetitions_of.empty() && (!block.all_pairs || block.all_pairs->parts == 1);
  if (has_equal_trials || row_count(protocol, block) > kMostRowsToCount) return of_all;
  std::size_t count = 0;
  for (const BlockRow& row : rows_of_part(protocol, block, 0)) {
    count += static_cast<std::size_t>(repetitions_of(block, row));
  }
  return count;
}

std::vector<BlockRow> rows_of(const Protocol& protocol, const Protocol::Block& block) {
  const std::vector<PlacedPair> pairs = pairs_of(protocol, block);
  std::vector<BlockRow> rows{};
  for (const FactorLevels& factors : combinations_of(protocol, block)) {
    for (const PlacedPair& pair : pairs) {
      for (const DesignTrial* const type : types_of(block)) {
        rows.push_back(
            row_of_type(block, {.factors = factors, .pair = pair.levels, .part = pair.part}, type));
      }
    }
  }
  return rows;
}

std::vector<BlockRow> rows_of_part(const Protocol& protocol, const Protocol::Block& block,
                                   std::size_t part) {
  std::vector<BlockRow> rows = rows_of(protocol, block);
  std::erase_if(rows, [part](const BlockRow& row) { return row.part.value_or(part) != part; });
  return rows;
}

OrderProblem order_problem(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                           const std::vector<BlockTrial>& trials) {
  OrderProblem problem{};
  problem.trials = trials.size();
  problem.group_size = block.order == Protocol::Block::Order::shuffle_within_repetition
                           ? rows.size()
                           : problem.trials;
  const auto levels_of_trials = [&](const std::string& factor) {
    std::map<Level, std::size_t> numbers{};
    std::vector<std::size_t> levels{};
    for (const BlockTrial& trial : trials) {
      const Level& level = rows[trial.row].factors.find(factor)->second;
      levels.push_back(numbers.emplace(level, numbers.size()).first->second);
    }
    return levels;
  };
  for (const auto& [factor, maximum] : block.maximum_in_a_row) {
    problem.limits.push_back({levels_of_trials(factor), static_cast<std::size_t>(maximum)});
  }
  for (const auto& [factor, minimum] : block.minimum_distance) {
    problem.distances.push_back({levels_of_trials(factor), static_cast<std::size_t>(minimum)});
  }
  for (const Protocol::Block::FixedPosition& fixed : block.fixed_positions) {
    FixedPlace place{.position = static_cast<std::size_t>(fixed.position) - 1};
    for (const BlockTrial& trial : trials) {
      place.allows_trial.push_back(has_levels(rows[trial.row].factors, fixed.levels));
    }
    problem.places.push_back(std::move(place));
  }
  return problem;
}

}  // namespace asperity
