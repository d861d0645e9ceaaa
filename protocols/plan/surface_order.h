// Declares the order of the surfaces in each trial of a block.

#pragma once

#include <cstddef>
#include <vector>

#include "analysis/numbers/random.h"
#include "protocols/design/protocol.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

/// For each trial the indices of its surfaces, as the block lists them, in the order of presentation.
using SurfaceOrders = std::vector<std::vector<std::size_t>>;

/// The order of `surfaces` surfaces in each of `trials` trials. A longer series begins with the shorter one.
SurfaceOrders positions_of(Protocol::Block::Positions how, std::size_t surfaces, std::size_t trials,
                           Random random);

/// Whether the number of trials of every row is a multiple of the number of surfaces.
bool has_multiples_of_surfaces(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                               const std::vector<BlockTrial>& trials);

/// Whether `balanced` positions of `trials`, which are those of `rows`, are balanced within every row, and therefore within
/// every level, and not only over the block: in a choice between surfaces whose levels are neither those of a procedure nor
/// ended early by a criterion, with `has_multiples_of_surfaces`.
bool balances_every_row(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                        const std::vector<BlockTrial>& trials);

/// As `positions_of`, for all trials of a block whose positions are balanced within every row; `trials` in the order of the
/// session.
SurfaceOrders positions_within_rows(const Protocol::Block& block, const std::vector<BlockRow>& rows,
                                    const std::vector<BlockTrial>& trials, const Random& random);

}  // namespace asperity
