// The response tables of the kinds in which pictures are assigned to felt textures: recognition and matching.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// Impressions of how well a felt texture fits the pictures are independent normal numbers with the standard deviation 1, and d′
/// is added to that of the picture of the texture felt. In a recognition the picture with the greatest impression is chosen
/// (ForcedChoice); in a matching the assignment with the greatest sum. d′ is
///
///   d′·exp(s·z + t·y + p·ln r)
///
/// with normal z of the participant and y of the texture, and the ratio r of the sensitivities of the last and the first group of
/// participants (FACTOR.ratio; p is the group's place from −½ to ½): a sensitivity is not negative, and without sensitivity (the null)
/// every participant guesses, whatever the standard deviations s and t are. In a recognition each participant prefers some
/// pictures to others: b ~ N(0, `bias_sd`²) is added to the impression of a picture. A lapse is a random picture or assignment;
/// "cannot tell" is never chosen.
const ResponseTable& recognition_responses();
const ResponseTable& matching_responses();

}  // namespace asperity
