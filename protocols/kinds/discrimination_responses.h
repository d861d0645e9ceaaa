// The response table of a discrimination.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// The impression of a surface with the value x of the varied parameter is normal with the standard deviation 1 and the mean
///
///   μ(x) = ±(|x − s − v|/θ)^β
///
/// with the standard s, the side of x as the sign, and the participant's own threshold θ, the difference with d′ = 1. ln θ has the
/// standard deviation `threshold_sd` over participants; the ratio of the thresholds of the last and the first level of a factor
/// is FACTOR.ratio (levels equally spaced on the logarithmic scale), and its natural logarithm varies over participants with
/// the standard deviation FACTOR.ratio_sd. v is the participant's own shift of the point of subjective equality, where no
/// response is correct, and 0 otherwise.
///
/// The decisions are those of detection theory (decision_rules.h, forced_choice.h): of two or three surfaces the greatest
/// impression (the smallest, where the levels are below the standard), of an oddity task that farthest from the mean; to each the
/// participant's own `order` in favour of the first surface is added. "Yes" where the impression is above the participant's own
/// criterion, "different" where two of them differ by more than it; "cannot tell", where it is an option, where two differ by less
/// than `unsure_within`. A lapse is a random option other than "cannot tell".
const ResponseTable& discrimination_responses();

}  // namespace asperity
