// The response table of a similarity.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// The rated dissimilarity of two different items, from 0 at the end of the scale for identical surfaces, is the point of the scale
/// next to
///
///   y = m + b + d·g + u + ε
///
/// in the unit of the scale, with the level m and the participant's own b ~ N(0, `level_sd`²); d (`structure`), the mean dissimilarity
/// of the most distant pair minus that of neighbours, where items are equally spaced on one dimension in the order of
/// TabulatedQuestion::items (g is the distance, from −½ for neighbours to ½ for the extremes); the participant's own
/// u ~ N(0, s²/2) of each pair, whatever its order, so that differences between any two pairs have the standard deviation s; and noise
/// ε. Of an identical pair, y = m + b − e + ε with the participant's own e (`identical`) and without structure. A scale that rates
/// similarity is reversed. In a lapse every point is equally probable.
const ResponseTable& similarity_responses();

}  // namespace asperity
