// The response tables of the kinds in which one of several surfaces is chosen: selection and paired comparison.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// A participant chooses the surface with the greatest utility
///
///   U = e·p + u + o·[first] + G
///
/// with the log-odds e of a choice of the last item over the first, where items are equally spaced (p from −½ to ½, in the order
/// of TabulatedQuestion::items), or of the declared target over each other item (p is 1 for the target and 0 otherwise; e then differs between the first and
/// the last group of participants by FACTOR.difference); the
/// participant's own u ~ N(0, s²/2) of each item, so that differences between any two items have the standard deviation s; the
/// participant's own log-odds o in favour of the first surface; and standard Gumbel noise G, so that the log-odds of two
/// surfaces are the difference of their U without noise. Of two surfaces, a noisy difference of less than `tie_within` is a tie,
/// where there is this option. A lapse is a random surface; "cannot tell" is never chosen.
const ResponseTable& selection_responses();
const ResponseTable& paired_comparison_responses();

}  // namespace asperity
