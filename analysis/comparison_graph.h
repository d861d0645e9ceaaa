// Which items have been compared with which, and whether that is enough for a scale.

#pragma once

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

}  // namespace asperity
