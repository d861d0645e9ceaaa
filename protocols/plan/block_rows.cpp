// Implements crossed and listed rows and the limits on their order.

#include "protocols/plan/block_rows.h"

#include <algorithm>
#include <utility>

namespace asperity {

std::size_t row_count(const Protocol& protocol, const Protocol::Block& block) {
  if (!block.listed.empty()) return block.listed.size();
  constexpr std::size_t kEnough = 1U << 20U;  // prevents overflow of the product of many factors
  std::size_t count = 1;
  for (const std::string& name : block.crossed) {
    count = std::min(count * protocol.factors.at(name).levels.size(), kEnough);
  }
  return count;
}

std::vector<FactorLevels> rows_of(const Protocol& protocol, const Protocol::Block& block) {
  if (!block.listed.empty()) return block.listed;
  std::vector<FactorLevels> rows{{}};
  for (const std::string& name : block.crossed) {
    std::vector<FactorLevels> longer{};
    for (const FactorLevels& row : rows) {
      for (const Level& level : protocol.factors.at(name).levels) {
        longer.push_back(row);
        longer.back()[name] = level;
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

OrderProblem order_problem(const Protocol::Block& block, const std::vector<FactorLevels>& rows) {
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
      const Level& level = rows[trial % rows.size()].find(factor)->second;
      limit.level_of_trial.push_back(numbers.emplace(level, numbers.size()).first->second);
    }
    problem.limits.push_back(std::move(limit));
  }
  return problem;
}

}  // namespace asperity
