// The response table of a rating.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// A rating is the point of the scale next to
///
///   y = m + b + d·p + u + c·[correct or incorrect] + ε
///
/// in the unit of the scale, with its middle m (`level`); the participant's own level b ~ N(0, `level_sd`²); the difference d
/// between the last and the first item, where items are equally spaced (p from −½ to ½, in the order of
/// TabulatedQuestion::items; without several items in the order of the levels of the factors that determine the surface and
/// of the varied parameter, the first factor varying slowest); the participant's own u ~ N(0, s²/2) of each item, so that differences between any two
/// items have the standard deviation s; and noise ε. Of a scale that accompanies a question with correct responses, half of the
/// participant's own c is added for a correct and subtracted for an incorrect response. Each scale has its own deviations.
/// In a lapse every point is equally probable.
const ResponseTable& rating_responses();

}  // namespace asperity
