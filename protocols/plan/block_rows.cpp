// Implements crossed and listed rows, pairs, and the limits on their order.

#include "protocols/plan/block_rows.h"

#include <algorithm>
#include <utility>

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
  return rows;
}

/// Each pair in the order of the levels, followed by the other order; one empty pair without pairs.
std::vector<std::vector<Level>> pairs_of(const Protocol& protocol, const Protocol::Block& block) {
  if (!block.all_pairs) return {{}};
  const std::vector<Level>& levels = protocol.factors.at(block.all_pairs->factor).levels;
  std::vector<std::vector<Level>> pairs{};
  for (std::size_t i = 0; i < levels.size(); ++i) {
    for (std::size_t j = i + 1; j < levels.size(); ++j) {
      pairs.push_back({levels[i], levels[j]});
      if (block.all_pairs->in_both_orders) pairs.push_back({levels[j], levels[i]});
    }
  }
  return pairs;
}

}  // namespace

std::size_t row_count(const Protocol& protocol, const Protocol::Block& block) {
  constexpr std::size_t kEnough = 1U << 20U;  // prevents overflow of the product of many factors
  std::size_t count = std::max<std::size_t>(block.listed.size(), 1);
  if (block.all_pairs) {
    const std::size_t levels = protocol.factors.at(block.all_pairs->factor).levels.size();
    count *= levels * (levels - 1) / (block.all_pairs->in_both_orders ? 1 : 2);
  }
  for (const std::string& name : block.crossed) {
    count = std::min(count * protocol.factors.at(name).levels.size(), kEnough);
  }
  if (block.vary && !block.procedure)
    count = std::min(count * block.vary->levels().size(), kEnough);
  return count;
}

std::vector<BlockRow> rows_of(const Protocol& protocol, const Protocol::Block& block) {
  const std::vector<std::vector<Level>> pairs = pairs_of(protocol, block);
  std::vector<BlockRow> rows{};
  for (const FactorLevels& factors : combinations_of(protocol, block)) {
    for (const std::vector<Level>& pair : pairs) rows.push_back({factors, pair});
  }
  return rows;
}

OrderProblem order_problem(const Protocol::Block& block, const std::vector<BlockRow>& rows) {
  OrderProblem problem{};
  problem.trials = rows.size() * static_cast<std::size_t>(block.repetitions);
  problem.group_size = block.order == Protocol::Block::Order::shuffle_within_repetition
                           ? rows.size()
                           : problem.trials;
  for (const auto& [factor, maximum] : block.maximum_in_a_row) {
    RowLimit limit{};
    limit.maximum = static_cast<std::size_t>(maximum);
    std::map<Level, std::size_t> numbers{};
    for (std::size_t trial = 0; trial < problem.trials; ++trial) {
      const Level& level = rows[trial % rows.size()].factors.find(factor)->second;
      limit.level_of_trial.push_back(numbers.emplace(level, numbers.size()).first->second);
    }
    problem.limits.push_back(std::move(limit));
  }
  return problem;
}

}  // namespace asperity
