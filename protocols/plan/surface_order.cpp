// Implements the order of the surfaces in each trial of a block.

#include "protocols/plan/surface_order.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "protocols/design/block_factors.h"
#include "protocols/kinds/kind_list.h"
#include "protocols/plan/squares.h"

namespace asperity {

using Block = Protocol::Block;

namespace {

std::vector<std::size_t> trials_per_row(std::size_t rows, const std::vector<BlockTrial>& trials) {
  std::vector<std::size_t> counts(rows);
  for (const BlockTrial& trial : trials) ++counts[trial.row];
  return counts;
}

}  // namespace

SurfaceOrders positions_of(Block::Positions how, std::size_t surfaces, std::size_t trials,
                           Random random) {
  SurfaceOrders orders{};
  std::vector<std::size_t> listed(surfaces);
  for (std::size_t i = 0; i < surfaces; ++i) listed[i] = i;
  switch (how) {
    case Block::Positions::as_listed:
      orders.assign(trials, listed);
      break;
    case Block::Positions::shuffle:
      for (std::size_t trial = 0; trial < trials; ++trial) {
        orders.push_back(listed);
        random.shuffle(std::span<std::size_t>(orders.back()));
      }
      break;
    case Block::Positions::balanced: {
      // Complete Latin squares follow each other, each shuffled separately. The two halves of an odd Williams square
      // alternate, so that orders are balanced too as far as possible.
      const Square williams = williams_square(surfaces);
      const std::size_t halves = williams.size() / surfaces;
      std::size_t half = static_cast<std::size_t>(random.below(halves));
      while (orders.size() < trials) {
        Square rows(williams.begin() + static_cast<std::ptrdiff_t>(half * surfaces),
                    williams.begin() + static_cast<std::ptrdiff_t>((half + 1) * surfaces));
        random.shuffle(std::span<std::vector<std::size_t>>(rows));
        const std::size_t wanted = std::min(rows.size(), trials - orders.size());
        orders.insert(orders.end(), rows.begin(),
                      rows.begin() + static_cast<std::ptrdiff_t>(wanted));
        half = (half + 1) % halves;
      }
      break;
    }
  }
  return orders;
}

bool has_multiples_of_surfaces(const Block& block, const std::vector<BlockRow>& rows,
                               const std::vector<BlockTrial>& trials) {
  const std::size_t surfaces = surfaces_in_trial(block);
  const std::vector<std::size_t> counts = trials_per_row(rows.size(), trials);
  return std::all_of(counts.begin(), counts.end(),
                     [surfaces](std::size_t count) { return count % surfaces == 0; });
}

bool balances_every_row(const Block& block, const std::vector<BlockRow>& rows,
                        const std::vector<BlockTrial>& trials) {
  return block.kind == discrimination_kind().id && block.vary && !block.procedure && !block.until &&
         block.positions == Block::Positions::balanced && !block.design()->has_noise() &&
         has_multiples_of_surfaces(block, rows, trials);
}

SurfaceOrders positions_within_rows(const Block& block, const std::vector<BlockRow>& rows,
                                    const std::vector<BlockTrial>& trials, const Random& random) {
  std::vector<SurfaceOrders> of_row{};
  for (const std::size_t count : trials_per_row(rows.size(), trials)) {
    of_row.push_back(positions_of(block.positions, surfaces_in_trial(block), count,
                                  random.split(static_cast<std::uint64_t>(of_row.size()))));
  }
  std::vector<std::size_t> used(rows.size());
  SurfaceOrders orders{};
  for (const BlockTrial& trial : trials) {
    orders.push_back(of_row[trial.row][used[trial.row]++]);
  }
  return orders;
}

}  // namespace asperity
