// Which items have been compared with which, and whether that is enough for a scale.

#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace asperity {

/// wins(i, j): how often item i was put before item j.
///
/// Whether from every item a chain of wins leads to every other. A finite scale of all items that
/// makes the wins most likely exists if and only if it does [Ford 1957]: otherwise some items never
/// lose to the rest, and the best distance is infinite.
///
/// [Ford 1957] Ford: Solution of a ranking problem from binary comparisons.
bool strongly_connected(const Eigen::MatrixXd& wins);

/// Whether a chain of comparisons, however they went, joins every two items.
bool connected(const Eigen::MatrixXd& wins);

/// What keeps the items from having one finite scale.
enum class ScaleBlocker {
  never_compared,  ///< the items were compared at most among themselves
  never_lose,      ///< they won every comparison with one of the other items
  never_win,       ///< they lost every comparison with one of the other items
};
/// The smallest set of items for which one of these holds, in increasing order; of equally small ones
/// the first in the order of the enumerators, then the one with the lowest item. No items where
/// `strongly_connected`. Where items were never compared, it names them and does not examine wins.
struct BlockedItems {
  ScaleBlocker blocker = ScaleBlocker::never_compared;
  std::vector<std::size_t> items{};
};
BlockedItems blocked_items(const Eigen::MatrixXd& wins);

}  // namespace asperity
